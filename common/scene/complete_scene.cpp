#include "common/scene/complete_scene.h"

#include "common/scene/framing_camera.h"
#include "common/scene/named_lights.h"
#include "common/scene/raw_scene.h"
#include "common/scene/scene_names.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace hipmap {

namespace {

constexpr float kSkyRadiance = 1.0f; ///< W/(m2 sr), of a scene without light

void choose_camera(LoadedScene& loaded, const SceneOptions& options,
                   const std::filesystem::path& path)
{
    Scene& scene = loaded.scene;
    std::vector<std::string> names;
    for (const Camera& camera : scene.cameras)
        names.push_back(camera.name);
    if (!options.camera.empty()) {
        const auto at = std::find(names.begin(), names.end(), options.camera);
        if (at == names.end())
            throw scene_error(
                path, "--camera " + quote_name(options.camera),
                names.empty()
                    ? "the file has no cameras; export as glTF with Include > Cameras ticked"
                    : "no such camera; choose one of " + list_names(names));
        scene.camera = static_cast<std::size_t>(at - names.begin());
    }
    if (names.empty()) {
        scene.cameras.push_back(framing_camera(scene.mesh));
        loaded.audit.assumed.push_back(
            "no camera in the file: using one that frames everything, from " +
            scene.cameras[0].name + "; export as glTF with Include > Cameras ticked");
    } else if (names.size() == 1) {
        loaded.audit.found.push_back("camera " + quote_name(names[0]));
    } else {
        loaded.audit.found.push_back(
            counted(names.size(), "camera") + ": " + list_names(names) + "; using " +
            quote_name(names[scene.camera]) +
            (options.camera.empty() ? " (--camera NAME selects another)" : ""));
    }
}

/// [M] how many faces with an area wear each material.
std::vector<std::size_t> count_material_faces(const Scene& scene)
{
    using Counts = std::vector<std::size_t>;
    return tbb::parallel_reduce(
        tbb::blocked_range<std::size_t>(0, scene.mesh.face_count(), 1 << 14),
        Counts(scene.materials.size(), 0),
        [&](const auto& range, Counts counts) {
            for (std::size_t face = range.begin(); face < range.end(); ++face)
                if (face_area(scene.mesh, static_cast<FaceId>(face)) > 0)
                    ++counts[scene.mesh.material_of_face[face]];
            return counts;
        },
        [](Counts a, const Counts& b) {
            std::ranges::transform(a, b, a.begin(), std::plus());
            return a;
        });
}

/// Lists the lights that emit, those of a kind together, and the others in `dark`.  Returns whether
/// any emits.
bool note_analytic_lights(const Scene& scene, std::vector<std::string>& dark, SceneAudit& audit)
{
    const std::vector<NamedLight> lights = named_lights(scene.lights);
    bool emits = false;
    for (std::size_t begin = 0, end = 0; begin < lights.size(); begin = end) {
        std::vector<std::string> names;
        for (; end < lights.size() && lights[end].kind == lights[begin].kind; ++end)
            (lights[end].emits ? names : dark).push_back(lights[end].name);
        if (!names.empty())
            audit.found.push_back(std::string(lights[begin].kind) + " " + list_names(names));
        emits = emits || !names.empty();
    }
    return emits;
}

/// Lists what emits; whether anything does.
bool note_lights(const Scene& scene, const std::vector<std::size_t>& faces, SceneAudit& audit)
{
    std::vector<std::string> dark;
    bool has_light = note_analytic_lights(scene, dark, audit);
    std::vector<std::string> emissive, faceless;
    std::size_t emissive_faces = 0;
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        if (is_black(scene.materials[i].emission))
            continue;
        (faces[i] == 0 ? faceless : emissive).push_back(scene.materials[i].name);
        emissive_faces += faces[i];
    }
    has_light = has_light || !emissive.empty();
    if (!emissive.empty())
        audit.found.push_back("emissive material " + list_names(emissive) + " on " +
                              counted(emissive_faces, "face"));
    for (std::size_t i = 0; i < scene.materials.size(); ++i)
        if (!is_black(scene.materials[i].medium_emission) && faces[i] > 0) {
            audit.found.push_back("emissive medium in " + quote_name(scene.materials[i].name));
            has_light = true;
        }
    if (scene.around.emits()) {
        audit.found.push_back("emissive medium around the scene");
        has_light = true;
    }
    if (!dark.empty())
        audit.warnings.push_back("light without power: " + list_names(dark));
    if (!faceless.empty())
        audit.warnings.push_back("emissive material " + list_names(faceless) +
                                 " is on no face, so it gives no light: assign it to the faces of "
                                 "the lamp");
    return has_light;
}

void choose_sky(LoadedScene& loaded, bool has_light, const SceneOptions& options)
{
    if (options.environment)
        loaded.scene.environment_map_file.clear();
    if (!loaded.scene.environment_map_file.empty()) {
        loaded.scene.environment = Rgb(0);
        return;
    }
    if (options.environment) {
        loaded.scene.environment = *options.environment;
        if (!has_light && is_black(*options.environment))
            loaded.audit.warnings.push_back("the scene has no light and the sky is dark: the image "
                                            "will be black; see --environment");
        return;
    }
    if (!is_black(loaded.scene.environment)) {
        loaded.audit.found.push_back("sky colour of the scene (world_color)");
        return;
    }
    if (has_light) {
        loaded.audit.assumed.push_back("no sky: the file has none (glTF lacks Blender's world); "
                                       "--environment RADIANCE|FILE adds one");
        return;
    }
    loaded.scene.environment = Rgb(kSkyRadiance);
    loaded.audit.assumed.push_back(
        "no light in the file: using a uniform grey sky of radiance 1 (--environment changes it); "
        "export as glTF with Include > Punctual Lights ticked; Blender exports meshes with an "
        "Emission material, but neither area lights nor the world");
}

void note_materials(const Scene& scene, const std::vector<std::size_t>& faces, SceneAudit& audit)
{
    std::vector<std::string> clear;
    for (std::size_t i = 0; i < scene.materials.size(); ++i)
        if (scene.materials[i].transmission > 0 && faces[i] > 0)
            clear.push_back(scene.materials[i].name);
    if (!clear.empty())
        audit.assumed.push_back("transmissive material " + list_names(clear) +
                                ": solid glass where its mesh is closed, a thin pane where it is "
                                "open");
}

} // namespace

void complete_scene(LoadedScene& loaded, const SceneOptions& options,
                    const std::filesystem::path& path)
{
    Scene& scene = loaded.scene;
    if (scene.materials.empty())
        scene.materials.emplace_back();
    const std::vector<std::size_t> faces = count_material_faces(scene);
    const bool has_light = note_lights(scene, faces, loaded.audit);
    choose_camera(loaded, options, path);
    choose_sky(loaded, has_light, options);
    note_materials(scene, faces, loaded.audit);
}

} // namespace hipmap
