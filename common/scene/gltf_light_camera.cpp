#include "common/scene/gltf_light_camera.h"

#include "common/scene/scene_names.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace hipmap {

namespace {

constexpr double kPiDouble = std::numbers::pi;

/// Unit vector along `v`, whatever its scale; nothing if it has no direction.
std::optional<glm::dvec3> direction_of(const glm::dvec3& v)
{
    const double largest = std::max(std::abs(v.x), std::max(std::abs(v.y), std::abs(v.z)));
    if (!(largest > 0) || !std::isfinite(largest))
        return std::nullopt;
    return glm::normalize(v / largest);
}

/// Lights and cameras look along their node's -Z.
std::optional<glm::dvec3> look_direction(const glm::dmat4& to_world)
{
    return direction_of(-glm::dvec3(to_world[2]));
}

glm::dvec3 any_perpendicular(const glm::dvec3& v)
{
    const glm::dvec3 axis = std::abs(v.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, -1);
    return glm::normalize(axis - v * glm::dot(axis, v));
}

/// The angles of a spot's cones from its axis, radians.
struct ConeAngles {
    double inner, outer;
};

/// Blender's exporter writes an inner angle that is not where Blender's rim begins,
/// docs/light_transport.md (39).
void take_blenders_rim(Look look, ConeAngles& cone, SpotFalloff& falloff)
{
    const bool has_cosine = look == Look::blender_3_4;
    if (has_cosine) // below zero the cosine ends the light
        cone.outer = std::min(cone.outer, kPiDouble / 2);
    const double blend = std::clamp(1 - cone.inner / cone.outer, 0.0, 1.0);
    const double cos_outer = std::cos(cone.outer);
    cone.inner = std::acos(std::min(1.0, cos_outer + (1 - cos_outer) * blend));
    falloff = has_cosine ? SpotFalloff::smooth_cosine : SpotFalloff::smooth;
}

void read_cone(const tinygltf::SpotLight& spot, SceneSpotLight& out, const RawScene& scene,
               const std::string& place)
{
    ConeAngles cone{spot.innerConeAngle, spot.outerConeAngle};
    if (!(cone.outer > 0 && cone.outer < kPiDouble && cone.inner >= 0))
        throw scene_error(scene.path, place,
                          "its cone angles are out of range; set a spot size above 0");
    if (is_blender(scene.look))
        take_blenders_rim(scene.look, cone, out.falloff);
    out.cos_outer = std::min(static_cast<float>(std::cos(cone.outer)), std::nextafter(1.0f, 0.0f));
    // A sharp edge (Blender's blend of 0) still needs room to fall off in.
    out.cos_inner =
        std::max(static_cast<float>(std::cos(cone.inner)), std::nextafter(out.cos_outer, 1.0f));
}

/// Returns W/sr or W/m2 for one unit of the file's intensity, docs/scene.md.  per_raw: for one unit
/// of Blender's own strength.
double watts_of_unit(LightUnits units, double per_raw)
{
    switch (units) {
    case LightUnits::spec:
        return 1.0 / kLumensPerWatt;
    case LightUnits::compat:
        return 1.0;
    case LightUnits::raw:
        return per_raw;
    }
    return 1.0;
}

/// Returns colour times intensity, in the unit of the file.
glm::dvec3 read_intensity(const tinygltf::Light& light, const RawScene& scene,
                          const std::string& place)
{
    const glm::dvec3 colour = light.color.size() == 3
                                  ? glm::dvec3(light.color[0], light.color[1], light.color[2])
                                  : glm::dvec3(1.0);
    if (!(light.intensity >= 0) || !(colour.x >= 0 && colour.y >= 0 && colour.z >= 0))
        throw scene_error(scene.path, place, "power or colour is negative; correct it");
    return colour * light.intensity;
}

bool read_projection(const tinygltf::Camera& camera, RawCamera& out, const RawScene& scene,
                     const std::string& place)
{
    const auto demand = [&](bool good, const char* what) {
        if (!good)
            throw scene_error(scene.path, place,
                              std::string(what) + "; correct the camera and export again");
    };
    if (camera.type == "perspective") {
        const tinygltf::PerspectiveCamera& lens = camera.perspective;
        demand(lens.yfov > 0 && lens.yfov < kPiDouble, "yfov must lie between 0 and pi");
        demand(lens.aspectRatio >= 0, "aspectRatio must not be negative");
        out.tan_half_height = std::tan(0.5 * lens.yfov);
        out.aspect = lens.aspectRatio;
        out.near_clip = lens.znear;
        out.far_clip = lens.zfar;
    } else if (camera.type == "orthographic") {
        const tinygltf::OrthographicCamera& lens = camera.orthographic;
        // Magnifications may be negative by the letter; no sense is given to it.
        out.projection = Projection::orthographic;
        out.half_height = std::abs(lens.ymag);
        demand(out.half_height > 0 && std::abs(lens.xmag) > 0, "xmag and ymag must not be 0");
        out.aspect = std::abs(lens.xmag / lens.ymag);
        out.near_clip = lens.znear;
        out.far_clip = lens.zfar;
    } else {
        return false;
    }
    demand(out.near_clip >= 0, "znear must not be negative");
    demand(out.far_clip == 0 || out.far_clip > out.near_clip, "zfar must be above znear");
    return true;
}

} // namespace

bool add_gltf_light(const tinygltf::Model& model, std::size_t index, const std::string& name,
                    const glm::dmat4& to_world, RawScene& scene)
{
    const tinygltf::Light& light = model.lights[index];
    const std::string place = "light " + quote_name(name);
    const glm::dvec3 position(to_world[3]);
    const auto radiant_intensity = [&] {
        return read_intensity(light, scene, place) *
               watts_of_unit(scene.light_units, 0.25 / kPiDouble);
    };
    const auto direction = [&] {
        const std::optional<glm::dvec3> out = look_direction(to_world);
        if (!out)
            throw scene_error(scene.path, place, "its node has scale 0; set the scale to 1");
        return *out;
    };
    if (light.type == "point") {
        scene.lights.push_back(
            ScenePointLight{.name = name, .position = position, .intensity = radiant_intensity()});
    } else if (light.type == "spot") {
        SceneSpotLight spot;
        spot.name = name;
        read_cone(light.spot, spot, scene, place);
        spot.position = position;
        spot.intensity = radiant_intensity();
        spot.direction = direction();
        scene.lights.push_back(spot);
    } else if (light.type == "directional") {
        SceneSunLight sun;
        sun.name = name;
        sun.irradiance =
            read_intensity(light, scene, place) * watts_of_unit(scene.light_units, 1.0);
        sun.direction = direction();
        scene.lights.push_back(sun);
    } else {
        scene.audit.warnings.push_back(place + " is of the unknown kind " + quote_name(light.type) +
                                       " and is skipped");
        return false;
    }
    return true;
}

bool add_gltf_camera(const tinygltf::Model& model, std::size_t index, const std::string& name,
                     const glm::dmat4& to_world, RawScene& scene)
{
    const std::string place = "camera " + quote_name(name);
    RawCamera out;
    out.name = name;
    if (!read_projection(model.cameras[index], out, scene, place)) {
        scene.audit.warnings.push_back(place + " is of the unknown kind " +
                                       quote_name(model.cameras[index].type) + " and is skipped");
        return false;
    }
    const std::optional<glm::dvec3> forward = look_direction(to_world);
    if (!forward)
        throw scene_error(scene.path, place, "its node has scale 0; set the scale to 1");
    const glm::dvec3 y = direction_of(glm::dvec3(to_world[1])).value_or(glm::dvec3(0, 1, 0));
    out.forward = *forward;
    out.up =
        direction_of(y - *forward * glm::dot(y, *forward)).value_or(any_perpendicular(*forward));
    // Twice: of two nearly parallel axes the first difference is mostly rounding.
    out.up = glm::normalize(out.up - *forward * glm::dot(out.up, *forward));
    out.right = glm::cross(out.forward, out.up);
    out.position = glm::dvec3(to_world[3]);
    scene.cameras.push_back(out);
    return true;
}

} // namespace hipmap
