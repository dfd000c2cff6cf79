#include "render/maps/wide_search.h"

#include <hwy/targets.h>

#include <string_view>

namespace hipmap {

std::vector<const char*> simd_targets()
{
    hwy::SetSupportedTargetsForTest(0);
    std::vector<const char*> names;
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets())
        names.push_back(hwy::TargetName(target));
    return names;
}

bool use_simd_target(const char* name)
{
    hwy::SetSupportedTargetsForTest(0);
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets())
        if (std::string_view(name) == hwy::TargetName(target)) {
            hwy::GetChosenTarget().Update(target);
            return true;
        }
    return false;
}

} // namespace hipmap
