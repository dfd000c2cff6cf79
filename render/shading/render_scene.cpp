#include "render/shading/render_scene.h"

namespace hipmap {

namespace {

/// Whether any point of the material may gather by a lobe that is not separable.  Textures only
/// multiply, so that its roughness is nowhere above its factor.
bool is_directional(const Material& material, const Bsdf& bsdf)
{
    if (bsdf.burley_roughness >= 0)
        return true;
    const bool may_reflect =
        material.metallic > 0 || material.specular * max_channel(material.specular_color) > 0;
    return !is_followed(material.roughness) &&
           (bsdf.reflection != Reflection::none || (varies(material) && may_reflect));
}

} // namespace

RenderScene::RenderScene(const Scene& from_scene, const Partition& from_partition)
    : scene(from_scene), partition(from_partition), rays(from_scene.mesh),
      bsdfs(make_bsdfs(from_scene.materials, from_scene.diffuse_model)),
      lights(collect_lights(from_scene.mesh, from_scene, bsdfs))
{
    for (const Material& material : scene.materials)
        varying.push_back(varies(material));
    for (const MaterialId material : mesh().material_of_face)
        directional = directional || is_directional(scene.materials[material], bsdfs[material]);
}

} // namespace hipmap
