#include "common/math/sampling.h"
#include "common/rays/surface_point.h"
#include "render/dissertation/level_search.h"
#include "tests/support/brute_force.h"
#include "tests/support/hard_surfaces.h"
#include "tests/support/tiny_scenes.h"

#include <catch2/catch.hpp>

#include <array>
#include <iostream>
#include <memory>

using namespace hipmap;

namespace {

/// Flat, curved, slit, folded and thin surfaces, coarse ones for local maps and fine ones for
/// groups, of any size and attitude.
TriangleMesh random_surface(std::uint64_t seed)
{
    RandomSequence random(seed, RandomStream::pictures, 0, 1);
    const auto cells = 1 + static_cast<std::uint32_t>((seed % 2 == 0 ? 3 : 14) * random.next());
    const float gap = 0.2f * std::pow(random.next(), 3.0f) + 1e-5f;
    const std::array<std::function<TriangleMesh()>, 6> makers{
        [&] { return tiny::slit_floor(cells, gap); },
        [&] { return tiny::hairpin(cells, gap); },
        [&] { return tiny::thin_shell(6 + 4 * cells, gap); },
        [&] { return tiny::uv_sphere(6 + 4 * cells, 4 + 2 * cells); },
        [&] { return tiny::notched_fan(9 + 16 * cells, 2 + cells); },
        [&] { return tiny::cube(); },
    };
    const std::size_t kind = seed / 2 % makers.size();
    TriangleMesh mesh = makers[kind]();
    if (random.next() < 0.5f && kind != 5)
        tiny::jitter(mesh, 0.01f * random.next(), seed);
    const float scale = std::exp2(std::round(40 * random.next() - 20));
    tiny::transform(mesh, tiny::random_rotation(seed), scale, glm::vec3(scale * random.next()));
    return mesh;
}

FaceId random_face(const TriangleMesh& mesh, RandomSequence& random)
{
    return static_cast<FaceId>(random.next() * static_cast<float>(mesh.face_count()));
}

std::vector<Photon> scatter_photons(const TriangleMesh& mesh, const Partition& partition,
                                    RandomSequence& random)
{
    const auto count = static_cast<std::size_t>(std::exp2(9 + 6 * random.next()));
    std::vector<Photon> photons;
    while (photons.size() < count) {
        const FaceId face = random_face(mesh, random);
        const SurfacePoint at = surface_point(mesh, face, sample_triangle(random.next2()));
        const auto side = static_cast<std::uint8_t>(random.next() < 0.8f ? 0 : 1);
        if (partition.map_of_face[face] != kNone)
            photons.push_back({at.position, Rgb(1), at.geometric_normal, face, side});
    }
    return photons;
}

/// A surface, its photons, and their maps by two modes.
struct Case {
    TriangleMesh mesh;
    Partition partition;
    std::vector<Photon> photons;
    std::unique_ptr<MapSurfaces> surfaces;
    DissertationMaps shared, levels;

    Case(std::uint64_t seed, RandomSequence& random) : mesh(random_surface(seed))
    {
        const double angle = random.next() < 0.3f ? 0.5 : 3.1;
        partition = build_partition(tiny::make_scene(mesh), {.angle_threshold = angle}).partition;
        photons = scatter_photons(mesh, partition, random);
        surfaces = std::make_unique<MapSurfaces>(mesh, partition);
        const MapOptions in_each{1 + static_cast<std::uint32_t>(12 * random.next())};
        DissertationOptions options;
        options.local_min = static_cast<std::uint32_t>(40 * random.next());
        options.estimate = random.next() < 0.8f ? EstimateForm::clipped : EstimateForm::thesis;
        options.mode = MapMode::shared;
        shared = build_dissertation_maps(photons, *surfaces, in_each, options);
        options.mode = MapMode::hierarchical;
        options.levels = LevelChoice::all;
        levels = build_dissertation_maps(photons, *surfaces, in_each, options);
    }
};

bool same(const FoundPhotons& a, const FoundPhotons& b)
{
    return std::equal(a.slots.begin(), a.slots.end(), b.slots.begin(), b.slots.end()) &&
           a.farthest2 == b.farthest2;
}

bool same_as_brute_force(const Case& c, const PhotonQuery& query, const FoundPhotons& found)
{
    std::vector<glm::vec3> positions;
    for (const Photon& photon : c.photons)
        positions.push_back(photon.position);
    const auto all = brute_force::k_nearest(
        positions, query.position, c.shared.shared.options.neighbours, query.radius,
        [&](std::uint32_t i) {
            const Photon& photon = c.photons[i];
            return (c.shared.sides() == 1 || photon.side == query.side) &&
                   c.partition.map_of_face[photon.face] == c.partition.map_of_face[query.face];
        });
    std::vector<float> distances;
    for (const std::uint32_t slot : found.slots) {
        const glm::vec3 d = found.map->tree.position(slot) - query.position;
        distances.push_back(glm::dot(d, d));
    }
    std::sort(distances.begin(), distances.end());
    return std::equal(distances.begin(), distances.end(), all.begin(), all.end(),
                      [](float a, const Neighbour& b) { return a == b.distance2; });
}

/// Walks of small steps, as an image makes, from anywhere to anywhere.
class Walk {
  public:
    PhotonQuery next(const TriangleMesh& mesh, RandomSequence& random)
    {
        if (random.next() < 0.2f) {
            face_ = random_face(mesh, random);
            place_ = random.next2();
        }
        place_ = glm::clamp(place_ + 0.02f * random.next2(), 0.0f, 1.0f);
        const SurfacePoint at = surface_point(mesh, face_, sample_triangle(place_));
        PhotonQuery query{at.position, at.geometric_normal, face_, 0};
        if (random.next() < 0.2f)
            query.radius = glm::distance(at.position, mesh.positions[mesh.corners[face_].x]);
        return query;
    }

  private:
    FaceId face_ = 0;
    glm::vec2 place_{0.5f};
};

} // namespace

TEST_CASE("find photons: the map levels find what the shared map holds, in its order",
          "[dissertation][property]")
{
    std::size_t cases = 0, wrong = 0;
    LevelStatistics done;
    for (std::uint64_t seed = 0; seed < 700; ++seed) {
        RandomSequence random(seed, RandomStream::eye_paths, 0, 0);
        const Case c(seed, random);
        SearchScratch by_levels, by_shared;
        DissertationScratch below, unused;
        Walk walk;
        for (int i = 0; i < 100; ++i) {
            const PhotonQuery query = walk.next(c.mesh, random);
            const FoundPhotons found =
                find_photons(c.levels, *c.surfaces, query, {by_levels, below});
            const FoundPhotons truth =
                find_photons(c.shared, *c.surfaces, query, {by_shared, unused});
            wrong += !same(found, truth);
            if (i % 25 == 0)
                wrong += !same_as_brute_force(c, query, found);
            ++cases;
        }
        INFO("seed " << seed);
        REQUIRE(wrong == 0);
        done += below.levels;
    }
    std::cerr << "map levels: " << cases << " searches as in the shared map; local "
              << done.local.begun << " begun, " << done.local.abandoned << " abandoned, "
              << done.local.skipped << " skipped; group " << done.group.begun << ", "
              << done.group.abandoned << ", " << done.group.skipped << '\n';
    for (const LevelSearches& level : {done.local, done.group}) {
        CHECK(level.begun > level.abandoned + 1000);
        CHECK(level.abandoned > 10);
        CHECK(level.skipped > 1000);
    }
}

TEST_CASE("lowest_node: holds the photons, no lower one does, and searches begin there",
          "[dissertation]")
{
    std::vector<TreePoint> points;
    for (std::uint32_t i = 0; i < 70'000; ++i) {
        RandomSequence random(3, RandomStream::photons, 0, i);
        points.push_back({glm::vec3(random.next2(), 0), i});
    }
    const WideTree tree = build_wide_tree(points);
    REQUIRE(tree.levels == 4);
    CHECK(lowest_node(tree, 0, 69'999).level == 0);
    CHECK(lowest_node(tree, 69'998, 69'999).level == 3);
    CHECK(lowest_node(tree, 255, 256).level == 2);
    const TreeNode node = lowest_node(tree, 4096, 4096 + 256);
    CHECK(node.level == 2);
    CHECK(first_slot(tree, node) == 4096);
    for (const TreeNode& from : {TreeNode{0, 0}, TreeNode{1, 1}, node, TreeNode{3, 273}}) {
        const std::uint64_t first = first_slot(tree, from), count = photons_below(tree, from);
        CHECK(count == std::min<std::uint64_t>(std::size_t{1 << 20} >> 4 * from.level,
                                               points.size() - first));
        std::vector<TreePoint> below(points.begin() + static_cast<std::ptrdiff_t>(first),
                                     points.begin() + static_cast<std::ptrdiff_t>(first + count));
        const WideTree built = build_wide_tree(below);
        TreeScratch scratch, scratch_built;
        const TreeQuery query{{0.3f, 0.4f, 0}, 40};
        TreeQuery query_below = query;
        query_below.from = from;
        const FoundSlots found = find_nearest(tree, query_below, scratch);
        const FoundSlots truth = find_nearest(built, query, scratch_built);
        CHECK(found.farthest2 == truth.farthest2);
        CHECK(found.slots.size() == truth.slots.size());
    }
}

TEST_CASE("photon maps: hierarchical leaves out the levels that would lose, and says by what",
          "[dissertation]")
{
    const auto ready = tiny::ready(tiny::make_scene(tiny::slit_floor(2, 0.01f)));
    RandomSequence random(5, RandomStream::photons, 0, 0);
    std::vector<Photon> photons;
    for (int i = 0; i < 20; ++i) {
        const auto some = scatter_photons(ready->scene.mesh, ready->partition, random);
        photons.insert(photons.end(), some.begin(), some.end());
    }
    const MapSurfaces surfaces(ready->scene.mesh, ready->partition);
    for (const LevelChoice choice : {LevelChoice::paying, LevelChoice::all}) {
        DissertationOptions options{MapMode::hierarchical, 100};
        options.levels = choice;
        const DissertationMaps maps = build_dissertation_maps(photons, surfaces, {10}, options);
        const LevelPlan& plan = maps.local_level.plan;
        const bool all = choice == LevelChoice::all;
        CHECK(plan.most < plan.asking);
        CHECK(plan.counted == all);
        CHECK((plan.candidates > 0) == all);
        CHECK((plan.answered > 0) == all);
        CHECK((plan.saving < 0) == all);
        CHECK(plan.used == all);
        CHECK(maps.local_level.maps.empty() != all);
        CHECK(maps.group_level.plan.candidates == 0); // too few faces
    }
}
