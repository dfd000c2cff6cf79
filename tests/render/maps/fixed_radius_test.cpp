#include "common/math/sampling.h"
#include "common/rays/surface_point.h"
#include "render/maps/fixed_radius.h"
#include "tests/support/hard_surfaces.h"
#include "tests/support/tiny_scenes.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <functional>
#include <numbers>

using namespace hipmap;

namespace {

using Radii = std::array<float, 3>;

/// Flat, curved, slit, folded and cornered surfaces.
const std::vector<std::function<TriangleMesh(std::uint64_t)>> kSurfaces{
    [](std::uint64_t) { return tiny::quad(); },
    [](std::uint64_t) { return tiny::cube(); },
    [](std::uint64_t seed) { return tiny::slit_floor(3, 0.01f * float(1 + seed % 7)); },
    [](std::uint64_t seed) { return tiny::hairpin(3, 0.02f * float(1 + seed % 5)); },
    [](std::uint64_t) { return tiny::uv_sphere(12, 8); },
};

std::vector<Photon> scatter_photons(const TriangleMesh& mesh, std::size_t count, std::uint64_t seed)
{
    std::vector<Photon> photons;
    for (std::size_t i = 0; i < count; ++i) {
        RandomSequence random(seed, RandomStream::photons, 0, i);
        const auto face =
            static_cast<FaceId>(random.next() * static_cast<float>(mesh.face_count()));
        const SurfacePoint at = surface_point(mesh, face, sample_triangle(random.next2()));
        const bool front = random.next() < 0.7f;
        const glm::vec3 direction =
            glm::normalize(at.geometric_normal + 0.9f * sample_sphere(random.next2()));
        photons.push_back({at.position, Rgb(random.next(), random.next(), 1),
                           front ? direction : -direction, face,
                           static_cast<std::uint8_t>(front ? 0 : 1)});
    }
    return photons;
}

float distance_to_segment(const glm::vec3& point, const BoundarySegment& s)
{
    const glm::vec3 d = s.b - s.a;
    const float t = glm::dot(point - s.a, d) / glm::dot(d, d);
    return glm::distance(point, s.a + glm::clamp(t, 0.0f, 1.0f) * d);
}

/// As docs/photon_maps.md says, over all photons.
struct ByHand {
    const MapOptions& options;
    const MapSurfaces& surfaces;
    const std::vector<Photon>& photons;

    bool clipped() const { return options.estimate == EstimateForm::clipped; }
    bool bounded() const { return clipped() && options.mode != MapMode::global; }
    MapId map(FaceId face) const { return surfaces.partition.map_of_face[face]; }

    bool counts(const Photon& photon, const PhotonQuery& query) const
    {
        const bool facing = glm::dot(photon.direction, query.normal) > 0;
        if (options.mode == MapMode::global)
            return facing;
        return map(photon.face) == map(query.face) &&
               (clipped() ? photon.side == query.side : facing);
    }

    RadiusEstimates estimate(const PhotonQuery& query, const Radii& radii) const
    {
        std::vector<BoundarySegment> near;
        if (bounded())
            for (const BoundarySegment& s : surfaces.boundaries.of(map(query.face)))
                if (distance_to_segment(query.position, s) <= radii[0])
                    near.push_back(s);
        VisibleDisc disc;
        const glm::uvec3 c = surfaces.mesh.corners[query.face];
        const auto& p = surfaces.mesh.positions;
        disc.look({{p[c.x], p[c.y], p[c.z]}, query.position, radii[0]}, near);
        RadiusEstimates out{};
        for (const Photon& photon : photons) {
            const float distance = glm::distance(photon.position, query.position);
            if (!counts(photon, query) || distance > radii[0] || !disc.sees(photon.position))
                continue;
            ++out.photons;
            float cosine = 1;
            if (!near.empty())
                cosine = std::max(
                    0.0f, glm::dot(surfaces.normals[photon.face], surfaces.normals[query.face]));
            for (std::size_t r = 0; r < radii.size(); ++r)
                if (distance <= radii[r])
                    out.irradiance[r] += photon.power * cosine / float(disc.area(radii[r]));
        }
        return out;
    }
};

bool close(const Rgb& a, const Rgb& b)
{
    return glm::all(glm::lessThanEqual(glm::abs(a - b), Rgb(1e-4f * (1 + max_channel(b)))));
}

} // namespace

TEST_CASE("fixed radius: every mode gives what its definition says", "[maps]")
{
    std::size_t cases = 0, cut = 0;
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        const auto ready = tiny::ready(tiny::make_scene(kSurfaces[seed % kSurfaces.size()](seed)));
        const TriangleMesh& mesh = ready->scene.mesh;
        const MapSurfaces surfaces(mesh, ready->partition);
        const std::vector<Photon> photons = scatter_photons(mesh, 500, seed);
        for (const MapMode mode :
             {MapMode::global, MapMode::shared, MapMode::thesis, MapMode::hierarchical})
            for (const EstimateForm form : {EstimateForm::clipped, EstimateForm::thesis}) {
                const MapOptions options{mode, 50, 50, form};
                const PhotonMaps maps = build_photon_maps(photons, mesh, ready->partition, options);
                const ByHand by_hand{options, surfaces, photons};
                EstimateScratch scratch;
                for (std::uint64_t i = 0; i < 25; ++i) {
                    RandomSequence random(seed, RandomStream::eye_paths, 0, i);
                    const auto face =
                        static_cast<FaceId>(random.next() * static_cast<float>(mesh.face_count()));
                    const SurfacePoint at =
                        surface_point(mesh, face, sample_triangle(random.next2()));
                    const PhotonQuery query{at.position, at.geometric_normal, face, 0};
                    const float r = 0.5f * random.next();
                    const float r1 = r * random.next();
                    const Radii radii{r, r1, i % 5 == 0 ? 0 : r1 * random.next()};
                    const RadiusEstimates found =
                        estimate_within(maps, surfaces, query, radii, scratch);
                    const RadiusEstimates truth = by_hand.estimate(query, radii);
                    INFO("seed " << seed << ", mode " << int(mode) << ", query " << i);
                    CHECK(found.photons == truth.photons);
                    for (std::size_t j = 0; j < radii.size(); ++j)
                        CHECK(close(found.irradiance[j], truth.irradiance[j]));
                    cut += scratch.segments.empty() ? 0 : 1;
                    ++cases;
                }
            }
    }
    WARN(cases << " estimates by brute force, " << cut << " of them near a boundary");
    CHECK(cut > 1000);
    CHECK(cut < 3000);
}

TEST_CASE("fixed radius: nothing there, nothing found", "[maps]")
{
    const auto ready = tiny::ready(tiny::make_scene(tiny::quad()));
    const MapSurfaces surfaces(ready->scene.mesh, ready->partition);
    const std::vector<Photon> photons(20, Photon{{0.5f, 0.25f, 0}, Rgb(1), {0, 0, 1}, 0, 0});
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EstimateScratch scratch;
    for (const MapMode mode : {MapMode::none, MapMode::shared}) {
        const PhotonMaps maps =
            build_photon_maps(mode == MapMode::none ? std::vector<Photon>() : photons,
                              ready->scene.mesh, ready->partition, {mode, 50, 500});
        for (const glm::vec3& at : {glm::vec3(0.9f, 0.1f, 0), glm::vec3(nan)}) {
            const RadiusEstimates none =
                estimate_within(maps, surfaces, {at, {0, 0, 1}, 0, 0}, {0.1f, 0.1f, 0}, scratch);
            CHECK(none.photons == 0);
            CHECK(none.irradiance[0] == Rgb(0));
        }
        const PhotonQuery there{{0.5f, 0.25f, 0}, {0, 0, 1}, 0, 0};
        CHECK(estimate_within(maps, surfaces, there, {0, 0, 0}, scratch).irradiance[0] == Rgb(0));
    }
}
