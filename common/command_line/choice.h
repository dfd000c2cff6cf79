#pragma once

#include <cassert>
#include <span>
#include <string_view>

namespace hipmap {

/// Pairs a value of a closed set with its name on the command line, in statistics and in states.
/// One array per set is the only place where the names are written.
template <typename Value>
struct Choice {
    const char* name;
    Value value;
};

/// Returns the value called `name`, which must be the name of one of the choices.
template <typename Value>
Value value_of(std::span<const Choice<Value>> choices, std::string_view name)
{
    for (const Choice<Value>& choice : choices)
        if (choice.name == name)
            return choice.value;
    assert(false);
    return choices.front().value;
}

/// Returns the name of `value`, which must be one of the choices.
template <typename Value>
const char* name_of(std::span<const Choice<Value>> choices, const Value& value)
{
    for (const Choice<Value>& choice : choices)
        if (choice.value == value)
            return choice.name;
    assert(false);
    return "";
}

} // namespace hipmap
