#pragma once

#include "common/partition/check_partition.h"
#include "preprocess/partition/build_partition.h"
#include "tests/support/hard_surfaces.h"

#include <catch2/catch.hpp>

namespace hipmap::tiny {

inline Partition partition_of(const TriangleMesh& mesh)
{
    const Partition p = build_partition(make_scene(mesh), {}).partition;
    REQUIRE(defect_of(p) == "");
    return p;
}

inline double total_length(const Partition& p, MapId map)
{
    double sum = 0;
    for (const MapContact& contact : p.contacts)
        if (contact.map == map)
            sum += glm::distance(glm::dvec3(contact.a), glm::dvec3(contact.b));
    return sum;
}

template <typename Check>
void in_all_poses(const TriangleMesh& mesh, const Check& check)
{
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        TriangleMesh turned = mesh;
        const float scale = std::exp2(static_cast<float>(seed % 41) - 20);
        transform(turned, random_rotation(seed), scale);
        INFO("pose " << seed);
        check(partition_of(turned), static_cast<double>(scale));
    }
}

} // namespace hipmap::tiny
