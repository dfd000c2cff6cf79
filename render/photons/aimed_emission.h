#pragma once

#include "render/shading/emission.h"

namespace hipmap {

/// The start of a light path that is aimed at the targets, as `emit_path` does without aim: for
/// what passes through them, the same light in expectation.  There must be a target.
EmittedPath emit_aimed_path(const RenderScene& scene, const EmissionPlan& plan,
                            const std::vector<TargetSphere>& targets, std::uint64_t path,
                            RandomSequence& random);

} // namespace hipmap
