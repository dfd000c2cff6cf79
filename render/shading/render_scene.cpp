#include "render/shading/render_scene.h"

#include "render/shading/coverage.h"
#include "render/shading/material_traits.h"

#include <utility>

namespace hipmap {

RenderScene::RenderScene(const Scene& from_scene, const Partition& from_partition, SkyPicture sky)
    : scene(from_scene), partition(from_partition), coverage(coverage_of(from_scene)),
      rays(from_scene.mesh, coverage),
      bsdfs(make_bsdfs(from_scene.materials, from_scene.diffuse_model)),
      varying(varying_materials(from_scene)), lights(collect_lights(from_scene, bsdfs)),
      media(collect_media(from_scene, from_partition, rays))
{
    lights.sky = std::move(sky);
    for (const Material& material : scene.materials)
        bumpy.push_back(find_texture(material.textures, TextureUse::normal) != nullptr);
    for (std::size_t m = 0; m < scene.materials.size(); ++m)
        plain.push_back(varying[m] == 0 && bumpy[m] == 0 && !bsdfs[m].is_stretched() && !coverage);
    for (const MaterialId material : mesh().material_of_face)
        directional =
            directional || may_gather_by_direction(scene.materials[material], bsdfs[material]);
}

Rgb emission_at(const RenderScene& scene, FaceId face, const glm::vec2& barycentric)
{
    const MaterialId material = scene.mesh().material_of_face[face];
    const Rgb& factor = scene.bsdfs[material].emission;
    return scene.varying[material] == 0 || is_black(factor)
               ? factor
               : material_at(scene.scene, face, barycentric).emission;
}

namespace {

/// What differs from point to point.  A function of its own, so that lights that do not are spared
/// its registers.
[[gnu::noinline]] Rgb pictured_radiance(const RenderScene& scene, const EmissivePoint& light)
{
    const FaceId face = light.surface.face;
    const Rgb radiance = emission_at(scene, face, light.barycentric);
    return scene.coverage ? radiance * scene.coverage(face, light.barycentric) : radiance;
}

} // namespace

Rgb light_radiance(const RenderScene& scene, const EmissivePoint& light, const glm::vec3& direction)
{
    const FaceId face = light.surface.face;
    const MaterialId material = scene.mesh().material_of_face[face];
    const Bsdf& bsdf = scene.bsdfs[material];
    if (!shines_towards(bsdf, light.surface, direction))
        return Rgb(0);
    return scene.is_plain(material) ? bsdf.emission : pictured_radiance(scene, light);
}

} // namespace hipmap
