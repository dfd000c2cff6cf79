#pragma once

#include "common/report.h"
#include "common/scene/load_scene.h"

namespace hipmap {

/// Prints what was found and assumed, a line each, and what is lost as warnings.
void print_audit(Report& report, const SceneAudit& audit);

} // namespace hipmap
