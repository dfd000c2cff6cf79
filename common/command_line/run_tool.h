#pragma once

#include <functional>
#include <string_view>

namespace hipmap {

/// Exit codes of both tools.
inline constexpr int kExitDone = 0;
inline constexpr int kExitDefect = 1;  ///< a defect of ours
inline constexpr int kExitInput = 2;   ///< bad input or usage
inline constexpr int kExitStopped = 3; ///< by a signal
inline constexpr int kExitMemory = 4;  ///< out of memory

/// Prints "error: " and a message as one line on standard error.
void print_error(std::string_view what);

/// Runs the body of a tool.  Turns what the body throws into one line on standard error and an exit
/// code.  Where memory runs out in a parallel loop, or in a thread of a library, where nothing can
/// catch it, the program ends at once with the same line and exit code, and leaves no temporary
/// file.
int run_tool(const std::function<int()>& body);

/// Runs the body of a tool that says what the user can lower when memory runs out, and keeps it to
/// the memory that there is (limit_memory).  memory_advice must outlive the program.
int run_tool(const char* memory_advice, const std::function<int()>& body);

/// Limits the threads of the program from now on; 0: all cores.  Starts them, so that none has to
/// be started later, when memory is short.  Throws std::bad_alloc if the system does not grant
/// them.  One thread at a time.
void limit_threads(unsigned threads);

} // namespace hipmap
