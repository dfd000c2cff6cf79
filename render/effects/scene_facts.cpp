#include "render/effects/scene_facts.h"

#include "common/scene/named_lights.h"
#include "common/scene/scene_names.h"
#include "render/effects/convex_solid.h"
#include "render/media/nested_dielectrics.h"
#include "render/shading/opacity.h"

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

namespace {

/// No light goes on behind any face.
bool is_opaque(const SceneFacts& facts)
{
    for (std::size_t m = 0; m < facts.worn.size(); ++m) {
        const Material& material = facts.scene.materials[m];
        const Bsdf& bsdf = facts.bsdfs[m];
        if (facts.worn[m] != 0 &&
            (!material.boundary || material.holds_medium() || bsdf.transmits ||
             bsdf.transmits_diffusely || may_let_light_pass(facts.scene, material)))
            return false;
    }
    return true;
}

bool shows_lone_convex_solid(const SceneFacts& facts, const Partition& partition)
{
    const Scene& scene = facts.scene;
    return is_convex_solid(scene.mesh, partition) && is_opaque(facts) && scene.around.is_clear() &&
           sees_from_outside(scene.cameras[scene.camera], scene.mesh);
}

} // namespace

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
    facts.lone_convex = shows_lone_convex_solid(facts, partition);
    return facts;
}

} // namespace hipmap
