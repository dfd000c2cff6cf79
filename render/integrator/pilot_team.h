#pragma once

#include "common/math/part.h"

#include <cstddef>
#include <cstring>
#include <functional>
#include <span>
#include <type_traits>
#include <vector>

namespace hipmap {

/// The processes that find pilots together, each a part of what takes long.  All of them make the
/// same calls of `joined`, in the same order.
struct PilotTeam {
    std::size_t rank = 0, count = 1;
    /// Returns the bytes of all, by rank.  own: of some elements, each of so many bytes.  Empty:
    /// there is one process.
    std::function<std::vector<std::byte>(std::span<const std::byte> own, std::size_t element)> join;

    /// Returns which of so many things this process does.
    Part part(std::size_t things) const { return part_of(things, rank, count); }
};

/// Returns what all processes have, by rank.  T: numbers alone, though those of glm have functions
/// to copy them.
template <typename T>
std::vector<T> joined(const PilotTeam& team, std::vector<T> own)
{
    static_assert(std::is_standard_layout_v<T> && std::is_trivially_destructible_v<T>);
    if (!team.join)
        return own;
    const std::vector<std::byte> all = team.join(std::as_bytes(std::span(own)), sizeof(T));
    own.resize(all.size() / sizeof(T));
    if (!own.empty())
        std::memcpy(static_cast<void*>(own.data()), all.data(), own.size() * sizeof(T));
    return own;
}

} // namespace hipmap
