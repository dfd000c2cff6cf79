#pragma once

#include <cstddef>
#include <cstdint>
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

/// Removes the temporary names of files that are being written, for a program that ends at once: no
/// such file can be written any more.  Needs no memory; any thread may call it.
void remove_temporary_files() noexcept;

/// Throws InputError if `path` could not be written later (no such folder, no permission, a folder
/// itself), so that long work is not done for nothing.  Changes no file.
void check_writable(const std::filesystem::path& path);

/// Reads a file piece by piece.  Each call throws InputError with path and cause.
class InputFile {
  public:
    explicit InputFile(const std::filesystem::path& path);
    ~InputFile();
    InputFile(const InputFile&) = delete;
    InputFile& operator=(const InputFile&) = delete;

    /// Returns the bytes that are not read yet, by the file's size at first.
    std::size_t left() const { return left_; }
    /// Appends the next `count` bytes, at most left(); fewer, after which none are left, if the
    /// file was cut short meanwhile.
    void append(std::vector<std::byte>& bytes, std::size_t count);
    /// Fills `into` with the next bytes; returns how many there were, fewer only at the end.
    std::size_t read(std::span<std::byte> into);
    /// Goes back to this byte, at most the file's size at first.
    void seek(std::uint64_t place);
    /// Returns the file's size at first.
    std::uint64_t size() const { return size_; }

  private:
    std::filesystem::path path_;
    int descriptor_ = -1;
    std::size_t left_ = 0;
    std::size_t size_ = 0;
};

/// Reads a whole file.  Throws InputError with path and cause if it cannot be read.
std::vector<std::byte> read_file(const std::filesystem::path& path);

} // namespace hipmap
