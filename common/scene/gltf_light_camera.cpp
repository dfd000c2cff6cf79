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

/// Blender's exporter writes an inner angle that is not where Blender's rim begins,
/// docs/light_transport.md (39).
void take_blenders_rim(Look look, RawLight& out)
{
    const bool has_cosine = look == Look::blender_3_4;
    if (has_cosine) // below zero the cosine ends the light
        out.outer_angle = std::min(out.outer_angle, kPiDouble / 2);
    const double blend = std::clamp(1 - out.inner_angle / out.outer_angle, 0.0, 1.0);
    const double cos_outer = std::cos(out.outer_angle);
    out.inner_angle = std::acos(std::min(1.0, cos_outer + (1 - cos_outer) * blend));
    out.falloff = has_cosine ? SpotFalloff::smooth_cosine : SpotFalloff::smooth;
}

void read_cone(const tinygltf::Light& light, RawLight& out, const RawScene& scene,
               const std::string& place)
{
    out.inner_angle = light.spot.innerConeAngle;
    out.outer_angle = light.spot.outerConeAngle;
    if (!(out.outer_angle > 0 && out.outer_angle < kPiDouble && out.inner_angle >= 0))
        throw scene_error(scene.path, place,
                          "its cone angles are out of range; set a spot size above 0");
    if (is_blender(scene.look))
        take_blenders_rim(scene.look, out);
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
    RawLight out;
    out.name = name;
    if (light.type == "point") {
        out.kind = LightKind::point;
    } else if (light.type == "spot") {
        out.kind = LightKind::spot;
        read_cone(light, out, scene, place);
    } else if (light.type == "directional") {
        out.kind = LightKind::directional;
    } else {
        scene.audit.warnings.push_back(place + " is of the unknown kind " + quote_name(light.type) +
                                       " and is skipped");
        return false;
    }
    const glm::dvec3 colour = light.color.size() == 3
                                  ? glm::dvec3(light.color[0], light.color[1], light.color[2])
                                  : glm::dvec3(1.0);
    if (!(light.intensity >= 0) || !(colour.x >= 0 && colour.y >= 0 && colour.z >= 0))
        throw scene_error(scene.path, place,
                          "its power and colour must not be negative; correct them");
    out.intensity = colour * light.intensity;
    out.position = glm::dvec3(to_world[3]);
    const std::optional<glm::dvec3> direction = look_direction(to_world);
    if (!direction && out.kind != LightKind::point)
        throw scene_error(scene.path, place, "its node has scale 0; set the scale to 1");
    out.direction = direction.value_or(out.direction);
    scene.lights.push_back(out);
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
