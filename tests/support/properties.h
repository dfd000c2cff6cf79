#pragma once

#include <rapidcheck.h>

#include <iostream>
#include <string>
#include <utility>

namespace hipmap {

/// Whether a property of RapidCheck holds for `cases` random cases: the same ones every time, so
/// that a failure can be looked into.  Prints how many there were, or the least that fails.
template <typename Property>
bool holds(const std::string& name, int cases, Property&& property)
{
    rc::detail::TestMetadata metadata;
    metadata.id = metadata.description = name;
    rc::detail::TestParams params;
    params.maxSuccess = cases;
    const rc::detail::TestResult result =
        rc::detail::checkTestable(std::forward<Property>(property), metadata, params);
    std::cerr << name << ": ";
    rc::detail::printResultMessage(result, std::cerr);
    std::cerr << '\n';
    return result.is<rc::detail::SuccessResult>();
}

} // namespace hipmap
