#pragma once

#include <cstddef>
#include <string>

namespace hipmap::tiny {

/// Appends what stb_image_write encodes to a std::string.
inline void append_bytes(void* to, void* data, int size)
{
    static_cast<std::string*>(to)->append(static_cast<const char*>(data),
                                          static_cast<std::size_t>(size));
}

} // namespace hipmap::tiny
