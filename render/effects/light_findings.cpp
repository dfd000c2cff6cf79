#include "common/rays/camera_ray.h"
#include "common/scene/named_lights.h"
#include "common/scene/scene_names.h"
#include "render/effects/effect_findings.h"
#include "render/shading/material_traits.h"

namespace hipmap {

namespace {

constexpr const char* kDark = "the scene has no light";
constexpr const char* kConvex = "the scene is one convex solid, no point of which lights another";

std::string gathering_materials(const SceneFacts& facts)
{
    return facts.materials_where(
        [](const Material&, const Bsdf& bsdf, bool) { return bsdf.gathers; });
}

/// What moves may not stay convex.
bool lights_itself(const SceneFacts& facts)
{
    return !facts.lone_convex || !facts.moving.empty();
}

/// Names of the lights that emit and have a size.
std::vector<std::string> lights_with_size(const SceneFacts& facts)
{
    std::vector<std::string> out;
    for (const NamedLight& light : named_lights(facts.scene.lights))
        if (light.emits && light.has_size)
            out.push_back(light.name);
    return out;
}

} // namespace

Finding find_soft_shadows(const SceneFacts& facts)
{
    std::string lights = facts.materials_where(
        [](const Material& material, const Bsdf&, bool) { return !is_black(material.emission); });
    const auto add = [&lights](const std::string& more) {
        if (!more.empty())
            lights += (lights.empty() ? "" : " and ") + more;
    };
    const std::vector<std::string> with_size = lights_with_size(facts);
    if (!with_size.empty())
        add("the lights " + list_names(with_size));
    if (!is_black(facts.scene.environment) || !facts.scene.environment_map_file.empty())
        add("the environment");
    if (lights.empty())
        return {false, facts.has_light ? "all lights are points or suns without size" : kDark, ""};
    return {true, "light comes from the area of " + lights,
            "a shadow ray to a random point of the lights, at each surface"};
}

Finding find_indirect(const SceneFacts& facts)
{
    if (!facts.has_light)
        return {false, kDark, ""};
    const std::string names = gathering_materials(facts);
    if (names.empty())
        return {false, "no surface scatters light", ""};
    if (!lights_itself(facts))
        return {false, kConvex, ""};
    return {true, names + " scatter light to other surfaces",
            "light paths, the global and the indirect map, a final-gather ray for each sample; or "
            "longer eye paths, where a pilot finds them enough (--indirect-by)"};
}

Finding find_caustics(const SceneFacts& facts)
{
    const std::string names =
        facts.materials_where([](const Material& material, const Bsdf& bsdf, bool) {
            return may_be_specular(material, bsdf);
        });
    if (names.empty())
        return {false, "no surface is specular", ""};
    if (!facts.has_light)
        return {false, "no specular surface is lit", ""};
    if (gathering_materials(facts).empty())
        return {false, "no surface gathers the light of specular ones", ""};
    if (!lights_itself(facts))
        return {false, kConvex, ""};
    return {true, "specular surfaces send light to others: " + names,
            "light paths aimed at them, a quarter as many as the others, and the caustic map"};
}

Finding find_environment(const SceneFacts& facts)
{
    if (!facts.scene.environment_map_file.empty())
        return {
            true, "the scene has an environment map",
            "light paths from it, a shadow ray towards it, a lookup for rays that leave the scene"};
    if (is_black(facts.scene.environment))
        return {false, "no light comes from the environment", ""};
    return {true, "the environment emits uniform light",
            "light paths from it, its light on rays that leave the scene"};
}

Finding find_depth_of_field(const SceneFacts& facts)
{
    const Camera& camera = facts.scene.cameras[facts.scene.camera];
    if (!has_lens(camera))
        return {false,
                camera.aperture_radius > 0 ? "the camera has a lens, but no focus_distance"
                                           : "the camera is a pinhole",
                ""};
    return {true, "the camera " + quote_name(camera.name) + " has a lens",
            "a random point on the lens for each sample"};
}

Finding find_motion_blur(const SceneFacts& facts)
{
    if (!facts.shutter)
        return {false, "the shutter time is 0 (--shutter)", ""};
    if (facts.moving.empty())
        return {false, "nothing moves while the shutter is open", ""};
    return {true,
            list_names(facts.moving) + (facts.moving.size() == 1 ? " moves" : " move") +
                " while the shutter is open",
            "building the scene again for each pass, which shows one moment"};
}

} // namespace hipmap
