#include "preprocess/partition/build_partition.h"

#include "common/input_error.h"
#include "common/scene/store_copies.h"
#include "common/stopwatch.h"
#include "preprocess/partition/copy_contacts.h"
#include "preprocess/partition/group_candidates.h"
#include "preprocess/partition/local_candidates.h"
#include "preprocess/partition/patches.h"
#include "preprocess/partition/previous_frame.h"
#include "preprocess/partition/self_distance.h"
#include "preprocess/partition/summarise.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <string>

namespace hipmap {
namespace {

/// Makes the partition of one frame, by what is known of the one before.
class PartitionBuilder {
  public:
    PartitionBuilder(const Scene& scene, const PartitionOptions& options,
                     const PreviousFrame* previous)
        : scene_(scene), options_(options), previous_(previous)
    {
    }

    void join_faces();
    void join_maps();
    void look_around_maps();
    void add_contacts();
    /// Adds copies to the partition.  Returns false if shared faces have neighbours outside.
    bool add_copies();

    /// The partition as far as it is.
    const Partition& partition() const { return out_; }

    /// The partition.
    PartitionResult finish();
    /// What this frame leaves to the next one, but for its partition; after which all is gone.
    PreviousFrame leave();

  private:
    /// Runs a pass and notes how long it took.
    template <typename Work>
    auto timed(std::string_view name, const Work& work)
    {
        const Stopwatch watch;
        auto result = work();
        summary_.passes.push_back({name, watch.seconds()});
        if (options_.after_pass)
            options_.after_pass(summary_.passes.back());
        return result;
    }

    void build_tree();
    bool refit_tree();
    std::size_t join_seams();
    SelfDistances find_all_self_distances() const;
    GroupCandidates find_all_groups() const;
    std::size_t find_all_contacts();

    const Scene& scene_;
    const TriangleMesh& mesh_ = scene_.mesh;
    const PartitionOptions& options_;
    const PreviousFrame* previous_; ///< null: there is none
    PartitionResult result_;
    Partition& out_ = result_.partition;
    PartitionSummary& summary_ = result_.summary;
    VertexWeld weld_;
    HalfEdges edges_;
    std::vector<std::uint8_t> flipped_; ///< [F] before seams turned any map
    SharedMaps maps_;
    FaceTree tree_; ///< of all faces that have a map
    bool is_refitted_ = false;
    KnownMaps known_;
    std::vector<FaceTree> trees_;       ///< of maps that changed
    std::vector<MadeContact> contacts_; ///< of pairs of faces
    bool found_all_contacts_ = true;
};

/// Finds all that is about edges, and maps as edges join them.
void PartitionBuilder::join_faces()
{
    out_.scene = timed("fingerprint", [&] { return fingerprint(scene_); });
    out_.angle_threshold = options_.angle_threshold;
    out_.position_error = position_error_of(mesh_);
    weld_ = timed("weld vertices",
                  [&] { return weld_vertices(mesh_.positions, options_.weld_distance); });
    edges_ = timed("find half-edges", [&] {
        return previous_ ? find_half_edges(mesh_, weld_, *previous_)
                         : find_half_edges(mesh_, weld_);
    });
    EdgeClasses classes = timed("classify edges", [&] {
        return classify_edges(mesh_, edges_, options_.angle_threshold, options_.split);
    });
    maps_ = timed("share maps", [&] { return share_maps(classes.edge_class, edges_.opposite); });
    summary_.vertices = mesh_.positions.size();
    summary_.welded_vertices = weld_.count;
    summary_.edges_in_band = classes.edges_in_band;
    summary_.defects = edges_.defects;
    flipped_ = edges_.flipped;
    out_.edge_class = std::move(classes.edge_class);
}

void PartitionBuilder::build_tree()
{
    is_refitted_ = false;
    std::vector<FaceId> faces;
    faces.reserve(mesh_.face_count());
    for (FaceId face = 0; face < mesh_.face_count(); ++face)
        if (maps_.map_of_face[face] != kNone)
            faces.push_back(face);
    tree_ = FaceTree(mesh_, faces);
}

/// Returns whether the previous frame's tree serves.
bool PartitionBuilder::refit_tree()
{
    is_refitted_ = previous_ && tree_serves(mesh_, maps_.map_of_face, *previous_);
    if (is_refitted_) {
        tree_ = previous_->tree;
        tree_.refit(mesh_);
    }
    return is_refitted_;
}

/// Joins maps that go on across seams; returns the edges given up on the way.
std::size_t PartitionBuilder::join_seams()
{
    const auto find = [&] {
        return find_seams({.mesh = mesh_,
                           .edges = edges_,
                           .classes = out_.edge_class,
                           .tree = tree_,
                           .error = out_.position_error},
                          maps_);
    };
    Seams seams = find();
    if (is_refitted_ && seams.given_up > 0) { // by the order in which the tree has the faces
        build_tree();
        seams = find();
    }
    for (FaceId face = 0; face < mesh_.face_count(); ++face)
        if (maps_.map_of_face[face] != kNone)
            edges_.flipped[face] ^= seams.turned[maps_.map_of_face[face]];
    maps_ = std::move(seams.maps);
    out_.bridged_edges = std::move(seams.bridged_edges);
    out_.contacts = std::move(seams.open_parts);
    return seams.given_up;
}

/// Finishes the maps.
void PartitionBuilder::join_maps()
{
    timed("build tree", [&] {
        if (!refit_tree())
            build_tree();
        return true;
    });
    // Faces in one plane differ by less than any threshold but none.
    const bool join = options_.split == SplitBy::normals || options_.angle_threshold > kAngleBand;
    const std::uint32_t by_edges = maps_.count;
    summary_.given_up = timed("join seams", [&] { return join ? join_seams() : 0; });
    summary_.joined_maps = by_edges - maps_.count;
    out_.map_count = maps_.count;
    out_.map_of_face = maps_.map_of_face;
    out_.opposite = std::move(edges_.opposite);
    out_.flipped = std::move(edges_.flipped);
    out_.closed = std::move(edges_.closed);
    if (previous_)
        known_ = timed("compare maps", [&] { return find_known_maps(mesh_, out_, *previous_); });
    else
        known_.changed.assign(maps_.count, 1);
}

SelfDistances PartitionBuilder::find_all_self_distances() const
{
    SelfDistances out{std::vector<std::uint8_t>(mesh_.face_count(), 0),
                      std::vector<float>(mesh_.face_count(), 0.0f)};
    if (previous_)
        copy_known_self_distances(*previous_, known_, maps_.map_of_face, out);
    tbb::parallel_for(MapId{0}, maps_.count, [&](MapId map) {
        if (known_.changed[map] != 0)
            find_self_distances({mesh_, trees_[map]}, out_.edge_class, out_.position_error, out);
    });
    return out;
}

GroupCandidates PartitionBuilder::find_all_groups() const
{
    GroupCandidates out{std::vector<std::uint32_t>(mesh_.face_count(), kNone),
                        std::vector<float>(mesh_.face_count(), 0.0f)};
    if (previous_)
        copy_known_groups(*previous_, known_, maps_.map_of_face, out);
    tbb::parallel_for(MapId{0}, maps_.count, [&](MapId map) {
        if (known_.changed[map] != 0)
            find_group_candidates({mesh_, trees_[map]}, out_.position_error, out);
    });
    return out;
}

/// Fills what depends on the faces of each map alone.
void PartitionBuilder::look_around_maps()
{
    trees_ = timed("build trees of maps", [&] {
        // Of one map the tree of all faces is the very tree, unless it was refitted.
        if (maps_.count == 1 && !is_refitted_ && known_.changed[0] != 0)
            return std::vector<FaceTree>{tree_};
        return trees_of_maps(mesh_, maps_, known_.changed);
    });
    LocalCandidates locals = timed("find local candidates", [&] {
        return find_local_candidates(mesh_, out_.edge_class, maps_);
    });
    SelfDistances self_distances =
        timed("find self-distances", [&] { return find_all_self_distances(); });
    GroupCandidates groups = timed("find group candidates", [&] { return find_all_groups(); });
    out_.reach = std::move(locals.reach);
    out_.candidate = std::move(locals.candidate);
    out_.kept_edges = std::move(self_distances.kept_edges);
    out_.self_distance = std::move(self_distances.self_distance);
    out_.group_count = number_by_first(groups.group_of_face);
    out_.group_of_face = std::move(groups.group_of_face);
    out_.group_radius = std::move(groups.group_radius);
    trees_.clear();
}

/// Finds the contacts of pairs of faces; returns the faces given up on the way.
std::size_t PartitionBuilder::find_all_contacts()
{
    // Where some faces were given up, it depends on all that they meet which of them count.
    const bool keep = previous_ && previous_->found_all_contacts;
    const std::vector<std::uint8_t> all(keep ? 0 : maps_.count, 1);
    const std::span<const std::uint8_t> wanted = keep ? known_.changed : all;
    const ContactScene scene{mesh_,
                             out_.edge_class,
                             out_.opposite,
                             out_.map_of_face,
                             out_.bridged_edges,
                             out_.position_error};
    std::size_t given_up = 0;
    contacts_.clear();
    for (const FoundContacts& found :
         {find_contacts(scene, tree_, wanted),
          find_own_contacts(scene, tree_, out_.self_distance, wanted)}) {
        contacts_.insert(contacts_.end(), found.contacts.begin(), found.contacts.end());
        given_up += found.given_up;
    }
    if (is_refitted_ && given_up > 0) { // by the order in which the tree has the faces
        build_tree();
        return find_all_contacts();
    }
    if (keep)
        append_known_contacts(*previous_, known_, contacts_);
    sort_contacts(contacts_);
    return given_up;
}

/// Adds the boundaries that are no edges to those that are open at seams.
void PartitionBuilder::add_contacts()
{
    const std::size_t given_up = timed("find contacts", [&] { return find_all_contacts(); });
    found_all_contacts_ = given_up == 0;
    summary_.given_up += given_up;
    for (const MadeContact& made : contacts_) {
        const std::uint32_t part = part_of_map(out_, made.contact.map);
        const bool own = part != kNone && part != part_of_map(out_, made.by);
        (own ? out_.own_contacts : out_.contacts).push_back(made.contact);
    }
    sort_contacts(out_.contacts);
    if (!out_.copies.empty())
        timed("find contacts of copies", [&] {
            add_copy_contacts(mesh_, out_);
            return true;
        });
}

bool PartitionBuilder::add_copies()
{
    out_.shared = find_shared_parts(mesh_, out_);
    for (const FaceCopy& copy : mesh_.copies)
        out_.copies.push_back(copy.shared);
    if (out_.shared.size() != mesh_.shared.size())
        return false;
    index_copies(out_);
    return true;
}

PartitionResult PartitionBuilder::finish()
{
    timed("summarise", [&] {
        summarise(mesh_, result_);
        return true;
    });
    return std::move(result_);
}

PreviousFrame PartitionBuilder::leave()
{
    return {mesh_.positions,
            std::move(weld_),
            std::move(flipped_),
            std::move(tree_),
            std::move(contacts_),
            found_all_contacts_,
            {}};
}

void check_size(const TriangleMesh& mesh)
{
    if (mesh.face_count() > kNone / 3 || mesh.positions.size() >= kNone)
        throw InputError("the scene has " + std::to_string(mesh.face_count()) +
                         " faces, too many to number their edges; split it");
}

/// Returns false, without a partition, if copies have to be stored first.
bool build(PartitionBuilder& builder, const TriangleMesh& mesh)
{
    check_size(mesh);
    builder.join_faces();
    builder.join_maps();
    if (!builder.add_copies())
        return false;
    builder.look_around_maps();
    builder.add_contacts();
    return true;
}

std::vector<std::uint32_t> all_places(const TriangleMesh& mesh)
{
    std::vector<std::uint32_t> out(mesh.shared.size() + mesh.copies.size());
    std::iota(out.begin(), out.end(), 0u);
    return out;
}

/// The places of shared faces and copies that may be one surface with others.
std::vector<std::uint32_t> find_joined_places(const Scene& scene, const PartitionOptions& options)
{
    check_size(scene.mesh);
    PartitionBuilder builder(scene, options, nullptr);
    builder.join_faces();
    builder.join_maps();
    return find_joined_places(scene.mesh, builder.partition());
}

} // namespace

PartitionResult build_partition(const Scene& scene, const PartitionOptions& options)
{
    PartitionBuilder builder(scene, options, nullptr);
    build(builder, scene.mesh);
    return builder.finish();
}

PartitionResult build_partition_of_copies(Scene& scene, const PartitionOptions& options)
{
    const Fingerprint loaded = fingerprint(scene);
    const TriangleMesh mesh = scene.mesh;
    const Stopwatch watch;
    std::vector<std::uint32_t> apart =
        options.weld_distance > 0 ? all_places(mesh) : find_joined_places(scene, options);
    const PartitionPass joining{"find joined instances", watch.seconds()};
    set_apart(scene.mesh, apart);
    auto builder = std::make_unique<PartitionBuilder>(scene, options, nullptr);
    if (!build(*builder, scene.mesh)) {
        apart = all_places(mesh);
        scene.mesh = mesh;
        set_apart(scene.mesh, apart);
        builder = std::make_unique<PartitionBuilder>(scene, options, nullptr);
        build(*builder, scene.mesh);
    }
    PartitionResult out = builder->finish();
    out.partition.scene = loaded;
    out.partition.apart = std::move(apart);
    out.summary.passes.insert(out.summary.passes.begin(), joining);
    return out;
}

void build_partition(const Scene& scene, const PartitionOptions& options,
                     std::optional<PreviousFrame>& previous)
{
    PartitionBuilder builder(scene, options, previous ? &*previous : nullptr);
    build(builder, scene.mesh);
    PartitionResult result = builder.finish();
    previous = builder.leave();
    previous->result = std::move(result);
}

} // namespace hipmap
