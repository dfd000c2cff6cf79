#include "render/lobes/bsdf.h"

#include <algorithm>
#include <cassert>

namespace hipmap {

void add(const PlacedLobe& lobe, Bsdf& bsdf)
{
    assert(bsdf.count < Bsdf::kMostLobes);
    ++bsdf.counts[static_cast<std::size_t>(lobe.handled)];
    bsdf.last[static_cast<std::size_t>(lobe.handled)] = bsdf.count;
    bsdf.all[bsdf.count++] = lobe;
    const bool gathered = lobe.handled == Lobes::gathered;
    bsdf.gathers |= gathered;
    bsdf.follows |= lobe.handled == Lobes::followed;
    bsdf.is_specular |= lobe.handled == Lobes::specular;
    (gathered ? bsdf.transmits_diffusely : bsdf.transmits) |= lobe.transmits;
    bsdf.is_directed |= is_directed(lobe.lobe);
    bsdf.is_separable &= !gathered || is_separable(lobe.lobe);
}

bool reflects(const Bsdf& bsdf, Lobes handled)
{
    return std::ranges::any_of(bsdf.lobes(), [handled](const PlacedLobe& lobe) {
        return lobe.handled == handled && !lobe.transmits &&
               (lobe.depth == Depth::clearcoat || lobe.depth == Depth::reflection);
    });
}

bool has_reflection(const Bsdf& bsdf)
{
    return std::ranges::any_of(bsdf.lobes(), [](const PlacedLobe& lobe) {
        return lobe.depth == Depth::reflection && !lobe.transmits;
    });
}

} // namespace hipmap
