#include "common/partition/limiting_radius.h"
#include "common/rays/surface_point.h"
#include "preprocess/partition/build_partition.h"
#include "render/dissertation/level_search.h"
#include "tests/support/brute_force.h"
#include "tests/support/hard_surfaces.h"

#include <catch2/catch.hpp>

#include <string>

using namespace hipmap;

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// A mesh, its partition and photons spread over it.
struct Case {
    std::string name;
    TriangleMesh mesh;
    Partition partition;
    std::vector<glm::vec3> photons;
    std::vector<FaceId> face_of_photon;
};

glm::vec3 point_on(const TriangleMesh& mesh, FaceId face, RandomSequence& random)
{
    const float root = std::sqrt(random.next());
    return surface_point(mesh, face, {root * (1 - random.next()), (1 - root)}).position;
}

/// A face, as likely as it is large, or any with equal chance.
FaceId pick_face(const TriangleMesh& mesh, const std::vector<double>& area_up_to,
                 RandomSequence& random)
{
    if (random.next() < 0.3f)
        return static_cast<FaceId>(random.next() * static_cast<float>(mesh.face_count()));
    const double at = random.next() * area_up_to.back();
    return static_cast<FaceId>(std::ranges::upper_bound(area_up_to, at) - area_up_to.begin());
}

Case make_case(std::string name, const TriangleMesh& mesh, double angle_deg, std::uint64_t seed)
{
    Case out{std::move(name), mesh, {}, {}, {}};
    const PartitionOptions options{.angle_threshold = angle_deg * glm::pi<double>() / 180};
    out.partition = build_partition(tiny::make_scene(mesh), options).partition;
    RandomSequence random(seed, RandomStream::photons, 0, 0);
    std::vector<double> area_up_to;
    for (FaceId face = 0; face < mesh.face_count(); ++face)
        area_up_to.push_back((face ? area_up_to.back() : 0) + face_area(mesh, face));
    for (int i = 0; i < 1500; ++i) {
        const FaceId face = pick_face(mesh, area_up_to, random);
        if (out.partition.map_of_face[face] == kNone)
            continue;
        out.photons.push_back(point_on(mesh, face, random));
        out.face_of_photon.push_back(face);
    }
    return out;
}

/// Meshes on which a shared map comes near itself without a connected edge between.
Case random_case(std::uint64_t seed)
{
    RandomSequence random(seed, RandomStream::pictures, 0, 1);
    const auto cells = 1 + static_cast<std::uint32_t>(4 * random.next());
    const float gap = 0.2f * std::pow(random.next(), 3.0f) + 1e-5f;
    const std::array<std::pair<const char*, std::function<TriangleMesh()>>, 7> makers{{
        {"slit", [&] { return tiny::slit_floor(cells, gap); }},
        {"hairpin", [&] { return tiny::hairpin(cells, gap); }},
        {"thin shell", [&] { return tiny::thin_shell(6 + 2 * cells, gap); }},
        {"T-junctions", [&] { return tiny::t_junction_floor(cells); }},
        {"notch", [&] { return tiny::notched_fan(9 + 4 * cells, 2 + cells); }},
        {"random triangles", [&] { return tiny::random_mesh(seed, 9, 8 * cells); }},
        {"cube", [&] { return tiny::cube(); }},
    }};
    const auto& [name, make] = makers[seed % makers.size()];
    TriangleMesh mesh = make();
    if (random.next() < 0.5f && std::string(name) != "cube")
        tiny::jitter(mesh, 0.02f * random.next(), seed);
    const float scale = std::exp2(std::round(40 * random.next() - 20));
    tiny::transform(mesh, tiny::random_rotation(seed), scale, glm::vec3(scale * random.next()));
    return make_case(name, mesh, random.next() < 0.5f ? 30 : 179, seed);
}

using Radius = float (*)(const TriangleMesh&, const Partition&, FaceId, const glm::vec3&);

struct Tally {
    int finished = 0; ///< local searches within their limiting radius
    int wrong = 0;    ///< of them, those that a search of the shared map contradicts
};

Tally compare_searches(const Case& c, Radius radius, int queries, std::uint64_t seed)
{
    Tally tally;
    RandomSequence random(seed, RandomStream::eye_paths, 0, 0);
    for (int i = 0; i < queries; ++i) {
        const auto pick =
            static_cast<std::size_t>(random.next() * static_cast<float>(c.photons.size()));
        const FaceId face = c.face_of_photon[pick];
        const glm::vec3 point = point_on(c.mesh, face, random);
        const auto k = 1 + static_cast<std::size_t>(12 * random.next());
        const float limit = radius(c.mesh, c.partition, face, point);
        const float below = std::nextafter(limit, 0.0f);
        const auto local = brute_force::k_nearest(c.photons, point, k, below, [&](auto photon) {
            return c.face_of_photon[photon] == face;
        });
        if (local.size() < k && limit != kInfinity)
            continue;
        const MapId map = c.partition.map_of_face[face];
        const auto shared =
            brute_force::k_nearest(c.photons, point, k, kInfinity, [&](auto photon) {
                return c.partition.map_of_face[c.face_of_photon[photon]] == map;
            });
        ++tally.finished;
        tally.wrong += !brute_force::same(local, shared);
    }
    return tally;
}

} // namespace

TEST_CASE("exact_limiting_radius: a local search within it finds what the shared map holds",
          "[partition][property]")
{
    int finished = 0;
    int wrong_by_edges = 0;
    for (std::uint64_t seed = 0; seed < 350; ++seed) {
        const Case c = random_case(seed);
        const Tally exact = compare_searches(c, exact_limiting_radius, 40, seed);
        INFO(c.name << ", seed " << seed << ": " << exact.wrong << " of " << exact.finished);
        REQUIRE(exact.wrong == 0);
        finished += exact.finished;
        wrong_by_edges += compare_searches(c, limiting_radius, 40, seed).wrong;
    }
    WARN("700 meshes, 28,000 queries, of which " << finished << " ended within the radius");
    CHECK(finished > 2000);
    CHECK(wrong_by_edges > 100); // the same searches by connected edges alone are not exact
}

TEST_CASE("find_self_distances: a flat sheet is bounded by the planes of its connected edges alone",
          "[partition]")
{
    const TriangleMesh mesh = tiny::quad();
    const Partition p = build_partition(tiny::make_scene(mesh), {}).partition;
    CHECK(p.kept_edges == std::vector<std::uint8_t>{4, 1}); // the diagonal
    CHECK(p.self_distance == std::vector<float>{kInfinity, kInfinity});
    CHECK(exact_limiting_radius(mesh, p, 0, {1, 0, 0}) == Approx(std::sqrt(0.5)).epsilon(1e-5));
    CHECK(exact_limiting_radius(mesh, p, 0, {0.5f, 0.5f, 0}) == 0);
}

TEST_CASE("find_self_distances: two leaves of one sheet are as far apart as they are",
          "[partition]")
{
    constexpr float kGap = 0.01f;
    const TriangleMesh mesh = tiny::hairpin(3, kGap);
    const Partition p = build_partition(tiny::make_scene(mesh), {}).partition;
    REQUIRE(p.map_count == 1);
    for (FaceId face = 0; face < 2; ++face)
        CHECK(p.self_distance[face] == Approx(kGap).epsilon(1e-3));
}

TEST_CASE("find_self_distances: a smooth closed surface keeps all edges", "[partition]")
{
    const TriangleMesh mesh = tiny::uv_sphere(32, 16);
    const Partition p = build_partition(tiny::make_scene(mesh), {}).partition;
    REQUIRE(p.map_count == 1);
    for (FaceId face = 0; face < mesh.face_count(); ++face) {
        REQUIRE(p.kept_edges[face] == 7);
        REQUIRE(exact_limiting_radius(
                    mesh, p, face, surface_point(mesh, face, {1.0f / 3, 1.0f / 3}).position) > 0);
    }
}

TEST_CASE("find_self_distances: a face alone in its map has no limit, one without a map no room",
          "[partition]")
{
    const TriangleMesh mesh = tiny::degenerate();
    const Partition p = build_partition(tiny::make_scene(mesh), {.angle_threshold = 0}).partition;
    CHECK(exact_limiting_radius(mesh, p, 0, {1, 1, 0}) == kInfinity);
    CHECK(exact_limiting_radius(mesh, p, 1, {0, 0, 0}) == 0);
}

TEST_CASE("find_self_distances: a fan of thousands of faces round one vertex ends", "[partition]")
{
    const TriangleMesh mesh = tiny::fan(3000);
    const Partition p = build_partition(tiny::make_scene(mesh), {}).partition;
    for (FaceId face = 0; face < mesh.face_count(); ++face)
        REQUIRE(exact_limiting_radius(mesh, p, face, {0, 0, 0}) == 0);
}
