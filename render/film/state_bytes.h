#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace hipmap {

static_assert(std::endian::native == std::endian::little, "state files are little endian");

/// Writes values one after another: a mark and version of the format, the values, a checksum.
class StateWriter {
  public:
    explicit StateWriter(std::uint32_t version);

    template <typename T>
    void put(const T& value)
    {
        static_assert(std::is_trivially_copyable_v<T>);
        append(&value, sizeof value);
    }
    template <typename T>
    void put_array(const std::vector<T>& values)
    {
        static_assert(std::has_unique_object_representations_v<T>);
        put(static_cast<std::uint64_t>(values.size()));
        append(values.data(), values.size() * sizeof(T));
    }
    /// Appends the checksum and returns all bytes; must be the last call.
    std::span<const std::byte> finish();

  private:
    void append(const void* data, std::size_t size);
    std::vector<std::byte> bytes_;
};

/// Reads what StateWriter wrote, from bytes that may hold anything: it never reads past their end,
/// and allocates nothing that they do not hold.  Every failure is an InputError that names the
/// file.
class StateReader {
  public:
    /// Checks mark, version and checksum.  Borrows the bytes.
    StateReader(const std::filesystem::path& path, std::span<const std::byte> bytes,
                std::uint32_t version);

    template <typename T>
    T get()
    {
        T value;
        std::memcpy(&value, take(sizeof value, 1), sizeof value);
        return value;
    }
    template <typename T>
    std::vector<T> get_array()
    {
        const auto size = get<std::uint64_t>();
        const std::byte* data = take(sizeof(T), size);
        std::vector<T> values(static_cast<std::size_t>(size));
        if (size > 0)
            std::memcpy(values.data(), data, values.size() * sizeof(T));
        return values;
    }
    bool at_end() const { return at_ == bytes_.size(); }
    /// Throws InputError, saying that `what` is wrong, unless `right`.
    void require(bool right, const char* what) const;

  private:
    const std::byte* take(std::size_t size, std::uint64_t number);
    std::string path_;
    std::span<const std::byte> bytes_; ///< without the checksum
    std::size_t at_ = 0;
};

} // namespace hipmap
