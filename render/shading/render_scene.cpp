#include "render/shading/render_scene.h"

#include "render/shading/coverage.h"
#include "render/shading/material_traits.h"

#include <algorithm>
#include <utility>

namespace hipmap {

RenderScene::RenderScene(const Scene& from_scene, const Partition& from_partition, SkyPicture sky)
    : scene(from_scene), partition(from_partition), coverage(coverage_of(from_scene)),
      rays(from_scene.mesh, coverage),
      bsdfs(make_bsdfs(from_scene.materials, from_scene.diffuse_model)),
      varying(varying_materials(from_scene)),
      specular_targets(find_specular_targets(from_scene, bsdfs)),
      lights(collect_lights(from_scene, bsdfs)),
      media(collect_media(from_scene, from_partition, rays))
{
    lights.sky = std::move(sky);
    for (const Material& material : scene.materials)
        bumpy.push_back(tilts(material));
    for (std::size_t m = 0; m < scene.materials.size(); ++m)
        plain.push_back(varying[m] == 0 && bumpy[m] == 0 && !bsdfs[m].is_directed && !coverage);
    all_plain = std::all_of(plain.begin(), plain.end(), [](std::uint8_t is) { return is != 0; });
    lit_by_faces = !has_lamps(lights) && !has_sky_picture(lights);
    clear = !media && !has_sized_lamps(lights) &&
            std::all_of(bsdfs.begin(), bsdfs.end(),
                        [](const Bsdf& bsdf) { return is_black(bsdf.absorption); });
    for (const MaterialId material : mesh().material_of_face)
        directional = directional || may_gather_by_direction(scene.materials[material],
                                                             bsdfs[material], scene.diffuse_model);
}

Rgb emission_at(const RenderScene& scene, FaceId face, const glm::vec2& barycentric)
{
    const MaterialId material = scene.mesh().material_of_face[face];
    const Rgb& factor = scene.bsdfs[material].emission;
    return scene.varying[material] == 0 || is_black(factor)
               ? factor
               : material_at(scene.scene, face, barycentric).emission;
}

Rgb pictured_radiance(const RenderScene& scene, const EmissivePoint& light)
{
    const FaceId face = light.surface.face;
    const Rgb radiance = emission_at(scene, face, light.barycentric);
    return scene.coverage ? radiance * scene.coverage(face, light.barycentric) : radiance;
}

} // namespace hipmap
