#include "common/partition/partition_file.h"
#include "preprocess/partition/previous_frame.h"
#include "tests/support/hard_surfaces.h"
#include "tests/support/properties.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

/// Things that stand together and are moved one by one.
class Things {
  public:
    explicit Things(std::uint64_t seed) : random_(seed, RandomStream::pictures, 0, 4)
    {
        const std::array<std::function<TriangleMesh()>, 10> makers{
            [&] { return tiny::cube(); },
            [&] { return tiny::quad(); },
            [&] { return tiny::open_box(); },
            [&] { return tiny::uv_sphere(12, 9); },
            [&] { return tiny::hairpin(4, 0.1f); },
            [&] { return tiny::t_junction_floor(3); },
            [&] { return tiny::moebius(8); },
            [&] { return tiny::doubled(); },
            [&] { return tiny::random_mesh(seed, 9, 16); },
            [&] { return tiny::degenerate(); },
        };
        add(tiny::quad());
        const float size = below(4) == 0 ? 1.0f : 16.0f; // mostly so that nothing moves beyond it
        for (glm::vec3& p : mesh_.positions)
            p = size * (p - 0.5f);
        at_rest_ = mesh_.positions;
        for (int i = 0; i < 6; ++i)
            add(makers[below(makers.size())]());
        for (std::size_t thing = 0; thing < first_.size(); ++thing)
            place(thing);
    }

    const TriangleMesh& mesh() const { return mesh_; }
    std::uint32_t below(std::size_t count)
    {
        return static_cast<std::uint32_t>(random_.next() * static_cast<float>(count));
    }

    /// Puts a thing somewhere, often so that it touches or coincides with another, or makes a point
    /// of it.
    void place(std::size_t thing)
    {
        const bool on_lattice = random_.next() < 0.7f;
        const auto coordinate = [&] {
            return on_lattice ? 0.5f * static_cast<float>(below(3)) : 2 * random_.next();
        };
        const glm::vec3 move(coordinate(), coordinate(), coordinate());
        const glm::quat turn =
            on_lattice ? glm::quat(1, 0, 0, 0) : tiny::random_rotation(below(99));
        const float scale = random_.next() < 0.05f ? 0.0f : 1.0f;
        for (std::size_t v = first_[thing]; v < end_of(thing); ++v)
            mesh_.positions[v] = scale * (turn * at_rest_[v]) + move;
    }

    std::size_t count() const { return first_.size(); }

  private:
    void add(const TriangleMesh& thing)
    {
        if (!mesh_.positions.empty())
            first_.push_back(mesh_.positions.size());
        mesh_ = tiny::together(mesh_, thing);
        at_rest_ = mesh_.positions;
    }
    std::size_t end_of(std::size_t thing) const
    {
        return thing + 1 < first_.size() ? first_[thing + 1] : mesh_.positions.size();
    }

    RandomSequence random_;
    TriangleMesh mesh_;
    std::vector<glm::vec3> at_rest_;
    std::vector<std::size_t> first_; ///< vertex of each thing that moves
};

/// All counts but the seconds of passes.
auto counts_of(const PartitionSummary& s)
{
    const MeshDefects& d = s.defects;
    return std::vector<std::size_t>{
        s.faces,         s.vertices,           s.welded_vertices,  s.edges[0],
        s.edges[1],      s.edges[2],           s.edges[3],         s.edges[4],
        s.edges_in_band, s.joined_maps,        s.bridged_edges,    s.contacts,
        s.given_up,      s.candidates,         s.groups,           s.grouped_faces,
        s.closed_faces,  s.maps.size(),        d.degenerate_faces, d.flipped_faces,
        d.border_edges,  d.non_manifold_edges, d.cut_edges,        d.refused_faces};
}

/// What the tests went through.
struct Met {
    std::size_t known = 0, changed = 0; ///< maps
    std::size_t contacts = 0, joined = 0, groups = 0;
    std::size_t refitted = 0; ///< trees of faces of which some had moved
};

/// Whether the partitions of some frames are those of each frame alone.
bool same_as_alone(std::uint64_t seed, Met& met)
{
    Things things(seed);
    PartitionOptions options{.angle_threshold = things.below(3) == 0 ? 2.0 : 0.5};
    options.weld_distance = things.below(4) == 0 ? 0.02 : 0.0;
    std::optional<PreviousFrame> frame;
    for (int i = 0; i < 5; ++i) {
        const Scene scene = tiny::make_scene(things.mesh());
        const std::optional<PreviousFrame> before = frame;
        build_partition(scene, options, frame);
        const PartitionResult& result = frame->result;
        const PartitionResult alone = build_partition(scene, options);
        if (partition_checksum(result.partition) != partition_checksum(alone.partition) ||
            counts_of(result.summary) != counts_of(alone.summary))
            return false;
        if (before) {
            met.refitted += scene.mesh.positions != before->positions &&
                            tree_serves(scene.mesh, result.partition.map_of_face, *before);
            const KnownMaps known = find_known_maps(scene.mesh, result.partition, *before);
            const auto changed = std::ranges::count(known.changed, 1);
            met.changed += static_cast<std::size_t>(changed);
            met.known += known.changed.size() - static_cast<std::size_t>(changed);
        }
        met.contacts += result.summary.contacts;
        met.joined += result.summary.joined_maps;
        met.groups += result.summary.groups;
        for (std::uint32_t moves = things.below(3); moves > 0; --moves)
            things.place(things.below(things.count()));
    }
    return true;
}

} // namespace

TEST_CASE("previous_frame: the partition of a frame is that of the frame alone", "[partition]")
{
    Met met;
    CHECK(holds("partitions of frames", 80, [&] {
        const auto seed = *rc::gen::inRange<std::uint64_t>(0, 1000000);
        RC_ASSERT(same_as_alone(seed, met));
    }));
    CHECK(met.known > 3000);
    CHECK(met.changed > 500);
    CHECK(met.contacts > 3000);
    CHECK(met.joined > 50);
    CHECK(met.groups > 30);
    CHECK(met.refitted > 20);
}

TEST_CASE("previous_frame: only maps of what moved are found anew", "[partition]")
{
    const TriangleMesh sphere = tiny::uv_sphere(20, 15);
    TriangleMesh mesh = tiny::together(sphere, tiny::cube());
    for (glm::vec3& p : mesh.positions) // the cube never reaches farther than the sphere
        p *= &p < &mesh.positions[sphere.positions.size()] ? 1.0f : 0.5f;
    std::optional<PreviousFrame> frame;
    build_partition(tiny::make_scene(mesh), {}, frame);
    const PreviousFrame before = *frame;
    for (std::size_t v = sphere.positions.size(); v < mesh.positions.size(); ++v)
        mesh.positions[v].x += 0.125f;
    build_partition(tiny::make_scene(mesh), {}, frame);
    const KnownMaps known = find_known_maps(mesh, frame->result.partition, before);
    CHECK(known.changed == std::vector<std::uint8_t>{0, 1, 1, 1, 1, 1, 1});
    CHECK(known.now == std::vector<MapId>{0, kNone, kNone, kNone, kNone, kNone, kNone});
}

TEST_CASE("previous_frame: a tree of a few moved faces serves, one of other or many does not",
          "[partition]")
{
    const TriangleMesh sphere = tiny::uv_sphere(40, 31);
    TriangleMesh mesh = tiny::together(sphere, tiny::cube());
    std::optional<PreviousFrame> frame;
    build_partition(tiny::make_scene(mesh), {}, frame);
    const std::vector<MapId> maps = frame->result.partition.map_of_face;
    for (std::size_t v = sphere.positions.size(); v < mesh.positions.size(); ++v)
        mesh.positions[v].x += 0.125f;
    CHECK(tree_serves(mesh, maps, *frame));
    std::vector<MapId> fewer = maps;
    fewer[7] = kNone;
    CHECK_FALSE(tree_serves(mesh, fewer, *frame));
    for (glm::vec3& p : mesh.positions)
        p.y += 0.125f;
    CHECK_FALSE(tree_serves(mesh, maps, *frame));
}
