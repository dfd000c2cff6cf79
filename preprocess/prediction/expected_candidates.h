#pragma once

#include "preprocess/partition/build_partition.h"
#include "preprocess/prediction/predict_photons.h"

namespace hipmap {

/// The render that candidates are chosen for.
struct ExpectedPass {
    std::uint64_t photons = 0;     ///< light paths
    std::uint32_t neighbours = 50; ///< k
};

/// The part of a partition that says what may have a local or a group map.
struct Candidates {
    std::vector<std::uint8_t> candidate; ///< [F]
    std::uint32_t group_count = 0;
    std::vector<std::uint32_t> group_of_face; ///< [F]
    std::vector<float> group_radius;          ///< [F]
};

/// Replaces the candidates of a partition.
void set_candidates(Candidates candidates, Partition& partition);

/// Returns how many photons have to be predicted on a candidate: somewhat fewer than 10 k.
double photons_of_candidate(const PredictedPhotons& predicted, const ExpectedPass& pass);

/// Returns a copy of the candidates of a partition.
Candidates candidates_of(const Partition& partition);

/// Returns [F] the photons predicted on each stored face, the most of either side, either kind and
/// any copy.  Linear.
std::vector<float> most_photons_of_faces(const PredictedPhotons& predicted,
                                         const TriangleMesh& mesh);

/// Keeps the candidates that a pass is expected to use, docs/candidates.md: faces and groups that
/// are predicted to hold enough photons, on one side and of one kind, and faces on which searches
/// for k of them can begin within the limiting radius.  Without light the partition stays as it is.
/// photons_of_face: most_photons_of_faces.  partition: with the candidates by shape.  Linear,
/// parallel.
void expect_candidates(const TriangleMesh& mesh, const PredictedPhotons& predicted,
                       std::span<const float> photons_of_face, const ExpectedPass& pass,
                       Partition& partition);

} // namespace hipmap
