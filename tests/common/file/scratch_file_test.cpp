#include "common/file/scratch_file.h"
#include "common/input_error.h"
#include "tests/support/temporary_folder.h"

#include <catch2/catch.hpp>

#include <cstdlib>
#include <optional>
#include <string>

namespace hipmap {

namespace {

/// Sets TMPDIR while it lives.
class TemporaryFiles {
  public:
    explicit TemporaryFiles(const std::filesystem::path& folder)
    {
        if (const char* const before = std::getenv("TMPDIR"))
            before_ = before;
        ::setenv("TMPDIR", folder.c_str(), 1);
    }
    ~TemporaryFiles()
    {
        if (before_)
            ::setenv("TMPDIR", before_->c_str(), 1);
        else
            ::unsetenv("TMPDIR");
    }
    TemporaryFiles(const TemporaryFiles&) = delete;
    TemporaryFiles& operator=(const TemporaryFiles&) = delete;

  private:
    std::optional<std::string> before_;
};

std::span<const std::byte> bytes_of(std::string_view text)
{
    return std::as_bytes(std::span(text.data(), text.size()));
}

} // namespace

TEST_CASE("ScratchFile: returns what was appended, and leaves nothing", "[file]")
{
    const TemporaryFolder folder;
    const TemporaryFiles here(folder.path());
    ScratchFile file;
    CHECK(file.append(bytes_of("photon")) == 0);
    CHECK(file.append(bytes_of(" map")) == 6);
    std::string text(5, '?');
    file.read(4, std::as_writable_bytes(std::span(text)));
    CHECK(text == "on ma");
    CHECK(std::filesystem::is_empty(folder.path()));
    CHECK_THROWS_AS(file.read(8, std::as_writable_bytes(std::span(text))), InputError);
}

TEST_CASE("ScratchFile: a folder that is missing is an error that names it and TMPDIR", "[file]")
{
    const TemporaryFolder folder;
    const TemporaryFiles there(folder / "gone");
    CHECK_THROWS_WITH(ScratchFile(), Catch::Contains("TMPDIR"));
}

} // namespace hipmap
