#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace hipmap {

/// The passes first, first + 1, ..., end - 1; never empty in a PassSet.
struct PassRange {
    std::uint64_t first = 0;
    std::uint64_t end = 0;
    bool operator==(const PassRange&) const = default;
};

/// A set of passes as ranges, in order and with a gap between any two, so that each set has one
/// form.
struct PassSet {
    std::vector<PassRange> ranges;
    bool operator==(const PassSet&) const = default;
};

/// Returns whether the ranges are as PassSet says.
bool is_valid(const PassSet& set);

std::uint64_t count(const PassSet& set);
/// Counts the passes with pass % modulus == residue.
std::uint64_t count(const PassSet& set, std::uint64_t modulus, std::uint64_t residue);

/// Returns the lowest pass from `first` on that is not in the set.
std::uint64_t next_missing(const PassSet& set, std::uint64_t first);

/// Returns a pass that is in both sets; none if they are disjoint.
std::optional<std::uint64_t> common_pass(const PassSet& a, const PassSet& b);

/// Returns all passes of both sets.
PassSet united(const PassSet& a, const PassSet& b);

/// Returns the passes of `a` that are not in `b`.
PassSet without(const PassSet& a, const PassSet& b);

} // namespace hipmap
