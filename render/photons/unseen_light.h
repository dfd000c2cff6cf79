#pragma once

#include "render/photons/seen_classes.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace hipmap {

/// What the classes of an image's light paths are compared with; members as SeenSurfaces has them.
struct SeenScale {
    double unit = 0; ///< 0: nothing is counted
    double light = 0;
    double caustic_worth = 0, global_worth = 0; ///< SeenRegions::mean_worth
    std::vector<std::uint8_t> reached = {};
};

SeenScale scale_of(const SeenSurfaces& seen);

/// Light that the photons of some passes may have missed, docs/error.md (21), (22).
struct UnseenLight {
    std::uint64_t passes = 0;
    std::uint64_t paths = 0;        ///< that reached what the image sees, about
    std::uint64_t classes_once = 0; ///< that one path alone reached
    std::uint64_t lights_never = 0; ///< whose paths and samples did not reach what the image sees
    double share = 0; ///< of the image's light by those classes: the Good-Turing estimate of what
                      ///<   is unseen
    double most = 0;  ///< 95 % upper limit of the unseen share; infinite: there is no light
    std::size_t light = 0; ///< to which most of that may be due, by its place in LightSet::lights
    bool never = false;    ///< none of its paths reached what the image sees
};

/// Estimates the light that no path has met.  Nothing: no pass was counted.
std::optional<UnseenLight> find_unseen_light(const SeenClasses& classes, const SeenScale& scale);

/// Returns an upper limit of the share of the image's light that one photon carries, over all
/// counted passes.  Returns 0 if no pass was counted or the image has no light.
double share_of_path(const SeenClasses& classes, const SeenScale& scale);

} // namespace hipmap
