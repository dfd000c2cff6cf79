#pragma once

#include <zstd.h>
#include <zstd_errors.h>

#include <new>

namespace hipmap {

/// Returns whether a call of zstd succeeded.  result: what it returned.  Throws std::bad_alloc
/// where it found no memory, which says nothing about its input.
inline bool zstd_succeeded(std::size_t result)
{
    if (ZSTD_getErrorCode(result) == ZSTD_error_memory_allocation)
        throw std::bad_alloc();
    return ZSTD_isError(result) == 0;
}

/// Returns what a library made; throws std::bad_alloc if that is null.
template <typename Made>
Made* require_made(Made* made)
{
    if (made == nullptr)
        throw std::bad_alloc();
    return made;
}

} // namespace hipmap
