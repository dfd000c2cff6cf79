#include "render/film/state_bytes.h"

#include "common/input_error.h"

#include <xxhash.h>

namespace hipmap {

namespace {

constexpr std::uint64_t kMark = 0x5354'5350'4d50'4948; // "HIPMPSTS"

} // namespace

StateWriter::StateWriter(std::uint32_t version)
{
    put(kMark);
    put(version);
}

void StateWriter::append(const void* data, std::size_t size)
{
    const std::size_t at = bytes_.size();
    bytes_.resize(at + size);
    if (size > 0)
        std::memcpy(&bytes_[at], data, size);
}

std::span<const std::byte> StateWriter::finish()
{
    put(static_cast<std::uint64_t>(XXH3_64bits(bytes_.data(), bytes_.size())));
    return bytes_;
}

StateReader::StateReader(const std::filesystem::path& path, std::span<const std::byte> bytes,
                         std::uint32_t version)
    : path_(path.string()), bytes_(bytes)
{
    if (bytes_.size() < sizeof kMark || get<std::uint64_t>() != kMark)
        throw InputError(path_ + ": not a state file; give a file written by --state");
    if (const auto found = get<std::uint32_t>(); found != version)
        throw InputError(path_ + ": state file of format " + std::to_string(found) +
                         ", and this render reads format " + std::to_string(version) +
                         "; use the version that wrote it, or another file name");
    std::uint64_t checksum = 0;
    require(bytes.size() >= at_ + sizeof checksum, "length");
    bytes_ = bytes.first(bytes.size() - sizeof checksum);
    std::memcpy(&checksum, bytes.data() + bytes_.size(), sizeof checksum);
    require(checksum == XXH3_64bits(bytes_.data(), bytes_.size()), "checksum");
}

void StateReader::require(bool right, const char* what) const
{
    if (!right)
        throw InputError(path_ + ": damaged state file (" + what +
                         " is wrong); use a copy, or another file name");
}

const std::byte* StateReader::take(std::size_t size, std::uint64_t number)
{
    require(number <= (bytes_.size() - at_) / size, "length");
    const std::byte* data = bytes_.data() + at_;
    at_ += size * static_cast<std::size_t>(number);
    return data;
}

} // namespace hipmap
