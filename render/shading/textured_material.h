#pragma once

#include "common/scene/scene.h"

#include <cstdint>
#include <vector>

namespace hipmap {

/// The part of a material that textures may make differ from point to point.
struct MaterialPoint {
    Rgb base_color{1.0f};
    float metallic = 1.0f;
    float roughness = 1.0f;
    float transmission = 0.0f;
    Rgb emission{0.0f}; ///< radiance, W/(m2 sr)
    float specular = 1.0f;
    Rgb specular_color{1.0f};
    float clearcoat = 0.0f;
    float clearcoat_roughness = 0.0f;
    Rgb sheen_color{0.0f};
    float sheen_roughness = 0.0f;
    float anisotropy = 0.0f;
    float diffuse_transmission = 0.0f;
    Rgb diffuse_transmission_color{1.0f};
};

/// Interpolates a vertex attribute between the corners of a face.
template <typename Value>
Value interpolate(const std::vector<Value>& values, const glm::uvec3& corners,
                  const glm::vec2& barycentric)
{
    return values[corners.x] * (1 - barycentric.x - barycentric.y) +
           values[corners.y] * barycentric.x + values[corners.z] * barycentric.y;
}

/// Samples a texture at a point of a face that has its coordinates: linear, 0 to 1.
glm::vec4 read_slot(const Scene& scene, const TextureSlot& slot, FaceId face,
                    const glm::vec2& barycentric);

/// Returns the material's factors alone.
MaterialPoint material_factors(const Material& material);

/// Returns whether textures of this use are rendered.
bool is_rendered(TextureUse use);

/// Returns whether textures make a material differ from point to point in what a MaterialPoint
/// holds.
bool varies(const Material& material);

/// Returns whether textures tilt the normal of a material or that of its clear coat.
bool tilts(const Material& material);

/// Returns [M] 1 for materials that vary by textures, or by vertex colours of some face.  O(F + M).
std::vector<std::uint8_t> varying_materials(const Scene& scene);

/// Returns the factors times textures and the vertices' colours at a point of a face. barycentric:
/// weights of the second and third corner.  Thread-safe.  Cost: some texture reads.
MaterialPoint material_at(const Scene& scene, FaceId face, const glm::vec2& barycentric);

/// Returns the radiance that a face emits, averaged over it: over as many points as its part of the
/// texture has pixels, 16 to 4096.  Black only if all of them are.
Rgb mean_emission(const Scene& scene, FaceId face);

/// Returns alpha at a point: the factor times the base colour's texture and the vertices' alpha, 0
/// to 1.
float alpha_at(const Scene& scene, FaceId face, const glm::vec2& barycentric);

} // namespace hipmap
