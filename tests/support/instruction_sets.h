#pragma once

#include "render/maps/wide_search.h"

#include <catch2/catch.hpp>

namespace hipmap {

/// Calls `test` once with each instruction set that kernels are compiled for and the processor has.
/// Not while other threads run kernels.
template <typename Test>
void with_each_instruction_set(const Test& test)
{
    const std::vector<const char*> targets = simd_targets();
    for (const char* target : targets) {
        REQUIRE(use_simd_target(target));
        INFO("instruction set " << target);
        test();
    }
    use_simd_target(targets.front());
}

} // namespace hipmap
