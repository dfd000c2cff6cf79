#include "render/shading/render_scene.h"

#include "render/shading/material_traits.h"
#include "render/shading/opacity.h"

#include <algorithm>
#include <utility>

namespace hipmap {

namespace {

/// Borrows the scene, of which all but the lights and what follows them is there.
SurfaceEmission surface_emission_of(const RenderScene& scene)
{
    SurfaceEmission out;
    out.mesh = &scene.mesh();
    for (std::size_t m = 0; m < scene.bsdfs.size(); ++m) {
        const Bsdf& bsdf = scene.bsdfs[m];
        const bool textured = scene.varying[m] != 0 || scene.opacity;
        out.materials.push_back({bsdf.emission, bsdf.emits_behind, textured});
    }
    out.at = [&scene](FaceId face, const glm::vec2& barycentric) {
        const Rgb radiance = emission_at(scene, face, barycentric);
        return scene.opacity ? radiance * scene.opacity(face, barycentric) : radiance;
    };
    out.mean = [&scene](FaceId face) {
        const MaterialId material = scene.mesh().material_of(face);
        return scene.varying[material] == 0 ? scene.bsdfs[material].emission
                                            : mean_emission(scene.scene, face);
    };
    return out;
}

} // namespace

RenderScene::RenderScene(const Scene& from_scene, const Partition& from_partition,
                         EnvironmentMap map)
    : scene(from_scene), partition(from_partition), opacity(opacity_of(from_scene)),
      rays(from_scene.mesh, opacity), bsdfs(make_bsdfs(from_scene.materials)),
      varying(varying_materials(from_scene)),
      specular_targets(find_specular_targets(from_scene, bsdfs)),
      media(collect_media(from_scene, from_partition, rays)), environment_map(std::move(map)),
      surface_emission(surface_emission_of(*this)),
      lights(
          collect_lights(scene, {surface_emission, &environment_map, media ? &*media : nullptr})),
      enclosed_lights(find_enclosed_lights(lights, specular_targets))
{
    for (const Material& material : scene.materials)
        bumpy.push_back(tilts(material));
    for (std::size_t m = 0; m < scene.materials.size(); ++m)
        plain.push_back(varying[m] == 0 && bumpy[m] == 0 && !bsdfs[m].is_directed && !opacity);
    all_plain = std::all_of(plain.begin(), plain.end(), [](std::uint8_t is) { return is != 0; });
    lit_by_faces = has_faces_only(lights);
    clear = !media && !has_met_lights(lights) &&
            std::all_of(bsdfs.begin(), bsdfs.end(),
                        [](const Bsdf& bsdf) { return is_black(bsdf.absorption); });
    for (const MaterialId material : mesh().material_of_face)
        directional =
            directional || may_gather_by_direction(scene.materials[material], bsdfs[material]);
}

Rgb emission_at(const RenderScene& scene, FaceId face, const glm::vec2& barycentric)
{
    const MaterialId material = scene.mesh().material_of(face);
    const Rgb& factor = scene.bsdfs[material].emission;
    return scene.varying[material] == 0 || is_black(factor)
               ? factor
               : material_at(scene.scene, face, barycentric).emission;
}

} // namespace hipmap
