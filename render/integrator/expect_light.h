#pragma once

#include "render/film/expected_light.h"
#include "render/integrator/sample_allocation.h"

namespace hipmap {

/// Returns the error that the seen lights are expected to make in a pass whose samples are
/// allocated so, where few samples find them.  docs/error.md (28).  No light is seen: none.
ExpectedLight expect_light(const PilotNoise& pilot, const RenderOptions& options,
                           const SampleAllocation& allocation);

} // namespace hipmap
