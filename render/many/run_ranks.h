#pragma once

#include "render/integrator/run_passes.h"
#include "render/many/ranks.h"

namespace hipmap {

/// Adds passes to the lead's state as run_passes does, until a rule or the caller of some rank
/// stops it: each rank renders passes that the lead hands out, and the films are added up after
/// rounds of them, when `control` saves and hears of passes, on the lead.  The image has the bits
/// of one process.  The state of a worker gets no passes, and the image of its result is empty.
/// Every rank is given the same source and rules.  Throws on all ranks if saving fails on the lead.
RunResult run_ranks(const PassSource& source, const StopRules& rules, const RunControl& control,
                    RenderState& state, Ranks& ranks);

} // namespace hipmap
