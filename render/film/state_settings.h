#pragma once

#include "common/setting.h"
#include "render/film/state_bytes.h"

namespace hipmap {

/// Adds text, of printable ASCII, to a state's bytes.
void put_text(StateWriter& out, const std::string& text);

/// Reads what put_text wrote.  Throws InputError if it is too long or not printable ASCII.
std::string get_text(StateReader& in);

/// Adds settings to a state's bytes: names, the kind of each value and the value.
void put_settings(StateWriter& out, const std::vector<Setting>& settings);

/// Reads what put_settings wrote.  Throws InputError: more settings than a render has, an unknown
/// kind, text that is not printable ASCII, a number that is not finite.
std::vector<Setting> get_settings(StateReader& in);

} // namespace hipmap
