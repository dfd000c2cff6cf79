#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace hipmap {

/// Returns what a program may take of a machine: what its other programs leave of memory and swap,
/// and at least half of its memory, as these may end.  meminfo: the text of /proc/meminfo. None if
/// it does not say.
std::optional<std::uint64_t> memory_for_a_program(std::string_view meminfo);

/// Keeps the program to memory_for_a_program and to the limit of its control group: beyond it an
/// allocation fails, which the program can tell, where the kernel would end it without a word.
/// Leaves a lower limit (ulimit -d) as it is, and does nothing where the system says nothing, or
/// under a sanitizer.
void limit_memory();

} // namespace hipmap
