#pragma once

#include "render/integrator/integrators.h"
#include "render/prepare_frame.h"

namespace hipmap {

/// What the passes of a frame are made of; all borrowed.
struct FramePasses {
    const PreparedFrame& frame;
    SceneSource& source; ///< of the frame's moments
    const EffectPlan& effects;
    const RenderOptions& options;
};

/// Makes the passes of a scene as it is or, if the plan has motion blur, of its moments while the
/// shutter is open.  As make_pass_source; the source of moments throws as load_moment.
PassSource make_frame_source(const FramePasses& passes, const RenderScene& scene,
                             RenderStatistics& statistics, PhotonCache* cache,
                             const PilotControl& pilots = {});

} // namespace hipmap
