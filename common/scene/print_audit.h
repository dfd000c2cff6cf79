#pragma once

#include "common/report.h"
#include "common/scene/load_scene.h"

#include <set>

namespace hipmap {

/// Joins sentences that differ in their first quoted name alone: "light 'a' and 'b' is black".
std::vector<std::string> join_by_name(const std::vector<std::string>& sentences);

/// Prints what was found in one line, what was assumed, and what is lost as warnings; a verbose
/// report gets a line for each sentence.  told: what earlier frames of an animation printed, which
/// is left out, and what this one prints as well; null: nothing was.
void print_audit(Report& report, const SceneAudit& audit, std::set<std::string>* told = nullptr);

} // namespace hipmap
