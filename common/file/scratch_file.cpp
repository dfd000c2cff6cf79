#include "common/file/scratch_file.h"

#include "common/input_error.h"

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>
#include <system_error>

namespace hipmap {

namespace {

InputError scratch_error(const std::filesystem::path& folder, const char* what, int cause)
{
    return InputError(folder.string() + ": " + what + " (" + std::strerror(cause) +
                      "); set TMPDIR to a folder with room");
}

} // namespace

ScratchFile::ScratchFile()
{
    std::error_code error;
    folder_ = std::filesystem::temp_directory_path(error);
    if (error)
        throw InputError("TMPDIR: not a folder for temporary files (" + error.message() +
                         "); set it to a folder with room");
    std::string name = (folder_ / "hipmap-XXXXXX").string();
    descriptor_ = ::mkstemp(name.data());
    if (descriptor_ < 0)
        throw scratch_error(folder_, "a temporary file cannot be made", errno);
    ::unlink(name.c_str());
}

ScratchFile::~ScratchFile()
{
    if (descriptor_ >= 0)
        ::close(descriptor_);
}

std::uint64_t ScratchFile::append(std::span<const std::byte> bytes)
{
    const std::uint64_t place = size_;
    while (!bytes.empty()) {
        const ssize_t count =
            ::pwrite(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(size_));
        if (count < 0 && errno == EINTR)
            continue;
        if (count <= 0)
            throw scratch_error(folder_, "a temporary file cannot be written",
                                count < 0 ? errno : ENOSPC);
        size_ += static_cast<std::uint64_t>(count);
        bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
    return place;
}

void ScratchFile::read(std::uint64_t place, std::span<std::byte> into) const
{
    while (!into.empty()) {
        const ssize_t count =
            ::pread(descriptor_, into.data(), into.size(), static_cast<off_t>(place));
        if (count < 0 && errno == EINTR)
            continue;
        if (count <= 0)
            throw scratch_error(folder_, "a temporary file cannot be read",
                                count < 0 ? errno : EIO);
        place += static_cast<std::uint64_t>(count);
        into = into.subspan(static_cast<std::size_t>(count));
    }
}

} // namespace hipmap
