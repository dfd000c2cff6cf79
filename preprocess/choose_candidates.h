#pragma once

#include "preprocess/options.h"
#include "preprocess/prediction/expected_candidates.h"

namespace hipmap {

/// Predicts the photons of the pass of `render` that the options describe, and keeps those
/// candidates of a partition that such a pass is expected to use, docs/candidates.md.  Counts them
/// in the summary. result: with the candidates by shape.  tree: as predict_photons takes it.
/// Returns [F] the photons predicted; empty: no light emits.  The same at any thread count.
std::vector<float> choose_candidates(const PreprocessArguments& arguments, const Scene& scene,
                                     const FaceTree& tree, PartitionResult& result);

} // namespace hipmap
