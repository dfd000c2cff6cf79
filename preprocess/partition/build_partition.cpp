#include "preprocess/partition/build_partition.h"

#include "common/input_error.h"
#include "common/stopwatch.h"
#include "preprocess/partition/clearance.h"
#include "preprocess/partition/contacts.h"
#include "preprocess/partition/group_candidates.h"
#include "preprocess/partition/local_candidates.h"
#include "preprocess/partition/patches.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <string>

namespace hipmap {
namespace {

/// Runs passes and notes how long each took.
struct PassTimer {
    const PartitionOptions& options;
    PartitionSummary& summary;

    template <typename Work>
    auto operator()(std::string_view name, const Work& work) const
    {
        const Stopwatch watch;
        auto result = work();
        summary.passes.push_back({name, watch.seconds()});
        if (options.after_pass)
            options.after_pass(summary.passes.back());
        return result;
    }
};

void count_edges(PartitionSummary& summary, const Partition& partition)
{
    for (std::uint32_t edge = 0; edge < partition.edge_class.size(); ++edge)
        if (partition.opposite[edge] == kNone || edge < partition.opposite[edge])
            ++summary.edges[static_cast<std::size_t>(partition.edge_class[edge])];
    summary.edges[static_cast<std::size_t>(EdgeClass::non_manifold)] =
        summary.defects.non_manifold_edges + summary.defects.cut_edges;
}

void measure_maps(PartitionSummary& summary, const Partition& partition, const TriangleMesh& mesh)
{
    summary.maps.resize(partition.map_count);
    for (MapId id = 0; id < partition.map_count; ++id)
        summary.maps[id].id = id;
    for (FaceId face = 0; face < mesh.face_count(); ++face) {
        if (partition.map_of_face[face] == kNone)
            continue;
        PartitionSummary::Map& map = summary.maps[partition.map_of_face[face]];
        ++map.faces;
        map.area += face_area(mesh, face);
    }
}

/// Joins maps that go on across seams; returns the edges given up on the way.
/// Changes edges.flipped and maps; fills bridged_edges of `out`, and contacts with what is open.
std::size_t join_seams(const TriangleMesh& mesh, HalfEdges& edges, const EdgeClasses& classes,
                       SharedMaps& maps, const FaceTree& tree, Partition& out)
{
    Seams seams = find_seams(mesh, edges, classes.edge_class, maps, tree, out.position_error);
    for (FaceId face = 0; face < mesh.face_count(); ++face)
        if (maps.map_of_face[face] != kNone)
            edges.flipped[face] ^= seams.turned[maps.map_of_face[face]];
    maps = std::move(seams.maps);
    out.bridged_edges = std::move(seams.bridged_edges);
    out.contacts = std::move(seams.open_parts);
    return seams.given_up;
}

/// Adds the boundaries that are no edges to those that are open at seams; returns the faces given
/// up on the way.
std::size_t add_contacts(const ContactScene& scene, const FaceTree& tree,
                         std::span<const float> clearance, std::vector<MapContact>& contacts)
{
    std::size_t given_up = 0;
    for (const FoundContacts& found :
         {find_contacts(scene, tree), find_own_contacts(scene, tree, clearance)}) {
        contacts.insert(contacts.end(), found.contacts.begin(), found.contacts.end());
        given_up += found.given_up;
    }
    sort_contacts(contacts);
    return given_up;
}

FaceTree tree_of_maps(const TriangleMesh& mesh, const SharedMaps& maps)
{
    std::vector<FaceId> faces;
    faces.reserve(mesh.face_count());
    for (FaceId face = 0; face < mesh.face_count(); ++face)
        if (maps.map_of_face[face] != kNone)
            faces.push_back(face);
    return FaceTree(mesh, faces);
}

Clearances clearances_of(const TriangleMesh& mesh, std::span<const EdgeClass> edge_class,
                         std::span<const FaceTree> trees, double error)
{
    Clearances out{std::vector<std::uint8_t>(mesh.face_count(), 0),
                   std::vector<float>(mesh.face_count(), 0.0f)};
    tbb::parallel_for(std::size_t{0}, trees.size(), [&](std::size_t map) {
        find_clearances({mesh, trees[map]}, edge_class, error, out);
    });
    return out;
}

GroupCandidates groups_of(const TriangleMesh& mesh, std::span<const FaceTree> trees, double error)
{
    GroupCandidates out{std::vector<std::uint32_t>(mesh.face_count(), kNone),
                        std::vector<float>(mesh.face_count(), 0.0f)};
    tbb::parallel_for(std::size_t{0}, trees.size(), [&](std::size_t map) {
        find_group_candidates({mesh, trees[map]}, error, out);
    });
    return out;
}

} // namespace

PartitionResult build_partition(const Scene& scene, const PartitionOptions& options)
{
    const TriangleMesh& mesh = scene.mesh;
    if (mesh.face_count() > kNone / 3 || mesh.positions.size() >= kNone)
        throw InputError("the scene has " + std::to_string(mesh.face_count()) +
                         " faces, too many to number their edges; split it");
    PartitionResult result;
    Partition& out = result.partition;
    PartitionSummary& summary = result.summary;
    const PassTimer timed{options, summary};

    out.scene = timed("fingerprint", [&] { return fingerprint(scene); });
    const VertexWeld weld = timed(
        "weld vertices", [&] { return weld_vertices(mesh.positions, options.weld_distance); });
    HalfEdges edges = timed("find half-edges", [&] { return find_half_edges(mesh, weld); });
    EdgeClasses classes = timed("classify edges", [&] {
        return classify_edges(mesh, edges, options.angle_threshold, options.split);
    });
    SharedMaps maps =
        timed("share maps", [&] { return share_maps(classes.edge_class, edges.opposite); });
    out.position_error = position_error_of(mesh);
    // Faces in one plane differ by less than any threshold but none.
    const bool join = options.split == SplitBy::normals || options.angle_threshold > kAngleBand;
    const FaceTree tree = timed("build tree", [&] { return tree_of_maps(mesh, maps); });
    const std::uint32_t maps_by_edges = maps.count;
    summary.given_up = timed(
        "join seams", [&] { return join ? join_seams(mesh, edges, classes, maps, tree, out) : 0; });
    summary.joined_maps = maps_by_edges - maps.count;
    const std::vector<FaceTree> trees = timed("build trees of maps", [&] {
        return trees_of_maps(mesh, maps, std::vector<std::uint8_t>(maps.count, 1));
    });
    LocalCandidates locals = timed("find local candidates", [&] {
        return find_local_candidates(mesh, classes.edge_class, maps);
    });
    Clearances clearances = timed("find clearances", [&] {
        return clearances_of(mesh, classes.edge_class, trees, out.position_error);
    });
    const ContactScene contact_scene{mesh,
                                     classes.edge_class,
                                     edges.opposite,
                                     maps.map_of_face,
                                     out.bridged_edges,
                                     out.position_error};
    summary.given_up += timed("find contacts", [&] {
        return add_contacts(contact_scene, tree, clearances.clearance, out.contacts);
    });

    GroupCandidates groups =
        timed("find group candidates", [&] { return groups_of(mesh, trees, out.position_error); });

    out.angle_threshold = options.angle_threshold;
    out.map_count = maps.count;
    out.map_of_face = std::move(maps.map_of_face);
    out.edge_class = std::move(classes.edge_class);
    out.opposite = std::move(edges.opposite);
    out.flipped = std::move(edges.flipped);
    out.closed = std::move(edges.closed);
    out.reach = std::move(locals.reach);
    out.candidate = std::move(locals.candidate);
    out.kept_edges = std::move(clearances.kept_edges);
    out.clearance = std::move(clearances.clearance);
    out.group_count = number_by_first(groups.group_of_face);
    out.group_of_face = std::move(groups.group_of_face);
    out.group_radius = std::move(groups.group_radius);

    summary.faces = mesh.face_count();
    summary.vertices = mesh.positions.size();
    summary.welded_vertices = weld.count;
    summary.edges_in_band = classes.edges_in_band;
    summary.defects = edges.defects;
    summary.contacts = out.contacts.size();
    summary.bridged_edges = out.bridged_edges.size();
    summary.candidates = static_cast<std::size_t>(std::ranges::count(out.candidate, 1));
    summary.groups = out.group_count;
    summary.grouped_faces =
        mesh.face_count() - static_cast<std::size_t>(std::ranges::count(out.group_of_face, kNone));
    summary.closed_faces = static_cast<std::size_t>(std::ranges::count(out.closed, 1));
    count_edges(summary, out);
    measure_maps(summary, out, mesh);
    return result;
}

} // namespace hipmap
