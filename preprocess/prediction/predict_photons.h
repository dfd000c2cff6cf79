#pragma once

#include "common/scene/scene.h"
#include "preprocess/partition/face_tree.h"
#include "preprocess/prediction/light_walk.h"

namespace hipmap {

/// The photons that a pass of `render` is predicted to store, docs/candidates.md.
struct PredictedPhotons {
    struct At {
        LeftPhoton place; ///< face (of a copy too), side and kind
        double photons = 0;
    };
    std::vector<At> places; ///< ascending; where the trace left any
    double each = 0;        ///< that a traced photon stands for
    bool is_lit = true;     ///< false: no light was found, so nothing is known
};

/// Traces some of `photons` light paths through the scene, with mean materials, and scales what
/// they leave to all of them, as a pass of `--integrator direct` stores them.
/// partition: of the scene.  tree: of its stored faces that have a map, or of none; large scenes
/// without copies are traced in it.  Same scene, same photons, at any thread count.  Parallel.
/// Cost: some 0.1 s for up to two million `photons`.
PredictedPhotons predict_photons(const Scene& scene, const Partition& partition,
                                 const FaceTree& tree, std::uint64_t photons);

} // namespace hipmap
