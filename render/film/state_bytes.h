#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace hipmap {

static_assert(std::endian::native == std::endian::little, "state files are little endian");

/// Writes values one after another into a file: a mark and version of the format, the values
/// compressed (zstd), a checksum of all that.  Takes a few megabytes of memory, however many values
/// it writes.  Throws InputError with path and cause if the file cannot be written.
class StateWriter {
  public:
    StateWriter(const std::filesystem::path& path, std::uint32_t version);
    ~StateWriter();

    template <typename T>
    void put(const T& value)
    {
        static_assert(std::is_trivially_copyable_v<T>);
        append({reinterpret_cast<const std::byte*>(&value), sizeof value});
    }
    template <typename T>
    void put_array(const std::vector<T>& values)
    {
        static_assert(std::has_unique_object_representations_v<T>);
        put(static_cast<std::uint64_t>(values.size()));
        append(std::as_bytes(std::span(values)));
    }
    /// Writes sums of pixels as byte_planes.h has them.
    void put_sums(const std::vector<std::int64_t>& sums);
    /// Ends the file and puts it in the place of the old one; must be the last call.
    void finish();

  private:
    void append(std::span<const std::byte> bytes);
    struct Output;
    std::unique_ptr<Output> output_;
};

/// Reads what StateWriter wrote, piece by piece, from a file that may hold anything.  Memory: the
/// values, at most 16 times the size of the file, and a few megabytes.  Every failure is an
/// InputError that names the file.
class StateReader {
  public:
    /// Opens the file and checks its mark.
    explicit StateReader(const std::filesystem::path& path);
    ~StateReader();
    /// Returns the version of the format, by which the rest is to be read.
    std::uint32_t version() const;
    /// Reads the file once to check the checksum; must be called before any value is read.
    void begin();

    template <typename T>
    T get()
    {
        T value;
        take({reinterpret_cast<std::byte*>(&value), sizeof value});
        return value;
    }
    /// Reads an array of at most `most` values.
    template <typename T>
    std::vector<T> get_array(std::uint64_t most)
    {
        const auto size = get<std::uint64_t>();
        require(size <= most, "length");
        std::vector<T> values;
        // A damaged size allocates no more than the bytes that are there fill.
        for (std::uint64_t left = size; left > 0;) {
            const std::uint64_t part = std::min<std::uint64_t>(left, kPart / sizeof(T));
            values.resize(values.size() + part);
            take(std::as_writable_bytes(std::span(values).last(part)));
            left -= part;
        }
        return values;
    }
    /// Reads sums that must be this many.
    std::vector<std::int64_t> get_sums(std::uint64_t number);
    /// Returns whether nothing is left to read.
    bool at_end();
    /// Throws InputError, saying that `what` is wrong, unless `right`.
    void require(bool right, const char* what) const;

  private:
    static constexpr std::uint64_t kPart = std::uint64_t{1} << 20; ///< bytes
    void take(std::span<std::byte> into);
    std::uint64_t room_for(std::uint64_t least) const;
    struct Input;
    std::unique_ptr<Input> input_;
    std::string path_;
};

} // namespace hipmap
