#include "render/shading/render_scene.h"

#include "render/shading/material_traits.h"

namespace hipmap {

RenderScene::RenderScene(const Scene& from_scene, const Partition& from_partition)
    : scene(from_scene), partition(from_partition), rays(from_scene.mesh),
      bsdfs(make_bsdfs(from_scene.materials, from_scene.diffuse_model)),
      lights(collect_lights(from_scene.mesh, from_scene, bsdfs))
{
    for (const Material& material : scene.materials)
        varying.push_back(varies(material));
    for (const MaterialId material : mesh().material_of_face)
        directional =
            directional || may_gather_by_direction(scene.materials[material], bsdfs[material]);
}

} // namespace hipmap
