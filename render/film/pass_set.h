#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace hipmap {

/// Passes first, first + 1, ..., end - 1; never empty in a PassSet.
struct PassRange {
    std::uint64_t first = 0;
    std::uint64_t end = 0;
    bool operator==(const PassRange&) const = default;
};

/// A set of passes as ranges, in order and with a gap between any two: one form for each set.
struct PassSet {
    std::vector<PassRange> ranges;
    bool operator==(const PassSet&) const = default;
};

/// Whether the ranges are as PassSet says.
bool is_valid(const PassSet& set);

std::uint64_t count(const PassSet& set);
/// Those with pass % modulus == residue.
std::uint64_t count(const PassSet& set, std::uint64_t modulus, std::uint64_t residue);

/// The lowest pass from `first` on that is not in the set.
std::uint64_t next_missing(const PassSet& set, std::uint64_t first);

/// A pass that is in both; none if they are disjoint.
std::optional<std::uint64_t> common_pass(const PassSet& a, const PassSet& b);

/// All passes of both, which must be disjoint.
PassSet united(const PassSet& a, const PassSet& b);

} // namespace hipmap
