#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace hipmap {

/// Writes a file piece by piece under a temporary name beside `path`; commit() syncs and renames
/// it. Without commit() nothing is left.  Each call throws InputError with path and cause.
class WholeFile {
  public:
    explicit WholeFile(const std::filesystem::path& path);
    ~WholeFile();
    void write(std::span<const std::byte> bytes);
    /// Puts the whole file in the place of the old one; must be the last call.
    void commit();

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

/// Writes all bytes to a temporary name beside `path`, syncs, and renames: readers see the old file
/// or the whole new one, never a part.  Throws InputError with path and cause; leaves no temporary
/// file.
void write_file(const std::filesystem::path& path, std::span<const std::byte> bytes);
void write_file(const std::filesystem::path& path, std::string_view text);

/// Throws InputError if `path` could not be written later (no such folder, no permission, a folder
/// itself), so that long work is not done for nothing.  Changes no file.
void check_writable(const std::filesystem::path& path);

/// Reads a whole file.  Throws InputError with path and cause if it cannot be read.
std::vector<std::byte> read_file(const std::filesystem::path& path);

} // namespace hipmap
