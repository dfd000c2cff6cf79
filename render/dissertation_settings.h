#pragma once

#include "common/command_line/option_table.h"
#include "render/dissertation/dissertation.h"

namespace hipmap {

/// The value of DissertationOptions::local_min while it follows from the number of neighbours.
inline constexpr std::uint32_t kLocalMinOpen = 0;

/// Returns the options of the dissertation's methods, bound to `asked`, which must outlive the
/// rows.
std::vector<OptionRow> dissertation_rows(DissertationOptions& asked);

} // namespace hipmap
