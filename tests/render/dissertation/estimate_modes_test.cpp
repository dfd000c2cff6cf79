#include "common/math/sampling.h"
#include "common/rays/surface_point.h"
#include "render/dissertation/dissertation_maps.h"
#include "render/maps/gather.h"
#include "tests/support/brute_force.h"
#include "tests/support/hard_surfaces.h"
#include "tests/support/tiny_scenes.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <functional>

using namespace hipmap;

namespace {

/// On the first two of these the thesis' limiting radius is exact.
const std::vector<std::function<TriangleMesh(std::uint64_t)>> kSurfaces{
    [](std::uint64_t) { return tiny::quad(); },
    [](std::uint64_t) { return tiny::cube(); },
    [](std::uint64_t seed) { return tiny::slit_floor(3, 0.01f * float(1 + seed % 7)); },
    [](std::uint64_t seed) { return tiny::hairpin(3, 0.02f * float(1 + seed % 5)); },
    [](std::uint64_t seed) { return tiny::uv_sphere(8 + seed % 9, 8); },
};

SurfacePoint random_point(const TriangleMesh& mesh, RandomSequence& random, FaceId& face)
{
    face = static_cast<FaceId>(random.next() * static_cast<float>(mesh.face_count()));
    return surface_point(mesh, face, sample_triangle(random.next2()));
}

std::vector<Photon> scatter_photons(const TriangleMesh& mesh, std::uint64_t seed)
{
    std::vector<Photon> photons;
    for (std::size_t i = 0; i < 1500; ++i) {
        RandomSequence random(seed, RandomStream::photons, 0, i);
        FaceId face;
        const SurfacePoint at = random_point(mesh, random, face);
        const bool front = random.next() < 0.7f;
        photons.push_back({at.position, Rgb(random.next(), random.next(), 1),
                           front ? at.geometric_normal : -at.geometric_normal, face,
                           static_cast<std::uint8_t>(front ? 0 : 1)});
    }
    return photons;
}

/// docs/photon_maps.md (2) far from any boundary, over all photons.
Rgb estimate_by_hand(const std::vector<Photon>& photons, const DissertationMaps& maps,
                     const MapSurfaces& surfaces, const PhotonQuery& query)
{
    std::vector<glm::vec3> positions;
    for (const Photon& photon : photons)
        positions.push_back(photon.position);
    const auto counts = [&](std::uint32_t i) {
        const Photon& photon = photons[i];
        if (maps.one_map())
            return glm::dot(photon.direction, query.normal) > 0;
        const auto& map = surfaces.partition.map_of_face;
        const auto& normal = surfaces.normals;
        return photon.side == query.side && map[photon.face] == map[query.face] &&
               (photon.face == query.face || glm::dot(normal[photon.face], normal[query.face]) > 0);
    };
    const std::uint32_t k = maps.shared.options.neighbours;
    const auto found = brute_force::k_nearest(positions, query.position, k, query.radius, counts);
    if (found.size() < k)
        return Rgb(-1); // not (2)
    glm::dvec3 sum(0.0);
    for (std::size_t i = 0; i + 1 < found.size(); ++i)
        sum += glm::dvec3(photons[found[i].photon].power);
    const float radius = std::sqrt(found.back().distance2);
    if (maps.one_map() || !surfaces.may_fold(query.face))
        return Rgb(sum / disc_area(radius));
    return Rgb(sum /
               surfaces.facing_areas(query.face, query.position, {&radius, 1}, AreaOf::surface)[0]);
}

bool close(const Rgb& a, const Rgb& b)
{
    return glm::all(glm::lessThanEqual(glm::abs(a - b), Rgb(1e-4f * max_channel(b))));
}

} // namespace

TEST_CASE("estimate: every mode gives what its definition says, with a list and without",
          "[dissertation]")
{
    std::size_t cases = 0, by_hand = 0, near = 0;
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        const auto ready = tiny::ready(tiny::make_scene(kSurfaces[seed % kSurfaces.size()](seed)));
        const TriangleMesh& mesh = ready->scene.mesh;
        const MapSurfaces surfaces(mesh, ready->partition);
        const std::vector<Photon> photons = scatter_photons(mesh, seed);
        for (const MapMode mode :
             {MapMode::global, MapMode::shared, MapMode::thesis, MapMode::hierarchical}) {
            if (mode == MapMode::thesis && seed % kSurfaces.size() > 1)
                continue;
            DissertationOptions asked{mode, 40};
            asked.levels = LevelChoice::all;
            const DissertationMaps maps = build_dissertation_maps(
                photons, surfaces, {2 + static_cast<std::uint32_t>(seed % 4) * 8}, asked);
            ChosenScratch by_sum, by_list;
            for (std::uint64_t i = 0; i < 30; ++i) {
                RandomSequence random(seed, RandomStream::eye_paths, 0, i);
                FaceId face;
                const SurfacePoint at = random_point(mesh, random, face);
                PhotonQuery query{at.position, at.geometric_normal, face, 0};
                if (i % 3 == 0)
                    query.radius = 0.1f;
                by_sum.estimate.near_boundary = false;
                by_list.estimate.near_boundary = true;
                by_sum.estimate.segments.clear();
                const Rgb sum = dissertation::estimate_irradiance(maps, surfaces, query, by_sum);
                CHECK(sum == dissertation::estimate_irradiance(maps, surfaces, query, by_list));
                ++cases;
                const Rgb truth = estimate_by_hand(photons, maps, surfaces, query);
                near += by_sum.estimate.segments.empty() ? 0 : 1;
                if (!by_sum.estimate.segments.empty() || truth == Rgb(-1))
                    continue;
                INFO("seed " << seed << ", mode " << int(mode) << ", query " << i);
                CHECK(close(sum, truth));
                ++by_hand;
            }
        }
    }
    WARN(cases << " estimates, " << by_hand << " of them by brute force, " << near
               << " near a boundary");
    CHECK(by_hand > 1000);
    CHECK(near > 300);
}
