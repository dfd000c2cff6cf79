#include "render/effects/scene_facts.h"

#include "common/scene/named_lights.h"
#include "common/scene/scene_names.h"
#include "render/media/nested_dielectrics.h"

#include <algorithm>

namespace hipmap {

std::string SceneFacts::materials_where(
    const std::function<bool(const Material&, const Bsdf&, bool)>& holds) const
{
    std::vector<std::string> names;
    for (std::size_t m = 0; m < scene.materials.size(); ++m)
        if (worn[m] != 0 && holds(scene.materials[m], bsdfs[m], solid[m] != 0))
            names.push_back(scene.materials[m].name);
    return list_names(names);
}

SceneFacts gather_facts(const Scene& scene, const Partition& partition)
{
    const std::size_t materials = scene.materials.size();
    SceneFacts facts{
        scene, make_bsdfs(scene.materials), {}, {}, nested_dielectrics(scene, partition)};
    facts.worn.assign(materials, 0);
    facts.solid.assign(materials, 0);
    for (FaceId face = 0; face < scene.mesh.face_count(); ++face) {
        const MaterialId material = scene.mesh.material_of(face);
        if (!(face_area(scene.mesh, face) > 0))
            continue;
        facts.worn[material] = 1;
        if (partition.is_closed(face))
            facts.solid[material] = 1;
        facts.has_light = facts.has_light || !is_black(scene.materials[material].emission) ||
                          !is_black(scene.materials[material].medium_emission);
    }
    const std::vector<NamedLight> lights = named_lights(scene.lights);
    facts.has_light = facts.has_light || !is_black(scene.environment) ||
                      !scene.environment_map_file.empty() || scene.around.emits() ||
                      std::any_of(lights.begin(), lights.end(),
                                  [](const NamedLight& light) { return light.emits; });
    return facts;
}

} // namespace hipmap
