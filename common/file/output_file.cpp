#include "common/file/output_file.h"

#include "common/input_error.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

namespace hipmap {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const std::string& what)
{
    throw InputError(path.string() + ": " + what);
}

[[noreturn]] void fail(const fs::path& path, const std::string& what, int error)
{
    fail(path, what + " (" + std::generic_category().message(error) + ")");
}

/// Closes a file descriptor that was not released.
class Descriptor {
  public:
    explicit Descriptor(int fd) : fd_(fd) {}
    ~Descriptor()
    {
        if (fd_ >= 0)
            ::close(fd_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    int release() { return std::exchange(fd_, -1); }
    void reset(int fd) { fd_ = fd; } ///< only where there is none yet
    int get() const { return fd_; }
    /// Closes now; 0 or the error.
    int close()
    {
        const int fd = std::exchange(fd_, -1);
        return ::close(fd) == 0 ? 0 : errno;
    }

  private:
    int fd_;
};

/// Names of files that are being written, one in each place; more than these are not listed.
std::array<std::atomic<const char*>, 64> names_in_use{};

/// A new empty file beside `target`, for messages about which `asked` is its name.  Removed unless
/// it was kept.  Its name does not grow with the name of the file to be written, which may be as
/// long as the file system allows.
class TemporaryFile {
  public:
    TemporaryFile(const fs::path& folder, const fs::path& asked)
    {
        static std::atomic<unsigned> counter{0};
        constexpr int kAttempts = 1000; // names left behind by a killed process of the same id
        for (int i = 0; i < kAttempts; ++i) {
            path_ = folder / (".hipmap-" + std::to_string(::getpid()) + "-" +
                              std::to_string(counter++) + ".tmp");
            // Nothing may throw from here on: the file would stay.
            const int fd = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
            if (fd >= 0) {
                descriptor_.reset(fd);
                list();
                return;
            }
            if (errno != EEXIST)
                fail(asked, "cannot write into its folder", errno);
        }
        fail(asked, "cannot write into its folder: too many old .hipmap-*.tmp files; delete them");
    }
    ~TemporaryFile()
    {
        if (listed_)
            *listed_ = nullptr;
        if (!kept_)
            ::unlink(path_.c_str());
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    const fs::path& path() const { return path_; }
    Descriptor& descriptor() { return descriptor_; }
    void keep() { kept_ = true; }

  private:
    void list()
    {
        for (std::atomic<const char*>& place : names_in_use)
            if (const char* free = nullptr; place.compare_exchange_strong(free, path_.c_str())) {
                listed_ = &place;
                return;
            }
    }

    fs::path path_;
    Descriptor descriptor_{-1};
    std::atomic<const char*>* listed_ = nullptr; ///< where the name is listed; null: nowhere
    bool kept_ = false;
};

/// By the effective user, who writes; access() asks for the real one.
bool may_access(const fs::path& path, int mode)
{
    return ::faccessat(AT_FDCWD, path.c_str(), mode, AT_EACCESS) == 0;
}

fs::path folder_of(const fs::path& path)
{
    return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

void write_all(int fd, std::span<const std::byte> bytes, const fs::path& target)
{
    while (!bytes.empty()) {
        const ssize_t written = ::write(fd, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR)
            continue;
        if (written < 0)
            fail(target, "cannot be written", errno);
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
}

/// Makes a rename in `folder` last through a power cut; file systems that cannot are left alone.
void sync_folder(const fs::path& folder)
{
    const Descriptor descriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (descriptor.get() >= 0)
        ::fsync(descriptor.get());
}

} // namespace

struct WholeFile::Parts {
    fs::path asked;  ///< for messages
    fs::path target; ///< through a symbolic link the file it leads to is replaced, not the link
    TemporaryFile temporary;
};

WholeFile::WholeFile(const fs::path& path)
{
    check_writable(path);
    std::error_code no_target;
    const fs::path resolved = fs::canonical(path, no_target);
    const fs::path target = no_target ? path : resolved;
    parts_.reset(new Parts{path, target, TemporaryFile(folder_of(target), path)});
}

WholeFile::~WholeFile() = default;

void WholeFile::write(std::span<const std::byte> bytes)
{
    write_all(parts_->temporary.descriptor().get(), bytes, parts_->asked);
}

void WholeFile::commit()
{
    Parts& file = *parts_;
    Descriptor& descriptor = file.temporary.descriptor();
    if (::fsync(descriptor.get()) != 0)
        fail(file.asked, "cannot be written", errno);
    if (const int error = descriptor.close(); error != 0)
        fail(file.asked, "cannot be written", error);
    if (::rename(file.temporary.path().c_str(), file.target.c_str()) != 0)
        fail(file.asked, "cannot be written", errno);
    file.temporary.keep();
    sync_folder(folder_of(file.target));
}

void remove_temporary_files() noexcept
{
    for (const std::atomic<const char*>& name : names_in_use)
        if (const char* path = name)
            ::unlink(path);
}

void write_file(const fs::path& path, std::span<const std::byte> bytes)
{
    WholeFile file(path);
    file.write(bytes);
    file.commit();
}

void write_file(const fs::path& path, std::string_view text)
{
    write_file(path, std::as_bytes(std::span(text.data(), text.size())));
}

void check_writable(const fs::path& path)
{
    if (path.empty())
        throw InputError("the name of an output file is empty; give one");
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (fs::is_directory(status) || !path.has_filename())
        fail(path, "is a folder; give the name of a file in it");
    if (!fs::exists(status) && status.type() != fs::file_type::not_found)
        fail(path, "cannot be written", error.value());
    if (fs::exists(status) && !fs::is_regular_file(status))
        fail(path, "is not a regular file; choose another name");
    if (fs::exists(status) && !may_access(path, W_OK))
        fail(path, "is write-protected; choose another name", errno);

    const fs::path folder = folder_of(path);
    if (!fs::is_directory(folder, error))
        fail(path, "its folder does not exist; make it or choose another");
    if (!may_access(folder, W_OK | X_OK))
        fail(path, "cannot write into its folder; choose another", errno);
}

InputFile::InputFile(const fs::path& path) : path_(path)
{
    Descriptor descriptor(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    struct stat status = {};
    if (descriptor.get() < 0 || ::fstat(descriptor.get(), &status) != 0)
        fail(path, "cannot be read; check the path", errno);
    if (S_ISDIR(status.st_mode))
        fail(path, "is a folder; give the name of a file in it");
    if (!S_ISREG(status.st_mode))
        fail(path, "is not a regular file; copy it to one");
    left_ = size_ = static_cast<std::size_t>(status.st_size);
    descriptor_ = descriptor.release();
}

InputFile::~InputFile()
{
    ::close(descriptor_);
}

void InputFile::append(std::vector<std::byte>& bytes, std::size_t count)
{
    const std::size_t before = bytes.size();
    bytes.resize(before + std::min(count, left_));
    bytes.resize(before + read(std::span(bytes).subspan(before)));
}

std::size_t InputFile::read(std::span<std::byte> into)
{
    into = into.first(std::min(into.size(), left_));
    std::size_t filled = 0;
    while (filled < into.size()) {
        const ssize_t got = ::read(descriptor_, &into[filled], into.size() - filled);
        if (got < 0 && errno == EINTR)
            continue;
        if (got < 0)
            fail(path_, "cannot be read", errno);
        if (got == 0) { // it was cut short meanwhile
            left_ = 0;
            return filled;
        }
        filled += static_cast<std::size_t>(got);
        left_ -= static_cast<std::size_t>(got);
    }
    return filled;
}

void InputFile::seek(std::uint64_t place)
{
    if (::lseek(descriptor_, static_cast<off_t>(place), SEEK_SET) < 0)
        fail(path_, "cannot be read", errno);
    left_ = size_ - static_cast<std::size_t>(place);
}

std::vector<std::byte> read_file(const fs::path& path)
{
    InputFile file(path);
    std::vector<std::byte> bytes;
    file.append(bytes, file.left());
    return bytes;
}

} // namespace hipmap
