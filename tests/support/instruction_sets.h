#pragma once

#include <catch2/catch.hpp>
#include <hwy/highway.h>

#include <cstdint>

namespace hipmap {

/// Calls `test` once with each instruction set that kernels are compiled for and the processor has.
/// Not while other threads run kernels.
template <typename Test>
void with_each_instruction_set(const Test& test)
{
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        hwy::SetSupportedTargetsForTest(target);
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
        INFO("instruction set " << hwy::TargetName(target));
        test();
    }
    hwy::SetSupportedTargetsForTest(0);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

} // namespace hipmap
