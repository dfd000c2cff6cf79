#pragma once

#include "render/integrator/pass_source.h"

namespace hipmap {

struct RenderedImage {
    Image image; ///< radiance, W/(m2 sr)
    RenderStatistics statistics;
    bool stopped = false; ///< by the caller, before the last pass was done
};

/// What the caller hears and says while an image is made.
struct RenderControl {
    std::function<void(double)> progress;    ///< 0 to 1; from any thread
    const std::atomic<bool>* stop = nullptr; ///< true: finish the tiles under way and return
};

/// Renders from the scene's camera: the average of `passes` independent passes, each with photons
/// and maps of its own.  Same scene and options, same image at any thread count. When stopped, what
/// has been averaged are the whole passes so far; stopped in the first, the pixels done.  Cost:
/// passes * (photons + pixels * samples).
RenderedImage render_image(const RenderScene& scene, const RenderOptions& options,
                           const RenderControl& control);

} // namespace hipmap
