#pragma once

#include "common/scene/scene.h"

namespace hipmap {

/// The part of a material that textures may make differ from point to point.
struct MaterialPoint {
    Rgb base_color{1.0f};
    float metallic = 1.0f;
    float roughness = 1.0f;
    float transmission = 0.0f;
};

/// The material's factors alone.
MaterialPoint material_factors(const Material& material);

/// Whether textures of the kind are rendered.
bool is_rendered(TextureUse use);

/// Whether a material differs from point to point in what a MaterialPoint holds.
bool varies(const Material& material);

/// The factors times textures at a point of a face.
/// barycentric: weights of the second and third corner.  Thread-safe.  Cost: some texture reads.
MaterialPoint material_at(const Scene& scene, FaceId face, const glm::vec2& barycentric);

/// Alpha there: the factor times the base colour's picture and the vertices' alpha, 0 to 1.
float alpha_at(const Scene& scene, FaceId face, const glm::vec2& barycentric);

} // namespace hipmap
