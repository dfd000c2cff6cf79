#pragma once

#include <stdexcept>
#include <string>

namespace hipmap {

/// Reports bad input or usage, the one exception that the user can fix.  The message is one line
/// that names the file, the place in it, what is wrong and what to do.  Only main catches it (exit
/// code 2).
class InputError : public std::runtime_error {
  public:
    explicit InputError(const std::string& message) : std::runtime_error(message) {}
};

/// Reports input that memory does not hold, where a message can say more than std::bad_alloc.  Only
/// main catches it (exit code 4).
class OutOfMemory : public InputError {
  public:
    using InputError::InputError;
};

} // namespace hipmap
