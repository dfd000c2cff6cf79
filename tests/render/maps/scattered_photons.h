#pragma once

#include "common/math/random.h"
#include "common/math/sampling.h"
#include "common/rays/surface_point.h"
#include "render/maps/find_photons.h"
#include "tests/support/brute_force.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <vector>

namespace hipmap::scattered {

/// Photons spread evenly over random points of random faces, on both sides.
inline std::vector<Photon> make_photons(const TriangleMesh& mesh, std::size_t count,
                                        std::uint64_t seed)
{
    std::vector<Photon> photons;
    for (std::size_t i = 0; i < count; ++i) {
        RandomSequence random(seed, RandomStream::photons, 0, i);
        const auto face =
            static_cast<FaceId>(random.next() * static_cast<float>(mesh.face_count()));
        const SurfacePoint at = surface_point(mesh, face, sample_triangle(random.next2()));
        const bool front = random.next() < 0.7f;
        photons.push_back({at.position, Rgb(random.next()),
                           front ? at.geometric_normal : -at.geometric_normal, face,
                           static_cast<std::uint8_t>(front ? 0 : 1)});
    }
    return photons;
}

inline PhotonQuery query_at(const TriangleMesh& mesh, std::uint64_t i)
{
    RandomSequence random(99, RandomStream::eye_paths, 0, i);
    const auto face = static_cast<FaceId>(random.next() * static_cast<float>(mesh.face_count()));
    const SurfacePoint at = surface_point(mesh, face, sample_triangle(random.next2()));
    return {at.position, at.geometric_normal, face, 0};
}

/// Nearest first; the farthest must have come last.
inline std::vector<Neighbour> sorted(const FoundPhotons& found, const PhotonQuery& query)
{
    std::vector<Neighbour> out;
    for (const std::uint32_t slot : found.slots) {
        const glm::vec3 d = found.map->tree.position(slot) - query.position;
        out.push_back({glm::dot(d, d), slot});
    }
    if (!out.empty()) {
        const std::uint32_t last = out.back().photon;
        std::sort(out.begin(), out.end());
        CHECK(out.back().photon == last);
        CHECK(out.back().distance2 == found.farthest2);
    }
    return out;
}

/// Of the photons of a map those that `passes(slot)` lets through: the k nearest to a query.
template <typename Passes>
std::vector<Neighbour> nearest_by_hand(const PhotonMap& map, const PhotonQuery& query,
                                       std::uint32_t k, const Passes& passes)
{
    std::vector<glm::vec3> positions;
    for (std::uint32_t slot = 0; slot < map.tree.size; ++slot)
        positions.push_back(map.tree.position(slot));
    return brute_force::k_nearest(positions, query.position, k, query.radius, passes);
}

} // namespace hipmap::scattered
