#include "render/frame_source.h"

#include "render/integrator/moving_source.h"
#include "render/shutter.h"

namespace hipmap {

PassSource make_frame_source(const FramePasses& passes, const RenderScene& scene,
                             RenderStatistics& statistics, PhotonCache* cache,
                             const PilotControl& pilots)
{
    if (!passes.effects.has(Effect::motion_blur))
        return make_pass_source(scene, passes.options, statistics, cache, pilots);
    const auto at = [passes, shutter = shutter_time(passes.frame.arguments)](double share) {
        return load_moment(passes.frame, passes.effects, passes.source, shutter.at(share));
    };
    return make_moving_source({scene, at}, passes.options, statistics, pilots);
}

} // namespace hipmap
