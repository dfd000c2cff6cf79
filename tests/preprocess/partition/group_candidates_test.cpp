#include "common/partition/limiting_radius.h"
#include "common/rays/surface_point.h"
#include "preprocess/partition/build_partition.h"
#include "preprocess/partition/group_candidates.h"
#include "preprocess/partition/local_candidates.h"
#include "tests/support/brute_force.h"
#include "tests/support/hard_surfaces.h"

#include <catch2/catch.hpp>
#include <tbb/global_control.h>

#include <limits>
#include <string>

using namespace hipmap;

namespace {

constexpr float kEndless = std::numeric_limits<float>::infinity();

/// The point of a face that is nearest to `point`.
glm::dvec3 nearest_point(const TriangleMesh& mesh, FaceId face, const glm::dvec3& point)
{
    std::array<glm::dvec3, 3> p;
    for (int c = 0; c < 3; ++c)
        p[c] = glm::dvec3(mesh.positions[mesh.corners[face][c]]);
    const glm::dvec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
    glm::dvec3 best = point - normal * (glm::dot(point - p[0], normal) / glm::dot(normal, normal));
    bool inside = true;
    for (int c = 0; c < 3; ++c)
        inside &= glm::dot(glm::cross(normal, p[(c + 1) % 3] - p[c]), point - p[c]) >= 0;
    for (int c = 0; c < 3; ++c) {
        const glm::dvec3 along = p[(c + 1) % 3] - p[c];
        const double t = glm::dot(point - p[c], along) / glm::dot(along, along);
        const glm::dvec3 foot = p[c] + along * std::clamp(t, 0.0, 1.0);
        if ((!inside && c == 0) || glm::distance(point, foot) < glm::distance(point, best))
            best = foot;
    }
    return best;
}

/// A mesh and its partition.
struct GroupCase {
    std::string name;
    TriangleMesh mesh;
    Partition partition;

    bool outside(FaceId face, FaceId other) const
    {
        return partition.map_of_face[other] == partition.map_of_face[face] &&
               partition.group_of_face[other] != partition.group_of_face[face];
    }

    glm::vec3 point_on(FaceId face, RandomSequence& random) const
    {
        const float root = std::sqrt(random.next());
        return surface_point(mesh, face, {root * (1 - random.next()), 1 - root}).position;
    }
};

GroupCase make_case(std::string name, const TriangleMesh& mesh, double angle_deg = 30)
{
    const PartitionOptions options{.angle_threshold = angle_deg * glm::pi<double>() / 180};
    return {std::move(name), mesh, build_partition(tiny::make_scene(mesh), options).partition};
}

/// A sheet with a bump of random height at every corner.
TriangleMesh crumpled(std::uint32_t cells, float height, std::uint64_t seed)
{
    RandomSequence random(seed, RandomStream::pictures, 0, 2);
    return tiny::bent_grid(cells, cells,
                           [&](glm::vec2 p) { return glm::vec3(p, height * random.next()); });
}

/// Meshes fine enough for groups, on which a shared map comes near itself in many ways.
GroupCase random_group_case(std::uint64_t seed)
{
    RandomSequence random(seed, RandomStream::pictures, 0, 1);
    const auto cells = 8 + static_cast<std::uint32_t>(8 * random.next());
    const float gap = 0.2f * std::pow(random.next(), 3.0f) + 1e-5f;
    const std::array<std::pair<const char*, std::function<TriangleMesh()>>, 6> makers{{
        {"slit", [&] { return tiny::slit_floor(cells / 2, gap); }},
        {"hairpin", [&] { return tiny::hairpin(cells, gap); }},
        {"thin shell", [&] { return tiny::thin_shell(24 + 2 * cells, gap); }},
        {"T-junctions", [&] { return tiny::t_junction_floor(cells); }},
        {"notch", [&] { return tiny::notched_fan(256 + 4 * cells, 2 + cells); }},
        {"crumpled", [&] { return crumpled(2 * cells, 10 * gap, seed); }},
    }};
    const auto& [name, make] = makers[seed % makers.size()];
    TriangleMesh mesh = make();
    if (random.next() < 0.5f)
        tiny::jitter(mesh, 0.01f * random.next(), seed);
    const float scale = std::exp2(std::round(40 * random.next() - 20));
    tiny::transform(mesh, tiny::random_rotation(seed), scale, glm::vec3(scale * random.next()));
    return make_case(name, mesh, random.next() < 0.3f ? 30 : 179);
}

struct GroupTally {
    int finished = 0; ///< searches of a group that ended within the limiting radius
    int wrong = 0;    ///< of them, those that a search of the shared map contradicts
    int wider = 0;    ///< wrong ones of the same within a radius that is one half larger
};

/// Looks for the k nearest of photons spread over the group, and of one where each face outside it
/// comes nearest.
void compare_searches(const GroupCase& c, FaceId face, RandomSequence& random, GroupTally& tally)
{
    const glm::vec3 point = c.point_on(face, random);
    std::vector<glm::vec3> photons;
    std::vector<std::uint8_t> in_group;
    for (FaceId other = 0; other < c.mesh.face_count(); ++other) {
        if (c.partition.map_of_face[other] != c.partition.map_of_face[face])
            continue;
        const bool inside = !c.outside(face, other);
        if (!inside)
            photons.emplace_back(nearest_point(c.mesh, other, glm::dvec3(point)));
        for (int i = 0; inside && i < 8; ++i)
            photons.push_back(c.point_on(other, random));
        in_group.resize(photons.size(), inside);
    }
    const auto k = 1 + static_cast<std::size_t>(5 * random.next());
    const auto shared =
        brute_force::k_nearest(photons, point, k, kEndless, [](auto) { return true; });
    const auto finished = [&](float radius, int& wrong) {
        const auto found =
            brute_force::k_nearest(photons, point, k, std::nextafter(radius, 0.0f),
                                   [&](auto photon) { return in_group[photon] != 0; });
        wrong += found.size() == k && !brute_force::same(found, shared);
        return found.size() == k;
    };
    const float radius = exact_group_radius(c.mesh, c.partition, face, point);
    tally.finished += finished(radius, tally.wrong);
    finished(1.5f * radius, tally.wider);
}

std::vector<FaceId> grouped_faces(const Partition& partition)
{
    std::vector<FaceId> faces;
    for (FaceId face = 0; face < partition.face_count(); ++face)
        if (partition.group_of_face[face] != kNone)
            faces.push_back(face);
    return faces;
}

/// Of the centre of a face from the faces of its map outside its group.
double true_distance(const GroupCase& c, FaceId face)
{
    const glm::dvec3 centre = face_centre(c.mesh, face);
    double least = std::numeric_limits<double>::infinity();
    for (FaceId other = 0; other < c.mesh.face_count(); ++other)
        if (c.outside(face, other))
            least = std::min(least, glm::distance(centre, nearest_point(c.mesh, other, centre)));
    return least;
}

std::vector<double> areas_of_groups(const GroupCase& c)
{
    std::vector<double> areas(c.partition.group_count, 0.0);
    for (const FaceId face : grouped_faces(c.partition))
        areas[c.partition.group_of_face[face]] += face_area(c.mesh, face);
    return areas;
}

} // namespace

TEST_CASE("exact_group_radius: a search within it finds what the shared map holds",
          "[partition][property]")
{
    GroupTally tally;
    for (std::uint64_t seed = 0; seed < 240; ++seed) {
        const GroupCase c = random_group_case(seed);
        const std::vector<FaceId> faces = grouped_faces(c.partition);
        RandomSequence random(seed, RandomStream::eye_paths, 0, 0);
        for (int query = 0; query < 40 && !faces.empty(); ++query) {
            const auto pick =
                static_cast<std::size_t>(random.next() * static_cast<float>(faces.size()));
            compare_searches(c, faces[pick], random, tally);
        }
        INFO(c.name << ", seed " << seed << ": " << tally.wrong << " of " << tally.finished);
        REQUIRE(tally.wrong == 0);
    }
    WARN("240 meshes, of whose queries " << tally.finished << " ended within the radius");
    CHECK(tally.finished > 2000);
    CHECK(tally.wider > 100);
}

TEST_CASE(
    "find_group_candidates: self-distances fall short of the truth by little, and never exceed it",
    "[partition][property]")
{
    int faces = 0;
    for (std::uint64_t seed = 0; seed < 24; ++seed) {
        const GroupCase c = random_group_case(seed);
        const std::vector<double> areas = areas_of_groups(c);
        for (const FaceId face : grouped_faces(c.partition)) {
            const double truth = true_distance(c, face);
            const double slack =
                std::sqrt(areas[c.partition.group_of_face[face]] / glm::pi<double>()) / 16;
            INFO(c.name << ", seed " << seed << ", face " << face);
            REQUIRE(c.partition.group_radius[face] < truth);
            REQUIRE(c.partition.group_radius[face] >
                    (truth - slack) * (1 - 1e-6) - 1.01 * c.partition.position_error);
            ++faces;
        }
    }
    CHECK(faces > 2000);
}

TEST_CASE("find_group_candidates: a fine square is 64 squares, clear to their rims", "[partition]")
{
    constexpr std::uint32_t kCells = 64;
    const GroupCase c = make_case(
        "grid", tiny::bent_grid(kCells, kCells, [](glm::vec2 p) { return glm::vec3(p, 0); }));
    REQUIRE(c.partition.group_count == 64);
    std::vector<float> largest(64, 0.0f);
    for (FaceId face = 0; face < c.mesh.face_count(); ++face) {
        const std::uint32_t group = c.partition.group_of_face[face];
        const glm::uvec2 square = glm::uvec2(8.0 * face_centre(c.mesh, face));
        const FaceId lowest = 2 * 8 * (kCells * square.y + square.x);
        REQUIRE(group == c.partition.group_of_face[lowest]);
        largest[group] = std::max(largest[group], c.partition.group_radius[face]);
    }
    // The rim of the grid is no bound, and centres of faces are within 0.75 squares of any point.
    const float cell = 1.0f / kCells;
    const auto clear = [&](std::uint32_t column, std::uint32_t row) {
        return largest[c.partition.group_of_face[2 * 8 * (kCells * row + column)]];
    };
    for (const auto& [found, truth] :
         {std::pair(clear(3, 4), 4 * cell), std::pair(clear(0, 0), 8 * cell)}) {
        CHECK(found <= truth);
        CHECK(found >= truth - (0.75f + 8 / std::sqrt(glm::pi<float>()) / 16) * cell);
    }
}

TEST_CASE("find_group_candidates: a fine globe is 64 groups of like area", "[partition]")
{
    const bool leaves_stay_whole = GENERATE(false, true);
    const GroupCase c = make_case("globe", leaves_stay_whole ? tiny::uv_sphere(600, 240)
                                                             : tiny::uv_sphere(126, 80));
    CHECK(c.partition.group_count == 64);
    CHECK(grouped_faces(c.partition).size() == c.mesh.face_count()); // small ones at the poles too
    for (const double area : areas_of_groups(c))
        CHECK(area == Approx(4 * glm::pi<double>() / 64).epsilon(0.02));
    for (FaceId face = 0; face < c.mesh.face_count(); face += c.mesh.face_count() / 20) {
        const double truth = true_distance(c, face);
        CHECK(c.partition.group_radius[face] < truth);
        CHECK(c.partition.group_radius[face] > truth - std::sqrt(4.01 / 64) / 16);
    }
}

TEST_CASE("find_group_candidates: both sides of a thin shell are in one group", "[partition]")
{
    constexpr float kThickness = 0.001f;
    const GroupCase c = make_case("shell", tiny::thin_shell(96, kThickness), 179);
    REQUIRE(c.partition.map_count == 1);
    REQUIRE(c.partition.group_count >= 48);
    for (const FaceId face : grouped_faces(c.partition))
        if (c.partition.group_radius[face] > 10 * kThickness)
            return;
    FAIL("no search can leave its own side");
}

TEST_CASE("find_group_candidates: faces that are large in their map are in no group", "[partition]")
{
    const auto place = [](glm::vec2 p) { return glm::vec3(glm::pow(p, glm::vec2(6)), 0); };
    const GroupCase growing = make_case("growing squares", tiny::bent_grid(24, 24, place));
    CHECK(growing.partition.group_count > 0);
    CHECK(growing.partition.group_of_face.back() == kNone); // larger than a patch
    for (const double area : areas_of_groups(growing))
        CHECK(area < 1.4143 / 64);
    CHECK(make_case("cube", tiny::cube()).partition.group_count == 0);
    CHECK(make_case("coarse globe", tiny::uv_sphere(8, 6)).partition.group_count == 0);
    CHECK(make_case("nothing", tiny::make_mesh({}, {})).partition.group_count == 0);
    CHECK(make_case("degenerate", tiny::degenerate()).partition.group_radius[1] == 0);
}

TEST_CASE("find_group_candidates: patches too narrow for the fewest photons are none",
          "[partition]")
{
    const GroupCase c =
        make_case("strips", tiny::bent_grid(512, 1, [](glm::vec2 p) { return glm::vec3(p, 0); }));
    CHECK(c.partition.group_count == 0);
    CHECK(exact_group_radius(c.mesh, c.partition, 300, {0.5f, 0.5f, 0}) == 0);
}

TEST_CASE("find_group_candidates: the same with one, two and seven threads", "[partition]")
{
    const TriangleMesh mesh = tiny::together(tiny::uv_sphere(60, 40), crumpled(40, 0.1f, 7));
    const auto run = [&](std::size_t threads) {
        const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
        return make_case("", mesh).partition;
    };
    const Partition one = run(1);
    REQUIRE(one.group_count > 0);
    for (const std::size_t threads : {2, 7}) {
        const Partition many = run(threads);
        CHECK(many.group_of_face == one.group_of_face);
        CHECK(many.group_radius == one.group_radius);
    }
}
