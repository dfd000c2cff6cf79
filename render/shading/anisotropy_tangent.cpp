#include "render/shading/anisotropy_tangent.h"

#include "render/shading/texture_axes.h"
#include "render/shading/textured_material.h"

#include <cmath>

namespace hipmap {

namespace {

/// The texture that says in which directions axes run where the file has no tangents.
TextureSlot leading_slot(const Material& material)
{
    for (const TextureUse use : {TextureUse::anisotropy, TextureUse::normal})
        if (const TextureSlot* slot = find_texture(material.textures, use))
            return *slot;
    return {};
}

} // namespace

std::optional<glm::vec3> anisotropy_tangent(const Scene& scene, const SurfacePoint& point,
                                            const glm::vec2& barycentric)
{
    const TriangleMesh& mesh = scene.mesh;
    const Material& material = scene.materials[mesh.material_of(point.face)];
    const std::optional<TextureAxes> axes =
        texture_axes(mesh, leading_slot(material), point, barycentric);
    if (!axes)
        return std::nullopt;
    glm::vec2 turned(1, 0);
    const TextureSlot* slot = find_texture(material.textures, TextureUse::anisotropy);
    if (slot != nullptr && !mesh.attributes.uv[slot->uv_set].empty()) {
        const glm::vec2 read =
            2.0f * glm::vec2(read_slot(scene, *slot, point.face, barycentric)) - 1.0f;
        if (glm::dot(read, read) > 0)
            turned = glm::normalize(read);
    }
    const float c = std::cos(material.anisotropy_rotation),
                s = std::sin(material.anisotropy_rotation);
    return (turned.x * c - turned.y * s) * axes->right + (turned.x * s + turned.y * c) * axes->up;
}

} // namespace hipmap
