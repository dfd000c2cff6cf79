#include "common/command_line/run_tool.h"
#include "common/file/output_file.h"
#include "common/input_error.h"
#include "tests/support/temporary_folder.h"

#include <catch2/catch.hpp>
#include <sys/wait.h>
#include <tbb/parallel_for.h>
#include <unistd.h>

#include <new>
#include <stdexcept>
#include <thread>

using namespace hipmap;

namespace {

struct Ended {
    int code = -1; ///< -1: by a signal
    std::string printed;
};

/// How a process ends that runs the body as a tool, and what it printed on standard error.
Ended run_apart(const std::function<int()>& body)
{
    int ends[2];
    REQUIRE(::pipe(ends) == 0);
    const pid_t child = ::fork();
    REQUIRE(child >= 0);
    if (child == 0) {
        ::dup2(ends[1], STDERR_FILENO);
        ::_exit(run_tool("lower something", body));
    }
    ::close(ends[1]);
    Ended ended;
    char piece[256];
    for (ssize_t count; (count = ::read(ends[0], piece, sizeof piece)) > 0;)
        ended.printed.append(piece, static_cast<std::size_t>(count));
    ::close(ends[0]);
    int status = 0;
    REQUIRE(::waitpid(child, &status, 0) == child);
    if (WIFEXITED(status))
        ended.code = WEXITSTATUS(status);
    return ended;
}

} // namespace

TEST_CASE("run_tool: memory that runs out ends with one line and exit code 4", "[command_line]")
{
    const Ended ended = run_apart([]() -> int { throw std::bad_alloc(); });
    CHECK(ended.code == kExitMemory);
    CHECK(ended.printed == "error: out of memory; lower something\n");
}

TEST_CASE("run_tool: a scene that memory does not hold keeps its own message", "[command_line]")
{
    const Ended ended = run_apart([]() -> int { throw OutOfMemory("a.glb: too large"); });
    CHECK(ended.code == kExitMemory);
    CHECK(ended.printed == "error: a.glb: too large\n");
}

TEST_CASE(
    "run_tool: memory that runs out in a thread of a library ends the same way, and leaves no "
    "file",
    "[command_line]")
{
    const TemporaryFolder folder;
    const Ended ended = run_apart([&] {
        WholeFile file(folder / "half");
        file.write(std::as_bytes(std::span("half", 4)));
        std::thread([] { throw std::bad_alloc(); }).join();
        return kExitDone;
    });
    CHECK(ended.code == kExitMemory);
    CHECK(ended.printed == "error: out of memory; lower something\n");
    CHECK(std::filesystem::is_empty(folder.path()));
}

TEST_CASE("run_tool: memory that runs out in a parallel loop ends the program there",
          "[command_line]")
{
    const Ended ended = run_apart([] {
        tbb::parallel_for(0, 2, [](int) { std::get_new_handler()(); });
        return kExitDone;
    });
    CHECK(ended.code == kExitMemory);
    CHECK(ended.printed == "error: out of memory; lower something\n");
    const Ended caught = run_apart([] {
        try {
            std::get_new_handler()();
        } catch (const std::bad_alloc&) {
            return kExitDone;
        }
        return kExitDefect;
    });
    CHECK(caught.code == kExitDone);
}

TEST_CASE("run_tool: bad input and defects have their own exit codes", "[command_line]")
{
    CHECK(run_apart([]() -> int { throw InputError("no"); }).code == kExitInput);
    const Ended defect = run_apart([]() -> int { throw std::logic_error("two\nlines\n"); });
    CHECK(defect.code == kExitDefect);
    CHECK(defect.printed == "error: internal error, please report it: two lines\n");
}
