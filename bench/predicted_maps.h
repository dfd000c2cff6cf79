#pragma once

#include "common/scene/scene.h"
#include "preprocess/prediction/expected_candidates.h"

namespace hipmap {

/// How candidates compare with the maps that a pass of `render --integrator direct` builds.
struct PredictedMaps {
    std::size_t faces = 0;
    std::size_t by_shape = 0;      ///< faces that are candidates by their shape alone
    std::size_t candidates = 0;    ///< faces
    std::size_t used = 0;          ///< candidates with a local map or more
    std::size_t built = 0;         ///< local maps of --maps thesis: of faces, by side and kind
    std::size_t foreseen = 0;      ///< those that are of candidates
    std::size_t able = 0;          ///< local maps in which some search can begin
    std::size_t able_foreseen = 0; ///< those that are of candidates
    std::size_t groups = 0;        ///< candidates for group maps
    std::size_t groups_used = 0;   ///< those with 10 k photons of a side and kind
    std::size_t groups_full = 0;   ///< groups by shape with so many

    /// Returns the fraction of the maps built that are of candidates; 1 if none was built.
    double recall() const { return built == 0 ? 1 : double(foreseen) / double(built); }
    /// Returns the fraction of the candidates that have a map; 1 without candidates.
    double precision() const { return candidates == 0 ? 1 : double(used) / double(candidates); }

    PredictedMaps& operator+=(const PredictedMaps& other);
};

/// Predicts the candidates of a scene, traces the photons of a pass and builds their maps in mode
/// thesis.  scene: without copies.  environment maps are left out.
PredictedMaps compare_predicted_maps(const Scene& scene, const ExpectedPass& pass);

} // namespace hipmap
