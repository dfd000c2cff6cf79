#pragma once

#include "common/setting.h"
#include "render/film/state_bytes.h"

namespace hipmap {

/// Adds settings to a state's bytes: names, the kind of each value and the value.
void put_settings(StateWriter& out, const std::vector<Setting>& settings);

/// Reads what put_settings wrote.  Throws InputError: more settings than a render has, an unknown
/// kind, text that is not printable ASCII, a number that is not finite.
std::vector<Setting> get_settings(StateReader& in);

} // namespace hipmap
