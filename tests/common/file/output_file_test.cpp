#include "common/file/output_file.h"
#include "common/input_error.h"
#include "tests/support/temporary_folder.h"

#include <catch2/catch.hpp>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>

namespace hipmap {

namespace fs = std::filesystem;
using Catch::Matchers::Contains;

namespace {

std::string text_of(const fs::path& path)
{
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

std::string error_of(const auto& action)
{
    try {
        action();
    } catch (const InputError& error) {
        return error.what();
    }
    return "no InputError";
}

/// No file may grow beyond `bytes` while this lives: as a full disk would have it.
class FileSizeLimit {
  public:
    explicit FileSizeLimit(rlim_t bytes)
    {
        getrlimit(RLIMIT_FSIZE, &old_);
        const rlimit limit = {bytes, old_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
        handler_ = std::signal(SIGXFSZ, SIG_IGN);
    }
    ~FileSizeLimit()
    {
        setrlimit(RLIMIT_FSIZE, &old_);
        std::signal(SIGXFSZ, handler_);
    }

  private:
    rlimit old_ = {};
    void (*handler_)(int) = nullptr;
};

} // namespace

TEST_CASE("write_file: what was written is read back, and nothing else is left", "[file]")
{
    const TemporaryFolder folder;
    const std::string text("a\0b\r\n\xff", 6);
    write_file(folder / "new", text);
    CHECK(text_of(folder / "new") == text);
    write_file(folder / "new", "shorter");
    CHECK(text_of(folder / "new") == "shorter");
    write_file(folder / "empty", "");
    CHECK(read_file(folder / "empty").empty());

    const std::vector<std::byte> bytes = read_file(folder / "new");
    REQUIRE(bytes.size() == 7);
    CHECK(bytes.front() == std::byte{'s'});
    CHECK(folder.file_count() == 2);
}

TEST_CASE("write_file: a disk that fills up leaves the old file whole and no temporary", "[file]")
{
    const TemporaryFolder folder;
    write_file(folder / "picture", "old");
    const std::string large(1 << 20, 'x');
    std::string error;
    {
        const FileSizeLimit limit(1 << 16);
        error = error_of([&] { write_file(folder / "picture", large); });
    }
    CHECK_THAT(error, Contains((folder / "picture").string()) && Contains("cannot be written"));
    CHECK(text_of(folder / "picture") == "old");
    CHECK(folder.file_count() == 1);
}

TEST_CASE("write_file: the longest name a file system takes is not too long", "[file]")
{
    const TemporaryFolder folder;
    write_file(folder / std::string(255, 'n'), "text");
    CHECK(text_of(folder / std::string(255, 'n')) == "text");
    CHECK_THAT(error_of([&] { write_file(folder / std::string(256, 'n'), "text"); }),
               Contains("cannot be written"));
    CHECK(folder.file_count() == 1);
}

TEST_CASE("write_file: a symbolic link stays and what it leads to is replaced", "[file]")
{
    const TemporaryFolder folder;
    write_file(folder / "target", "old");
    fs::create_symlink("target", folder / "link");
    write_file(folder / "link", "new");
    CHECK(fs::is_symlink(folder / "link"));
    CHECK(text_of(folder / "target") == "new");
}

TEST_CASE("check_writable: names what cannot become a file, with the cure", "[file]")
{
    const TemporaryFolder folder;
    write_file(folder / "file", "text");
    CHECK_NOTHROW(check_writable(folder / "file"));
    CHECK_NOTHROW(check_writable(folder / "new"));
    CHECK_NOTHROW(check_writable("new"));

    const auto error = [](const fs::path& path) { return error_of([&] { check_writable(path); }); };
    CHECK_THAT(error(""), Contains("empty"));
    CHECK_THAT(error(folder.path()), Contains("is a folder"));
    CHECK_THAT(error(folder.path() / "new/"), Contains("is a folder"));
    CHECK_THAT(error(folder / "none/new"), Contains("its folder does not exist"));
    CHECK_THAT(error(folder / "file/new"), Contains("its folder does not exist"));
    CHECK_THAT(error("/dev/null"), Contains("not a regular file"));
    CHECK(error(folder / "none/new").find('\n') == std::string::npos);
    CHECK(folder.file_count() == 1);
    CHECK(text_of(folder / "file") == "text");
}

TEST_CASE("write_file: a folder without write permission keeps its file", "[file]")
{
    if (geteuid() == 0 && seteuid(65534) != 0)
        FAIL("cannot give up the rights of root, to whom every folder is writable");
    const auto back_to_root = [](const int*) { (void)!seteuid(getuid()); };
    const int token = 0;
    const std::unique_ptr<const int, decltype(back_to_root)> restore(&token, back_to_root);

    const TemporaryFolder folder;
    write_file(folder / "file", "old");
    fs::permissions(folder.path(), fs::perms::owner_read | fs::perms::owner_exec);
    CHECK_THAT(error_of([&] { write_file(folder / "file", "new"); }),
               Contains("cannot write into its folder"));
    fs::permissions(folder.path(), fs::perms::owner_all);
    CHECK(text_of(folder / "file") == "old");
    CHECK(folder.file_count() == 1);

    fs::permissions(folder / "file", fs::perms::owner_read);
    CHECK_THAT(error_of([&] { write_file(folder / "file", "new"); }), Contains("write-protected"));
    CHECK(text_of(folder / "file") == "old");
}

TEST_CASE("read_file: names a file that is not there or is no file", "[file]")
{
    const TemporaryFolder folder;
    CHECK_THAT(error_of([&] { read_file(folder / "none"); }),
               Contains((folder / "none").string()) && Contains("No such file"));
    CHECK_THAT(error_of([&] { read_file(folder.path()); }), Contains("is a folder"));
    CHECK_THAT(error_of([&] { read_file("/dev/zero"); }), Contains("not a regular file"));
}

} // namespace hipmap
