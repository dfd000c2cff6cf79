#pragma once

#include "render/integrator/gather_path.h"
#include "render/integrator/pass_source.h"

#include <map>
#include <memory>

namespace hipmap {

/// The maps of one pass of integrator progressive.
struct ProgressiveMaps {
    ChosenMaps caustic, global, indirect, glossy;
    std::optional<VolumeMap> volume; ///< if the scene has media

    /// Returns the bytes of the large arrays.
    std::size_t bytes() const;
};

/// The radii of the first pass, from pilot photons.
struct ProgressiveRadii {
    FirstRadii surfaces;
    VolumeRadii volume;
    PlacedGuides guide = {}; ///< of final-gather rays
    PlacedGuides sky = {};   ///< of samples of the environments
};

/// The maps and radii that integrator progressive keeps for images of one scene from several
/// cameras, and for those of the next scene of an animation.  All options must be the same except
/// the camera and the size of the image.
struct PhotonCache {
    struct Pass {
        std::shared_ptr<ProgressiveMaps> maps;
        RenderStatistics made; ///< what it took
    };

    std::size_t most = 0;                    ///< bytes; passes that do not fit are not kept
    std::size_t bytes = 0;                   ///< of `passes` and `previous`
    std::uint64_t served = 0;                ///< passes that were there, the pilot's apart
    std::uint64_t taken_over = 0, built = 0; ///< maps of passes that were not
    std::shared_ptr<const ProgressiveRadii> radii;
    std::map<std::uint64_t, Pass> passes;   ///< by number
    std::map<std::uint64_t, Pass> previous; ///< of the previous scene: passes that are made take
                                            ///< over those of their maps that would be the same
};

/// Turns the passes into those of a previous scene, and forgets the radii.
void change_scene(PhotonCache& cache);

/// Returns the maps of a pass from the cache, or makes them by `make(previous, statistics)` and
/// keeps them if they fit.  previous: the maps of this pass in the previous scene, or empty ones;
/// null without a cache or where it keeps none.  Adds the work of new maps to `statistics`, but no
/// time for cached ones.  cache: may be null.
std::shared_ptr<const ProgressiveMaps>
maps_of_pass(PhotonCache* cache, std::uint64_t pass, RenderStatistics& statistics,
             const std::function<ProgressiveMaps(ProgressiveMaps*, RenderStatistics&)>& make);

} // namespace hipmap
