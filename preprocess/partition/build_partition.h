#pragma once

#include "common/partition/partition.h"
#include "common/scene/scene.h"
#include "preprocess/mesh/half_edges.h"
#include "preprocess/partition/connected_edges.h"

#include <array>
#include <functional>
#include <numbers>
#include <string_view>

namespace hipmap {

struct PartitionPass {
    std::string_view name;
    double seconds = 0.0;
};

struct PartitionOptions {
    double angle_threshold = std::numbers::pi / 6; ///< radians, 0 to pi
    SplitBy split = SplitBy::angle;
    double weld_distance = 0.0; ///< scene units; 0: bit-identical positions only
    std::function<void(const PartitionPass&)> after_pass{}; ///< for progress; may be empty
};

/// What candidates were chosen for, docs/candidates.md.
struct ExpectedUse {
    bool is_known = false;      ///< false: by shape alone
    std::uint64_t photons = 0;  ///< light paths of a pass
    double least = 0;           ///< photons of a candidate
    std::size_t local_maps = 0; ///< predicted on candidates, by face, side and kind of photon
    std::size_t by_shape = 0;   ///< candidates by shape alone
};

/// Counts and times collected while a partition is built.
struct PartitionSummary {
    struct Map {
        MapId id = 0;
        std::size_t faces = 0;
        double area = 0.0; ///< square scene units
    };
    std::size_t faces = 0; ///< with those of copies, as all that faces and edges are counted by
    std::size_t vertices = 0;
    std::size_t welded_vertices = 0;
    std::array<std::size_t, 5> edges{}; ///< by EdgeClass; shared edges count once
    std::size_t edges_in_band = 0;      ///< within the tolerance of the angle threshold
    std::size_t joined_maps = 0;        ///< that a seam joined to another one
    std::size_t bridged_edges = 0;      ///< edges without a neighbour beyond which a map goes on
    std::size_t contacts = 0;           ///< pieces of boundary where one surface stands on another
    std::size_t given_up = 0;           ///< faces and edges that meet too many faces to look at all
    std::size_t candidates = 0;         ///< faces, for local maps
    std::size_t groups = 0;             ///< candidates for group maps
    std::size_t grouped_faces = 0;      ///< faces of them all
    ExpectedUse expected;
    std::size_t closed_faces = 0;
    std::vector<Map> maps;     ///< of stored faces, by id
    std::size_t map_count = 0; ///< with those of copies, as the others below
    double area = 0.0;         ///< of all maps, square scene units
    Map largest;
    MeshDefects defects;
    std::vector<PartitionPass> passes; ///< in order
};

struct PartitionResult {
    Partition partition;
    PartitionSummary summary;
};

/// Decides which faces of a scene may share photons; docs/partition_file.md.
/// Same scene and options, same partition, at any thread count.  Near linear.
/// Throws InputError if the scene has more faces than edges can be numbered.
PartitionResult build_partition(const Scene& scene, const PartitionOptions& options);

/// Decides the same for a scene with copies (TriangleMesh::copies): what only depends on shared
/// faces is found once for all of their copies.  Shared faces and copies that may be one surface
/// with others, and all of them if vertices are welded over a distance, are set apart in the scene
/// first.  Memory and time: those of the stored faces, and of faces of copies near others.
PartitionResult build_partition_of_copies(Scene& scene, const PartitionOptions& options);

} // namespace hipmap
