#pragma once

#include "render/lobes/bsdf.h"

#include <array>
#include <cstdint>

namespace hipmap {

/// The most directions of a batch.
inline constexpr std::size_t kBatch = 64;

/// Unit directions away from a surface, by lane.  Lanes beyond those in use may hold anything.
struct alignas(64) DirectionBatch {
    std::array<float, kBatch> x, y, z;

    glm::vec3 at(std::size_t lane) const { return {x[lane], y[lane], z[lane]}; }
};

/// Colours by lane.
struct alignas(64) RgbBatch {
    std::array<float, kBatch> r, g, b;

    Rgb at(std::size_t lane) const { return {r[lane], g[lane], b[lane]}; }
    void set(std::size_t lane, const Rgb& to) { r[lane] = to.r, g[lane] = to.g, b[lane] = to.b; }
};

/// The lobes of a surface that are handled alike, seen from one direction.  Borrows the material.
struct SeenLobes {
    const Bsdf& bsdf;
    Lobes handled;
    LobeView view;           ///< of all lobes but a clear coat with a normal of its own
    glm::vec3 normal;        ///< geometric, on the side of the view
    std::array<Rgb, 4> seen; ///< [Depth] what layers leave on the way to the view
};

/// Returns whether weigh_batch knows the lobes and the layers: those of most materials.
bool can_weigh_batch(const SeenLobes& lobes);

/// Writes to the first `count` lanes of `out` what PhotonLobes returns for each direction, the same
/// bits, by the widest instructions that the processor has.  Returns the lanes left out, as bits:
/// directions below the shading normal, or whose light is folded.  Only if can_weigh_batch.
/// count: 1 to kBatch.
std::uint64_t weigh_batch(const SeenLobes& lobes, const DirectionBatch& in, std::size_t count,
                          RgbBatch& out);

} // namespace hipmap
