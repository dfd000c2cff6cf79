#include "common/math/sampling.h"
#include "render/maps/fixed_radius.h"
#include "tests/render/maps/flat_walls.h"
#include "tests/support/statistics.h"
#include "tests/support/tiny_meshes.h"

#include <catch2/catch.hpp>

using namespace hipmap;
using namespace hipmap::flat_walls;

namespace {

/// A unit square in z = 0, one map, cut by `cuts` that no photon is gathered across.
struct CutBoard {
    TriangleMesh mesh = tiny::quad();
    Partition partition;

    explicit CutBoard(const Segments& cuts)
    {
        partition.map_count = 1;
        partition.map_of_face = {0, 0};
        partition.flipped = {0, 0};
        partition.edge_class.assign(6, EdgeClass::border);
        partition.edge_class[2] = partition.edge_class[3] = EdgeClass::connected;
        partition.opposite = {kNone, kNone, 3, 2, kNone, kNone};
        for (const BoundarySegment& cut : cuts)
            partition.contacts.push_back({0, cut.a, cut.b});
    }
};

/// Short segments anywhere on the unit square.
Segments scratches(std::uint64_t seed, int count, float length)
{
    Random random(seed);
    Segments out;
    for (int i = 0; i < count; ++i) {
        const float x = random.between(0, 1), y = random.between(0, 1);
        const float angle = random.between(0, 6.2831853f);
        out.push_back(flat(x, y, x + length * std::cos(angle), y + length * std::sin(angle)));
    }
    return out;
}

/// Square holes in rows and columns.
Segments holes(int across)
{
    Segments out;
    for (int i = 0; i < across * across; ++i) {
        const float size = 0.3f / float(across);
        const float x = (float(i % across) + 0.35f) / float(across);
        const float y = (float(i / across) + 0.35f) / float(across);
        out.insert(out.end(), {flat(x, y, x + size, y), flat(x + size, y, x + size, y + size),
                               flat(x + size, y + size, x, y + size), flat(x, y + size, x, y)});
    }
    return out;
}

/// What one query sees past its outline, and past the whole boundary.
struct Views {
    float radius = 0; ///< of the outline
    Segments outline;
    VisibleDisc bounded, whole;
};

Views look_both_ways(const MapBoundaries& boundaries, const TriangleMesh& mesh,
                     const glm::vec3& point, float radius)
{
    Views out;
    OutlineScratch scratch;
    out.radius = outline_boundary(boundaries, {0, point, {0, 0, 1}, radius}, scratch, out.outline);
    const std::uint32_t face = point.y > point.x ? 1 : 0;
    const glm::uvec3 c = mesh.corners[face];
    const std::array<glm::vec3, 3> corners{mesh.positions[c.x], mesh.positions[c.y],
                                           mesh.positions[c.z]};
    Segments all;
    boundaries.near(0, point, radius, all);
    out.whole.look({corners, point, radius}, all);
    if (out.radius > 0)
        out.bounded.look({corners, point, out.radius}, out.outline);
    return out;
}

} // namespace

TEST_CASE("outline: few segments are looked past as they are", "[maps][outline]")
{
    const CutBoard board(scratches(3, 10, 0.2f));
    const MapBoundaries boundaries(board.mesh, board.partition);
    Random random(4);
    for (int trial = 0; trial < 100; ++trial) {
        const glm::vec3 point(random.between(0, 1), random.between(0, 1), 0);
        const float radius = random.between(0.01f, 3);
        Segments all, outline;
        OutlineScratch scratch;
        boundaries.near(0, point, radius, all);
        CHECK(outline_boundary(boundaries, {0, point, {0, 0, 1}, radius}, scratch, outline) ==
              radius);
        CHECK(outline == all);
    }
}

TEST_CASE("outline: work is bounded, and nothing is seen that the boundary hides",
          "[maps][outline]")
{
    const std::vector<Segments> cuts{scratches(5, 300, 0.1f), scratches(6, 20'000, 0.01f),
                                     scratches(7, 5'000, 0.3f), holes(20), holes(100)};
    for (std::size_t board = 0; board < cuts.size(); ++board) {
        const CutBoard cut(cuts[board]);
        const MapBoundaries boundaries(cut.mesh, cut.partition);
        Random random(board);
        RunningMean share, reach;
        std::size_t seen = 0;
        for (int trial = 0; trial < 100; ++trial) {
            CAPTURE(board, trial);
            const glm::vec3 point(random.between(0, 1), random.between(0, 1), 0);
            const float radius = std::pow(10.0f, random.between(-2, 1));
            const Views views = look_both_ways(boundaries, cut.mesh, point, radius);
            CHECK(views.outline.size() <= kMostSegments);
            CHECK(views.radius <= radius);
            if (!(views.radius > 0))
                continue;
            for (int i = 0; i < 200; ++i) {
                const float u = random.between(0, 1), phi = random.between(0, 6.2831853f);
                const glm::vec3 photon =
                    point + 0.999f * views.radius * u * glm::vec3(std::cos(phi), std::sin(phi), 0);
                if (!views.bounded.sees(photon))
                    continue;
                ++seen;
                CHECK(views.whole.sees(photon));
            }
            share.add(views.bounded.area(views.radius) / views.whole.area(radius));
            reach.add(views.radius / radius);
        }
        INFO("board " << board << ": " << share.mean() << " of the visible area, " << reach.mean()
                      << " of the radius");
        CHECK(seen > 500);
        CHECK(share.mean() > 0.2);
        CHECK(reach.mean() > 0.25);
    }
}

TEST_CASE("outline: under even light estimates are right in any radius on a board full of cuts",
          "[maps][outline]")
{
    for (const Segments& cuts : {scratches(8, 3'000, 0.02f), holes(30)}) {
        const CutBoard board(cuts);
        const MapSurfaces surfaces(board.mesh, board.partition);
        std::array<RunningMean, 3> means;
        EstimateScratch scratch;
        for (std::uint64_t set = 0; set < 80; ++set) {
            std::vector<Photon> photons;
            for (std::uint64_t i = 0; i < 5'000; ++i) {
                RandomSequence random(1, RandomStream::photons, set, i);
                const glm::vec2 u = random.next2();
                photons.push_back(
                    {glm::vec3(u, 0), Rgb(1.0f / 5'000), {0, 0, 1}, u.y > u.x ? 1u : 0u, 0});
            }
            const PhotonMaps maps = build_photon_maps(photons, board.partition, {50});
            RandomSequence random(2, RandomStream::eye_paths, set, 0);
            std::array<double, 3> sums{};
            for (int i = 0; i < 100; ++i) {
                const glm::vec2 at = random.next2();
                const float radius = 0.1f + 2 * random.next();
                const RadiusEstimates found = estimate_within(
                    maps, surfaces, {glm::vec3(at, 0), {0, 0, 1}, at.y > at.x ? 1u : 0u, 0},
                    {radius, 0.7f * radius, 0.5f * radius}, scratch);
                for (std::size_t r = 0; r < 3; ++r)
                    sums[r] += found.irradiance[r].x / 100;
            }
            for (std::size_t r = 0; r < 3; ++r)
                means[r].add(sums[r]);
        }
        for (const RunningMean& mean : means) {
            INFO("mean " << mean.mean() << " +- " << mean.standard_error());
            CHECK(std::abs(mean.z_score(1)) < kMostZ);
            CHECK(mean.standard_error() < 0.02);
        }
    }
}
