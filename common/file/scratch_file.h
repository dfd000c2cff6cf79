#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>

namespace hipmap {

/// A file for data that memory does not hold, in the folder for temporary files (TMPDIR, else
/// /tmp).  It has no name and ends with the object or the program, however that ends.
class ScratchFile {
  public:
    /// Throws InputError: no file can be made there.
    ScratchFile();
    ~ScratchFile();
    ScratchFile(const ScratchFile&) = delete;
    ScratchFile& operator=(const ScratchFile&) = delete;

    /// Appends bytes and returns where they begin.  Throws InputError: no room.  One thread at a
    /// time.
    std::uint64_t append(std::span<const std::byte> bytes);

    /// Fills `into` with the bytes from `place` on, which must be in the file.  Throws InputError
    /// if they cannot be read.  Thread-safe, also beside append().
    void read(std::uint64_t place, std::span<std::byte> into) const;

  private:
    std::filesystem::path folder_;
    int descriptor_ = -1;
    std::uint64_t size_ = 0;
};

} // namespace hipmap
