#include "common/scene/gltf_extras.h"

#include "common/scene/density_file.h"
#include "common/scene/gltf_light_camera.h"
#include "common/scene/gltf_reflection.h"
#include "common/scene/hipmap_extras.h"
#include "common/scene/ies_file.h"
#include "common/scene/scene_file.h"
#include "common/scene/scene_names.h"

#include <cmath>
#include <numbers>

namespace hipmap {

namespace {

using nlohmann::json;

constexpr double kWidestAngle = 180.0; ///< degrees
constexpr double kMostShift = 100.0;   ///< heights of an image

std::string place_of(const json& thing, const char* kind, std::size_t index)
{
    const std::string name = clean_name(thing.value("name", std::string()));
    return std::string(kind) + " " + quote_name(name.empty() ? std::to_string(index) : name);
}

void read_light_size(HipmapExtras& extras, SceneLight& light)
{
    const std::optional<double> radius = extras.positive("radius");
    const std::optional<double> angle = extras.positive("angle_deg");
    if (angle && *angle > kWidestAngle)
        extras.fail("angle_deg", "must be 180 or less");
    std::visit(
        [&](auto& of_kind) {
            if constexpr (requires { of_kind.radius; })
                of_kind.radius = radius.value_or(of_kind.radius);
            if constexpr (requires { of_kind.half_angle; })
                of_kind.half_angle =
                    angle ? 0.5 * *angle * std::numbers::pi / 180 : of_kind.half_angle;
        },
        light);
}

/// Returns the colour of a light; white if it has none.
glm::dvec3 colour_of(const json& light)
{
    const auto found = light.find("color");
    if (found == light.end() || !found->is_array() || found->size() != 3)
        return glm::dvec3(1.0);
    glm::dvec3 out(1.0);
    for (int c = 0; c < 3; ++c)
        if ((*found)[c].is_number())
            out[c] = (*found)[c].get<double>();
    return out;
}

/// Makes the point light that was added last a light of the photometric web that its extras name.
/// of_file: the light in the file.
void read_profile(HipmapExtras& extras, const json& of_file, const PlacedNode& at, RawScene& scene)
{
    const std::optional<std::string> name = extras.text("ies");
    const std::optional<double> scale = extras.positive("ies_scale");
    if (scale && !name)
        extras.fail("ies_scale", "needs 'ies'");
    if (!name)
        return;
    const auto* const point = std::get_if<ScenePointLight>(&scene.lights.back());
    if (point == nullptr)
        extras.fail("ies",
                    "is for point lights, and only once for each; make the light a point light");
    const std::string place = "light " + quote_name(point->name);
    if (point->radius > 0)
        scene.audit.assumed.push_back(place + ": radius not used, because an IES light is a point");
    SceneIesLight light;
    light.name = point->name;
    light.position = point->position;
    light.direction = -glm::normalize(glm::dvec3(at.to_world[2]));
    const glm::dvec3 down = -glm::dvec3(at.to_world[1]);
    const glm::dvec3 across = down - light.direction * glm::dot(down, light.direction);
    if (!(glm::length(across) > 0))
        extras.fail("ies", "needs an object whose scale is not 0");
    light.start = glm::normalize(across);
    light.intensity = colour_of(of_file) * scale.value_or(1.0) / kLumensPerWatt;
    light.web = read_ies(file_beside(scene.path, place + ", custom property 'hipmap'", *name));
    scene.lights.back() = std::move(light);
}

void read_lens(HipmapExtras extras, RawCamera& camera)
{
    camera.aperture_radius = extras.positive("aperture_radius").value_or(camera.aperture_radius);
    camera.focus_distance = extras.positive("focus_distance").value_or(camera.focus_distance);
    camera.shift.x = extras.within("shift_right", kMostShift).value_or(camera.shift.x);
    camera.shift.y = extras.within("shift_up", kMostShift).value_or(camera.shift.y);
    extras.finish("");
}

PhaseKind phase_named(const std::string& name, HipmapExtras& extras)
{
    if (name == "isotropic")
        return PhaseKind::isotropic;
    if (name == "schlick")
        return PhaseKind::schlick;
    if (name != "henyey-greenstein")
        extras.fail("phase", R"(must be "isotropic", "henyey-greenstein" or "schlick")");
    return PhaseKind::henyey_greenstein;
}

/// Per metre; what no key names stays as it is.  scene: the file, beside which others lie.
void read_medium(HipmapExtras& extras, const std::filesystem::path& scene, const std::string& place,
                 Medium& medium)
{
    constexpr double kMostG = 0.99;
    const auto read = [&](const char* key, Rgb& to) {
        if (const std::optional<glm::dvec3> value = extras.positive_triple(key))
            to = Rgb(*value);
    };
    read("absorption", medium.absorption);
    read("scattering", medium.scattering);
    read("emission", medium.emission);
    const std::optional<double> g = extras.within("g", kMostG);
    const std::optional<std::string> phase = extras.text("phase");
    if (phase || g)
        medium.phase = {phase_named(phase.value_or("henyey-greenstein"), extras),
                        static_cast<float>(g.value_or(0.0))};
    if (medium.phase.kind == PhaseKind::isotropic && medium.phase.g != 0)
        extras.fail("g", "does not apply to the phase \"isotropic\"");
    if (const std::optional<std::string> density = extras.text("density"))
        medium.density = read_density(file_beside(scene, place, *density));
    extras.finish("");
}

/// The beam of an area light without spread: all of its power goes along its axis.
SceneBeamLight beam_of(const SceneAreaLight& area)
{
    return {area.name,
            area.is_disc,
            area.centre,
            area.centre + area.half_right,
            area.centre + area.half_up,
            area.direction,
            std::numbers::pi * area.radiance};
}

} // namespace

void read_light_extras(const GltfDocument& document, const PlacedNode& at, std::size_t light,
                       RawScene& scene)
{
    const std::string place = "light " + quote_name(name_of(scene.lights.back()));
    const json& lights = document.json["extensions"]["KHR_lights_punctual"]["lights"];
    for (const json* from : {&lights[light], &document.json["nodes"][at.node]}) {
        HipmapExtras extras(*from, place, scene);
        read_light_size(extras, scene.lights.back());
        read_profile(extras, lights[light], at, scene);
        extras.finish("");
    }
}

void read_camera_extras(const GltfDocument& document, std::size_t node, std::size_t camera,
                        RawScene& scene)
{
    const std::string place = "camera " + quote_name(scene.cameras.back().name);
    read_lens({document.json["cameras"][camera], place, scene}, scene.cameras.back());
    read_lens({document.json["nodes"][node], place, scene}, scene.cameras.back());
}

void read_empty_extras(const GltfDocument& document, const PlacedNode& at, RawScene& scene)
{
    const json& node = document.json["nodes"][at.node];
    HipmapExtras extras(node, place_of(node, "object", at.node), scene);
    const std::optional<double> power = extras.positive("area_power");
    const std::optional<double> width = extras.positive("area_width");
    const std::optional<double> height = extras.positive("area_height");
    const std::string shape = extras.text("area_shape").value_or("rectangle");
    const glm::dvec3 colour = extras.positive_triple("area_color").value_or(glm::dvec3(1.0));
    const double spread_deg = extras.within("area_spread_deg", 180).value_or(180);
    extras.finish("");
    if (!power && !width && !height)
        return;
    if (spread_deg < 0)
        extras.fail("area_spread_deg", "must be 0 or more");
    if (!power || !width || !(*width > 0) || !(height.value_or(*width) > 0))
        extras.fail("area_power", "and 'area_width' (in metres, above 0) are needed together");
    if (shape != "rectangle" && shape != "disc")
        extras.fail("area_shape", "must be \"rectangle\" or \"disc\"");

    SceneAreaLight light;
    light.name = clean_name(node.value("name", std::string()));
    light.is_disc = shape == "disc";
    light.centre = glm::dvec3(at.to_world[3]);
    light.half_right = 0.5 * *width * glm::dvec3(at.to_world[0]);
    light.half_up = 0.5 * height.value_or(*width) * glm::dvec3(at.to_world[1]);
    const double rectangle = 4 * glm::length(glm::cross(light.half_right, light.half_up));
    const double area = light.is_disc ? rectangle * std::numbers::pi / 4 : rectangle;
    if (!(area > 0))
        extras.fail("area_width", "becomes 0 by the scale of its object");
    const glm::dvec3 across = glm::cross(light.half_right, light.half_up);
    const double side = glm::dot(across, glm::dvec3(at.to_world[2])) > 0 ? -1 : 1;
    light.direction = side * glm::normalize(across);
    light.radiance = colour * (*power / (std::numbers::pi * area));
    light.half_spread = spread_deg * std::numbers::pi / 360;
    if (spread_deg > 0)
        scene.lights.push_back(light);
    else
        scene.lights.push_back(beam_of(light));
}

void read_world_extras(const GltfDocument& document, RawScene& scene)
{
    const auto scenes = document.json.find("scenes");
    if (scenes == document.json.end() || scenes->empty())
        return;
    const json& taken = (*scenes)[document.json.value("scene", std::size_t{0})];
    HipmapExtras extras(taken, "the scene", scene);
    const std::optional<glm::dvec3> colour = extras.positive_triple("world_color");
    const double strength = extras.positive("world_strength").value_or(1.0);
    if (colour)
        scene.world = *colour * strength;
    const std::optional<double> turn = extras.within("world_turn_deg", 360);
    const std::optional<std::string> map_file = extras.text("world_hdri");
    if (map_file) {
        scene.world_map_file =
            file_beside(scene.path, "scene, custom property 'hipmap'", *map_file);
        scene.world_strength = strength;
    }
    if (turn && !map_file)
        extras.fail("world_turn_deg", "needs 'world_hdri'");
    scene.world_turn_deg = turn.value_or(0.0);
    if (std::optional<HipmapExtras> keys = extras.object("medium"))
        read_medium(*keys, scene.path, "scene, custom property 'hipmap'", scene.around);
    extras.finish("");
}

void read_material_extras(const json& from, Material& material, RawScene& scene)
{
    const std::string place = "material " + quote_name(material.name);
    HipmapExtras extras(from, place, scene);
    Medium medium = material.inside();
    if (std::optional<HipmapExtras> keys = extras.object("medium"))
        read_medium(*keys, scene.path, place, medium);
    material.absorption = medium.absorption;
    material.scattering = medium.scattering;
    material.medium_emission = medium.emission;
    material.phase = medium.phase;
    material.density = medium.density;
    material.boundary = extras.flag("boundary").value_or(true);
    if (!material.boundary)
        material.alpha_mode = AlphaMode::opaque; // of a surface that is not there
    material.priority = static_cast<float>(extras.positive("priority").value_or(0.0));
    read_reflection(extras, from, material, scene.audit);
    extras.finish("");
}

} // namespace hipmap
