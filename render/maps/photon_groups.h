#pragma once

#include "render/maps/wide_tree.h"
#include "render/photons/photon.h"

#include <cstdint>
#include <span>
#include <vector>

namespace hipmap {

/// Photons by key, each group in the order of the photons.
struct PhotonGroups {
    std::vector<TreePoint> points;    ///< `photon`: the number of the photon
    std::vector<std::uint64_t> first; ///< [keys + 1]: group g is points [first[g], first[g+1])

    std::span<TreePoint> of(std::size_t key)
    {
        return {points.data() + first[key], static_cast<std::size_t>(first[key + 1] - first[key])};
    }
};

/// Groups photons by key_of(photon), which is below key_count.  A counting sort: O(n + keys).
template <typename KeyOf>
PhotonGroups group_photons(const std::vector<Photon>& photons, std::size_t key_count,
                           const KeyOf& key_of)
{
    PhotonGroups groups;
    groups.first.assign(key_count + 1, 0);
    for (const Photon& photon : photons)
        ++groups.first[key_of(photon) + 1];
    for (std::size_t k = 0; k < key_count; ++k)
        groups.first[k + 1] += groups.first[k];
    std::vector<std::uint64_t> next(groups.first.begin(), groups.first.end() - 1);
    groups.points.resize(photons.size());
    for (std::size_t i = 0; i < photons.size(); ++i)
        groups.points[next[key_of(photons[i])]++] = {photons[i].position,
                                                     static_cast<std::uint32_t>(i)};
    return groups;
}

} // namespace hipmap
