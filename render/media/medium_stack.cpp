#include "render/media/medium_stack.h"

#include <algorithm>

namespace hipmap {

void MediumStack::enter(MaterialId material, const std::vector<float>& priorities)
{
    if (count == kMost)
        return;
    std::size_t at = count++;
    for (; at > 0 && priorities[entered[at - 1]] > priorities[material]; --at)
        entered[at] = entered[at - 1];
    entered[at] = material;
}

void MediumStack::leave(MaterialId material)
{
    for (std::size_t i = count; i-- > 0;)
        if (entered[i] == material) {
            std::copy(entered.begin() + i + 1, entered.begin() + count, entered.begin() + i);
            --count;
            return;
        }
}

} // namespace hipmap
