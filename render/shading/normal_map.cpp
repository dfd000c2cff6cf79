#include "render/shading/normal_map.h"

#include "render/shading/texture_axes.h"
#include "render/shading/textured_material.h"

namespace hipmap {

glm::vec3 mapped_normal(const Scene& scene, const SurfacePoint& point, const glm::vec2& barycentric,
                        TextureUse use)
{
    const TriangleMesh& mesh = scene.mesh;
    const glm::vec3& normal = point.shading_normal;
    const Material& material = scene.materials[mesh.material_of(point.face)];
    const TextureSlot* slot = find_texture(material.textures, use);
    if (slot == nullptr || mesh.attributes.uv[slot->uv_set].empty())
        return normal;
    const std::optional<TextureAxes> axes = texture_axes(mesh, *slot, point, barycentric);
    if (!axes)
        return normal;
    const glm::vec3 read =
        2.0f * glm::vec3(read_slot(scene, *slot, point.face, barycentric)) - 1.0f;
    const glm::vec3 tilted =
        slot->strength * (read.x * axes->right + read.y * axes->up) + read.z * normal;
    const float length = glm::length(tilted);
    return length > 0 && glm::dot(tilted, point.geometric_normal) > 0 ? tilted / length : normal;
}

} // namespace hipmap
