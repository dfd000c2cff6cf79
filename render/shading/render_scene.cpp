#include "render/shading/render_scene.h"

namespace hipmap {

RenderScene::RenderScene(const Scene& from_scene, const Partition& from_partition)
    : scene(from_scene), partition(from_partition), rays(from_scene.mesh),
      bsdfs(make_bsdfs(from_scene.materials, from_scene.diffuse_model)),
      lights(collect_lights(from_scene.mesh, from_scene, bsdfs))
{
    for (const Material& material : scene.materials)
        varying.push_back(varies(material));
}

} // namespace hipmap
