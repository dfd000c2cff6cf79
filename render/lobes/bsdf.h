#pragma once

#include "render/lobes/lobe.h"

#include <array>
#include <span>

namespace hipmap {

/// A material at a point, ready for shading: its lobes, the layers over them, and its emission.
/// docs/light_transport.md (1)-(4).  Interaction holds what depends on the position and the view.
struct Bsdf {
    /// The most lobes of a surface: a diffuse lobe, diffuse transmission, a reflection and its
    /// mirror's part, sheen, and a clear coat or glass.
    static constexpr std::size_t kMostLobes = 6;

    std::array<PlacedLobe, kMostLobes> all;
    std::uint8_t count = 0;
    std::array<std::uint8_t, 3> counts{}; ///< [Lobes] how many are handled so
    std::array<std::uint8_t, 3> last{};   ///< [Lobes] place in `all` of the last of them

    // What follows from the lobes, kept by `add`.
    bool gathers = false;             ///< photons are stored here
    bool follows = false;             ///< a direction is drawn to follow the path
    bool is_specular = false;         ///< some light goes on in one direction
    bool transmits = false;           ///< some lobe is a dielectric that transmits
    bool transmits_diffusely = false; ///< light is scattered to the other side
    bool is_directed = false;         ///< some lobe depends on the tangent
    bool is_separable = true;         ///< gathered lobes depend on no direction, layers apart
    bool is_diffuse = false; ///< a diffuse lobe, which may be black, is all: no layers either

    Layers layers;
    Rgb diffuse{0.0f}; ///< reflectance of the diffuse lobe, albedo where there are no layers
    Rgb diffuse_transmitted{0.0f}; ///< transmittance of the diffuse transmission
    float ior = 1.5f;              ///< of the dielectric
    float dispersion = 0.0f;       ///< 20 / Abbe number of that; 0: colours go the same way
    bool rough_glass = false;      ///< the dielectric's facets are rough
    Rgb absorption{0.0f};          ///< inside, per scene unit
    Rgb emission{0.0f};            ///< radiance, W/(m2 sr)
    bool emits_behind = false;

    std::span<const PlacedLobe> lobes() const { return {all.data(), count}; }

    /// Returns the only lobe that is handled so; null if there are none or several.
    const PlacedLobe* single(Lobes handled) const
    {
        const auto set = static_cast<std::size_t>(handled);
        return counts[set] == 1 ? &all[last[set]] : nullptr;
    }
};

/// Adds a lobe; there must be room.
void add(const PlacedLobe& lobe, Bsdf& bsdf);

/// Returns whether an opaque surface or its clear coat reflects light that is handled so; the
/// diffuse lobe and sheen do not count.
bool reflects(const Bsdf& bsdf, Lobes handled);

/// Returns whether an opaque surface or its clear coat reflects some light in one direction alone.
inline bool has_mirror(const Bsdf& bsdf)
{
    return reflects(bsdf, Lobes::specular);
}

/// Returns whether there is a reflection below a clear coat, of any width.
bool has_reflection(const Bsdf& bsdf);

} // namespace hipmap
