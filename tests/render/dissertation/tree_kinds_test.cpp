#include "common/math/sampling.h"
#include "common/rays/surface_point.h"
#include "preprocess/partition/build_partition.h"
#include "render/dissertation/level_search.h"
#include "tests/support/hard_surfaces.h"
#include "tests/support/tiny_scenes.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

struct Surface {
    TriangleMesh mesh;
    Partition partition;
    std::vector<Photon> photons;
};

/// A point of a random face, seen from a random side; the side is not the photon's direction's.
Photon random_photon(const TriangleMesh& mesh, RandomSequence& random)
{
    const auto face = static_cast<FaceId>(random.next() * static_cast<float>(mesh.face_count()));
    const SurfacePoint at = surface_point(mesh, face, sample_triangle(random.next2()));
    const bool front = random.next() < 0.7f;
    const glm::vec3 tilted = at.geometric_normal + 0.5f * sample_sphere(random.next2());
    return {at.position, Rgb(1), glm::normalize(front ? tilted : -tilted), face,
            static_cast<std::uint8_t>(front ? 0 : 1)};
}

Surface make_surface(TriangleMesh mesh, std::size_t count)
{
    Surface out{mesh, build_partition(tiny::make_scene(mesh), {}).partition, {}};
    for (std::size_t i = 0; i < count; ++i) {
        RandomSequence random(7, RandomStream::photons, 0, i);
        const Photon photon = random_photon(out.mesh, random);
        if (out.partition.map_of_face[photon.face] != kNone)
            out.photons.push_back(photon);
    }
    return out;
}

/// Square distances of what was found, nearest first: what tells sets of photons apart.
std::vector<float> distances(const PhotonQuery& query, const FoundPhotons& found)
{
    std::vector<float> out;
    for (const std::uint32_t slot : found.slots) {
        const glm::vec3 d = found.map->tree.position(slot) - query.position;
        out.push_back(glm::dot(d, d));
    }
    if (!out.empty())
        CHECK(out.back() == found.farthest2);
    std::sort(out.begin(), out.end());
    return out;
}

struct Compared {
    int searches = 0;
    std::uint64_t answered_below = 0; ///< of mode hierarchical, in a local or group map
};

void compare_kinds(const Surface& surface, std::uint32_t k, DissertationOptions options,
                   Compared& compared)
{
    const MapSurfaces surfaces(surface.mesh, surface.partition);
    const DissertationMaps wide = build_dissertation_maps(surface.photons, surfaces, {k}, options);
    for (const TreeKind kind : {TreeKind::balanced, TreeKind::unbalanced, TreeKind::midpoint}) {
        options.tree = kind;
        const DissertationMaps maps =
            build_dissertation_maps(surface.photons, surfaces, {k}, options);
        SearchScratch wide_scratch, scratch;
        DissertationScratch wide_below, below;
        for (std::uint64_t i = 0; i < 100; ++i) {
            RandomSequence random(8, RandomStream::eye_paths, 0, i);
            const Photon at = random_photon(surface.mesh, random);
            PhotonQuery query{at.position, at.direction, at.face, at.side};
            if (i % 4 == 0)
                query.radius = 0.1f;
            const auto find = [&](const DissertationMaps& in, const LevelScratch& with) {
                return distances(query, find_photons(in, surfaces, query, with));
            };
            CHECK(find(maps, {scratch, below}) == find(wide, {wide_scratch, wide_below}));
            ++compared.searches;
        }
        const LevelStatistics& done = below.levels;
        CHECK(scratch.statistics.photons_found == wide_scratch.statistics.photons_found);
        if (options.mode == MapMode::thesis)
            CHECK(done.local.abandoned == wide_below.levels.local.abandoned);
        if (options.mode == MapMode::hierarchical)
            for (const LevelSearches& level : {done.local, done.group})
                compared.answered_below += level.begun - level.abandoned;
    }
}

} // namespace

TEST_CASE("tree kinds: every mode finds the same photons in each", "[dissertation]")
{
    const std::array<Surface, 3> surfaces{make_surface(tiny::cube(), 4000),
                                          make_surface(tiny::hairpin(3, 0.1f), 4000),
                                          make_surface(tiny::uv_sphere(12, 7), 8000)};
    Compared compared;
    for (const Surface& surface : surfaces)
        for (const MapMode mode :
             {MapMode::global, MapMode::shared, MapMode::thesis, MapMode::hierarchical})
            for (const EstimateForm form : {EstimateForm::clipped, EstimateForm::thesis})
                for (const std::uint32_t k : {2u, 25u, 400u})
                    compare_kinds(surface, k, {mode, 30, form}, compared);
    CHECK(compared.searches == 3 * 4 * 2 * 3 * 3 * 100);
    CHECK(compared.answered_below > 500);
}
