#include "common/command_line/run_tool.h"

#include "common/command_line/memory_limit.h"
#include "common/file/output_file.h"
#include "common/input_error.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task.h>
#include <tbb/task_arena.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <iostream>
#include <new>
#include <string>
#include <thread>
#include <utility>

namespace hipmap {

namespace {

/// No machine takes longer to start its threads; if one does, they start later.
constexpr std::chrono::milliseconds kLongestStart{200};

std::atomic<const char*> what_to_lower{"use smaller input or fewer --threads"};
std::atomic<bool> threads_are_starting{false};
std::atomic_flag is_ending = ATOMIC_FLAG_INIT;

/// Without memory: standard error is written as it is.
void print_out_of_memory()
{
    for (const std::string_view part :
         {std::string_view("error: out of memory; "), std::string_view(what_to_lower.load()),
          std::string_view("\n")})
        if (::write(STDERR_FILENO, part.data(), part.size()) < 0)
            return;
}

bool is_out_of_memory(const std::exception_ptr& problem)
{
    try {
        if (problem)
            std::rethrow_exception(problem);
    } catch (const std::bad_alloc&) {
        return true;
    } catch (...) {
        return threads_are_starting;
    }
    return false;
}

/// Ends the program, from whatever thread; destructors do not run.
[[noreturn]] void end_out_of_memory()
{
    while (is_ending.test_and_set()) // another thread does it
        ::pause();
    remove_temporary_files();
    print_out_of_memory();
    ::_exit(kExitMemory);
}

/// Runs where operator new finds no memory.  An exception in a parallel loop cancels the loops that
/// it surrounds as well, and these return as if they were done: what follows them there would work
/// on what was never written.  So the program ends at once there.
void answer_lack_of_memory()
{
    if (tbb::task::current_context() != nullptr)
        end_out_of_memory();
    throw std::bad_alloc();
}

/// Runs where an exception leaves a thread that nobody waits for, or a function that promises to
/// throw none.
[[noreturn]] void end_program()
{
    if (is_out_of_memory(std::current_exception()))
        end_out_of_memory();
    remove_temporary_files();
    std::abort();
}

/// While it lives, what TBB throws where nothing can catch it says that a thread was not granted.
class StartOfThreads {
  public:
    StartOfThreads() { threads_are_starting = true; }
    ~StartOfThreads() { threads_are_starting = false; }
};

/// Keeps each thread of the pool until all run, or it takes too long.
void start_threads()
{
    const auto limit = static_cast<int>(
        tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
    const int count = std::min(tbb::this_task_arena::max_concurrency(), limit);
    const auto end = std::chrono::steady_clock::now() + kLongestStart;
    std::atomic<int> running{0};
    const auto wait_for_all = [&](int) {
        ++running;
        while (running < count && std::chrono::steady_clock::now() < end)
            std::this_thread::yield();
    };
    try {
        tbb::parallel_for(0, count, wait_for_all, tbb::simple_partitioner());
    } catch (const std::runtime_error&) { // TBB's
        throw std::bad_alloc();
    }
}

} // namespace

void print_error(std::string_view what)
{
    while (!what.empty() && what.back() == '\n')
        what.remove_suffix(1);
    std::string line(what); // one line, whatever libraries put into their messages
    for (char& c : line)
        if (c == '\n')
            c = ' ';
    std::cerr << "error: " << line << '\n';
}

int run_tool(const char* memory_advice, const std::function<int()>& body)
{
    what_to_lower = memory_advice;
    limit_memory();
    return run_tool(body);
}

int run_tool(const std::function<int()>& body)
{
    std::set_terminate(end_program);
    std::set_new_handler(answer_lack_of_memory);
    try {
        return body();
    } catch (const OutOfMemory& problem) {
        print_error(problem.what());
        return kExitMemory;
    } catch (const InputError& problem) {
        print_error(problem.what());
        return kExitInput;
    } catch (const std::bad_alloc&) {
        print_out_of_memory();
        return kExitMemory;
    } catch (const std::exception& problem) {
        print_error(std::string("internal error, please report it: ") + problem.what());
        return kExitDefect;
    }
}

void limit_threads(unsigned threads)
{
    // Never released: raising the limit at the end of the program would start threads then.
    static tbb::global_control* control = nullptr;
    static unsigned limit = 0;
    const StartOfThreads start;
    if (threads != limit) {
        delete std::exchange(control, nullptr);
        limit = 0;
        if (threads > 0)
            control =
                new tbb::global_control(tbb::global_control::max_allowed_parallelism, threads);
        limit = threads;
    }
    start_threads();
}

} // namespace hipmap
