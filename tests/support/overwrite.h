#pragma once

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <span>
#include <string_view>

namespace hipmap {

/// Makes this the whole of a file, and does not wait for the disk as write_file does: for thousands
/// of damaged copies.
inline void overwrite(const std::filesystem::path& path, std::string_view bytes)
{
    std::ofstream file(path, std::ios::binary);
    file.exceptions(std::ios::failbit | std::ios::badbit);
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    file.close();
}

inline void overwrite(const std::filesystem::path& path, std::span<const std::byte> bytes)
{
    overwrite(path, std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

} // namespace hipmap
