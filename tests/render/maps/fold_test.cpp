#include "common/math/sampling.h"
#include "common/rays/surface_point.h"
#include "render/maps/fixed_radius.h"
#include "tests/support/hard_surfaces.h"
#include "tests/support/statistics.h"
#include "tests/support/tiny_scenes.h"

#include <catch2/catch.hpp>

#include <functional>

using namespace hipmap;

namespace {

constexpr float kGap = 0.02f;

/// A surface that is one shared map.
struct LitSurface {
    std::unique_ptr<tiny::ReadyScene> ready;
    const TriangleMesh& mesh = ready->scene.mesh;
    MapSurfaces surfaces{mesh, ready->partition};
    EstimateScratch scratch;

    explicit LitSurface(const TriangleMesh& shape) : ready(tiny::ready(tiny::make_scene(shape))) {}

    /// Irradiance 1 on the faces that `lit` accepts, on the side of their fronts.
    PhotonMaps light(const std::function<bool(FaceId)>& lit) const
    {
        constexpr std::uint64_t kOfFace = 40;
        std::vector<Photon> photons;
        for (FaceId face = 0; face < mesh.face_count(); ++face)
            for (std::uint64_t i = 0; i < kOfFace && lit(face); ++i) {
                RandomSequence random(1, RandomStream::photons, face, i);
                const SurfacePoint at = surface_point(mesh, face, sample_triangle(random.next2()));
                const auto power = static_cast<float>(face_area(mesh, face) / kOfFace);
                photons.push_back({at.position, Rgb(power), at.geometric_normal, face, 0});
            }
        return build_photon_maps(photons, ready->partition, {50});
    }
};

/// A sheet folded back on itself.
struct FoldedSheet : LitSurface {
    FoldedSheet() : LitSurface(tiny::hairpin(8, kGap)) {}

    bool is_lower(FaceId face) const { return mesh.positions[mesh.corners[face].x].z < kGap / 2; }
    /// Queries in the middle of the lower leaf, far from the ends of the sheet and from the fold.
    std::vector<PhotonQuery> queries() const
    {
        std::vector<PhotonQuery> out;
        for (FaceId face = 0; face < mesh.face_count(); ++face) {
            const SurfacePoint at = surface_point(mesh, face, glm::vec2(1.0f / 3));
            const glm::vec2 off(at.position.x - 0.5f, at.position.y - 0.5f);
            if (at.position.z == 0 && glm::length(off) < 0.2f)
                out.push_back({at.position, surfaces.normals[face], face, 0});
        }
        return out;
    }
};

const std::array<float, 3> kRadii{0.25f, 0.2f, 0.1f};

} // namespace

TEST_CASE("fold: photons on the far leaf of a folded sheet do not count", "[maps]")
{
    FoldedSheet sheet;
    const std::vector<PhotonQuery> queries = sheet.queries();
    REQUIRE(queries.size() > 8);
    const PhotonMaps far = sheet.light([&](FaceId face) { return !sheet.is_lower(face); });
    REQUIRE(far.maps.size() == 1);
    for (PhotonQuery query : queries) {
        CHECK(estimate_within(far, sheet.surfaces, query, kRadii, sheet.scratch).photons == 0);
        query.radius = kRadii[0];
        CHECK(estimate_irradiance(far, sheet.surfaces, query, sheet.scratch) == Rgb(0));
    }
}

TEST_CASE("fold: a folded sheet in even light has the irradiance of one leaf", "[maps]")
{
    FoldedSheet sheet;
    const PhotonMaps maps = sheet.light([](FaceId) { return true; });
    RunningMean nearest, limited;
    std::array<RunningMean, 3> within;
    for (PhotonQuery query : sheet.queries()) {
        const RadiusEstimates found =
            estimate_within(maps, sheet.surfaces, query, kRadii, sheet.scratch);
        for (std::size_t r = 0; r < within.size(); ++r)
            within[r].add(found.irradiance[r].x);
        nearest.add(estimate_irradiance(maps, sheet.surfaces, query, sheet.scratch).x);
        query.radius = 0.04f; // fewer than k
        limited.add(estimate_irradiance(maps, sheet.surfaces, query, sheet.scratch).x);
    }
    for (const RunningMean& mean : {within[0], within[1], within[2], nearest, limited})
        CHECK(mean.mean() == Approx(1).epsilon(0.1)); // both leaves: 2
}

TEST_CASE("fold: few photons are spread over the whole map, whatever leaf they are on", "[maps]")
{
    FoldedSheet sheet;
    const FaceId lit = sheet.queries().front().face;
    const PhotonMaps maps = sheet.light([&](FaceId face) { return face == lit; });
    const float power = static_cast<float>(face_area(sheet.mesh, lit));
    for (const PhotonQuery& query : sheet.queries())
        CHECK(estimate_irradiance(maps, sheet.surfaces, query, sheet.scratch).x ==
              Approx(power / sheet.surfaces.area_at(lit)).epsilon(0.01));
}

TEST_CASE("fold: a ball in even light has its irradiance within radii beyond its size", "[maps]")
{
    LitSurface ball(tiny::uv_sphere(24, 13));
    REQUIRE(ball.ready->partition.map_count == 1);
    const PhotonMaps maps = ball.light([](FaceId) { return true; });
    for (const float widest : {0.5f, 1.5f, 4.0f}) {
        RunningMean within;
        for (FaceId face = 0; face < ball.mesh.face_count(); ++face) {
            const SurfacePoint at = surface_point(ball.mesh, face, glm::vec2(1.0f / 3));
            const PhotonQuery query{at.position, ball.surfaces.normals[face], face, 0};
            for (const Rgb& found :
                 estimate_within(maps, ball.surfaces, query, {widest, 0.9f * widest, 0.8f * widest},
                                 ball.scratch)
                     .irradiance)
                within.add(found.x);
        }
        INFO("radius " << widest);
        CHECK(within.mean() == Approx(1).epsilon(0.03));
    }
}
