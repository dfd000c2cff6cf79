#pragma once

#include "common/scene/light_path_rules.h"
#include "common/scene/scene.h"

namespace hipmap {

/// What a material does to light on average: its factors times the means of its textures.
struct MeanMaterial {
    Rgb base_color{1.0f};
    Rgb emission{0.0f}; ///< radiance, W/(m2 sr)
    bool emits_behind = false;
    float opaque = 0.0f;  ///< share that has a diffuse base
    float glass = 0.0f;   ///< share that transmits
    float through = 0.0f; ///< share of the diffuse base that scatters to the other side
    Rgb through_color{1.0f};
    Rgb reflectance{0.0f};  ///< at normal incidence
    float grazing = 0.0f;   ///< reflectance at grazing incidence
    float roughness = 1.0f; ///< of the reflection
    float clearcoat = 0.0f; ///< share that has a clear coat
    float coat_roughness = 0.0f;
    float ior = 1.5f;
    Rgb absorption{0.0f}; ///< of the inside, per scene unit
    float opacity = 1.0f; ///< share of light that the surface stops
    bool boundary = true; ///< false: rays go on
};

/// Returns the means of all materials, [M].  Textures count with 256 points each, and vertex
/// colours as white. Cost: linear in materials.
std::vector<MeanMaterial> mean_materials(const Scene& scene);

/// Returns whether `render` stores photons on the surface.
bool stores_photons(const MeanMaterial& material);

/// Returns whether light goes on from the surface in one direction, or nearly so: such surfaces
/// make caustics.
bool makes_caustics(const MeanMaterial& material);

} // namespace hipmap
