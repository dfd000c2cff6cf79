#include "render/shading/render_scene.h"

#include "render/shading/coverage.h"
#include "render/shading/material_traits.h"

namespace hipmap {

RenderScene::RenderScene(const Scene& from_scene, const Partition& from_partition)
    : scene(from_scene), partition(from_partition), coverage(coverage_of(from_scene)),
      rays(from_scene.mesh, coverage),
      bsdfs(make_bsdfs(from_scene.materials, from_scene.diffuse_model)),
      lights(collect_lights(from_scene.mesh, from_scene, bsdfs))
{
    for (const Material& material : scene.materials)
        varying.push_back(varies(material));
    for (const MaterialId material : mesh().material_of_face)
        directional =
            directional || may_gather_by_direction(scene.materials[material], bsdfs[material]);
}

Rgb light_radiance(const RenderScene& scene, const EmissivePoint& light, const glm::vec3& direction)
{
    const FaceId face = light.surface.face;
    Rgb radiance = emitted_radiance(scene.bsdfs[scene.mesh().material_of_face[face]], light.surface,
                                    direction);
    if (scene.coverage)
        radiance *= scene.coverage(face, light.barycentric);
    return radiance;
}

} // namespace hipmap
