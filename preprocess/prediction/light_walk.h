#pragma once

#include "common/partition/partition.h"
#include "preprocess/prediction/light_starts.h"

#include <functional>

namespace hipmap {

/// The photon maps of `render` that a photon can go to.
enum class PhotonKind : std::uint8_t {
    indirect, ///< after a diffuse bounce
    caustic,  ///< after mirrors and glass alone
};

/// A photon that `render` would store.
struct LeftPhoton {
    FaceId face = kNone;
    std::uint8_t side = 0; ///< 0 or 1, as `render` tells the sides of a shared map apart
    PhotonKind kind = PhotonKind::indirect;

    auto operator<=>(const LeftPhoton&) const = default;
};

/// What light paths go through.  Borrows all.
struct LightSpace {
    const TriangleMesh& mesh;
    const Partition& partition;
    std::span<const MeanMaterial> materials; ///< [M]
    /// Returns the nearest face; thread-safe.
    std::function<std::optional<RayHit>(const Ray&)> nearest;
};

/// Follows a light path by mean materials until it leaves the scene or Russian roulette ends it,
/// and adds the photons of one kind that it leaves to `out`, in order. Caustic ones end at the
/// first diffuse bounce.  Media are clear, and normal maps are flat.  Thread-safe.
void follow_light(const LightSpace& space, LightStart path, PhotonKind kind, RandomSequence& random,
                  std::vector<LeftPhoton>& out);

} // namespace hipmap
