#pragma once

#include <cstddef>

namespace hipmap {

/// What the program has allocated by `new`, now and at most since the last call of
/// start_memory_peak.  A program that links memory_meter.cpp has its operator new replaced, in
/// shared libraries too; memory of malloc alone is not seen.
std::size_t memory_in_use();
std::size_t memory_peak();

/// Sets the peak to what is in use.
void start_memory_peak();

} // namespace hipmap
