#include "common/rays/camera_ray.h"
#include "common/scene/scene_names.h"
#include "render/effects/effect_findings.h"
#include "render/shading/material_traits.h"

namespace hipmap {

namespace {

constexpr const char* kDark = "nothing shines";

std::string gathering_materials(const SceneFacts& facts)
{
    return facts.materials_where(
        [](const Material&, const Bsdf& bsdf, bool) { return bsdf.gathers(); });
}

/// Lamps with a size, which only the file knows of.
std::string sized_lamps(const Scene& scene)
{
    std::vector<std::string> names;
    for (const PunctualLight& light : scene.lights)
        if (light.radius > 0 || light.half_angle > 0)
            names.push_back(light.name);
    for (const AreaLight& light : scene.area_lights)
        names.push_back(light.name);
    return names.empty()
               ? ""
               : "; the size of " + list_names(names) + " is in the file, not rendered yet";
}

} // namespace

Finding not_rendered_yet(const std::string& names, const char* without)
{
    return {false, names.empty() ? without : "in the file (" + names + "), not rendered yet", ""};
}

Finding find_soft_shadows(const SceneFacts& facts)
{
    std::string lights = facts.materials_where(
        [](const Material& material, const Bsdf&, bool) { return !is_black(material.emission); });
    if (!is_black(facts.scene.environment))
        lights += lights.empty() ? "the sky" : " and the sky";
    const std::string lamps = sized_lamps(facts.scene);
    if (lights.empty())
        return {false, (facts.shines ? "all light comes from points and suns" : kDark) + lamps, ""};
    return {true, "light comes from the whole of " + lights + lamps,
            "a shadow ray to a point drawn on what glows, from each surface"};
}

Finding find_indirect(const SceneFacts& facts)
{
    if (!facts.shines)
        return {false, kDark, ""};
    const std::string names = gathering_materials(facts);
    if (names.empty())
        return {false, "no surface scatters light to others", ""};
    return {true, names + " scatter light to what is around",
            "the light paths, the global and the indirect map, a gather ray for each sample"};
}

Finding find_caustics(const SceneFacts& facts)
{
    const std::string names =
        facts.materials_where([](const Material& material, const Bsdf& bsdf, bool) {
            return may_be_specular(material, bsdf);
        });
    if (names.empty())
        return {false, "no surface is specular", ""};
    if (!facts.shines)
        return {false, "no specular surface is lit", ""};
    if (gathering_materials(facts).empty())
        return {false, "no surface gathers what specular ones send on", ""};
    return {true, "light reaches other surfaces by way of " + names,
            "light paths aimed at them, a quarter as many as the others, and the caustic map"};
}

Finding find_environment(const SceneFacts& facts)
{
    if (!facts.scene.environment_picture.empty())
        return {!is_black(facts.scene.environment),
                "a picture of the sky is in the file, not rendered yet", "a uniform sky instead"};
    if (is_black(facts.scene.environment))
        return {false, "the sky is dark", ""};
    return {true, "the sky shines evenly", "light paths from it; rays that leave the scene see it"};
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
            "a random point of it for each sample"};
}

Finding find_motion_blur(const SceneFacts&)
{
    return {false, "the file says nothing of a shutter; everything is shown at rest", ""};
}

} // namespace hipmap
