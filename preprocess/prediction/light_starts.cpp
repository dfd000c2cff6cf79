#include "preprocess/prediction/light_starts.h"

#include "common/math/frame.h"
#include "common/math/sampling.h"
#include "common/math/sphere_cone.h"
#include "common/rays/surface_point.h"
#include "common/scene/light_path_rules.h"
#include "common/scene/store_copies.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace hipmap {

namespace {

using Kind = LightSource::Kind;

/// power: the power for each unit of `colour`.
LightSource with_power(LightSource out, const glm::dvec3& colour, double power)
{
    out.at.power = Rgb(colour);
    out.power = power * max_channel(out.at.power);
    return out;
}

LightSource source_of(const MeanEmission& light, const BoundingSphere& scene)
{
    using From = MeanEmission::From;
    LightSource out;
    out.at.position = glm::vec3(light.centre);
    out.at.axis = glm::vec3(light.axis);
    out.at.cos_reach = static_cast<float>(light.cos_reach);
    out.at.by_cosine = light.by_cosine;
    if (light.from == From::afar) {
        out.kind = Kind::sun;
        out.at.far = true;
        out.size = static_cast<float>(light.half_angle);
        return with_power(out, light.light, light.factor * kPi * scene.radius * scene.radius);
    }
    out.kind = light.from == From::sphere ? Kind::point : Kind::area;
    out.size = static_cast<float>(light.radius);
    out.is_disc = light.from == From::ellipse;
    out.half_right = glm::vec3(light.half_right);
    out.half_up = glm::vec3(light.half_up);
    return with_power(out, light.light, light.factor);
}

/// One for each object with emissive faces, in the order of their numbers.
void add_emissive_objects(const TriangleMesh& mesh, std::span<const MeanMaterial> materials,
                          std::vector<LightSource>& out)
{
    std::map<ObjectId, LightSource> objects;
    for (FaceId face = 0; face < mesh.face_count(); ++face) {
        const MeanMaterial& material = materials[mesh.material_of_face[face]];
        if (is_black(material.emission))
            continue;
        const double power = (material.emits_behind ? 2 : 1) * kPi * face_area(mesh, face) *
                             max_channel(material.emission);
        if (!(power > 0))
            continue;
        LightSource& source = objects[mesh.object_of_face[face]];
        source.kind = Kind::faces;
        source.faces.push_back(face);
        source.cumulative.push_back(source.power += power);
    }
    for (auto& [object, source] : objects)
        out.push_back(std::move(source));
}

/// Place of a number in [0, 1) among sums.
std::size_t place_in(std::span<const double> cumulative, double u)
{
    const auto last = cumulative.end() - 1;
    return static_cast<std::size_t>(std::upper_bound(cumulative.begin(), last, u * *last) -
                                    cumulative.begin());
}

LightPoint point_on_faces(const MeanLights& sources, const LightSource& light,
                          RandomSequence& random)
{
    const FaceId face = light.faces[place_in(light.cumulative, random.next())];
    const MeanMaterial& material = sources.materials[sources.mesh->material_of_face[face]];
    const SurfacePoint on = surface_point(*sources.mesh, face, sample_triangle(random.next2()));
    const bool behind = material.emits_behind && random.next() < 0.5f;
    LightPoint out;
    out.power = material.emission;
    out.axis = behind ? -on.geometric_normal : on.geometric_normal;
    out.position = offset_origin(on, out.axis);
    out.cos_reach = 0;
    out.by_cosine = true;
    return out;
}

/// A direction whose cosine to the axis is at least `least`.
glm::vec3 draw_in_cone(const glm::vec3& axis, float least, const glm::vec2& u)
{
    return Frame(axis).to_world(direction_from_cosine(1 - u.x * (1 - least), u.y));
}

/// Starts parallel light that passes through `point` outside the scene.
Ray ray_from_afar(const BoundingSphere& scene, const glm::vec3& point, const glm::vec3& direction)
{
    Ray ray;
    const float behind = glm::dot(point - scene.centre, direction) + 2 * scene.radius;
    ray.origin = point - direction * behind;
    ray.direction = direction;
    return ray;
}

glm::vec3 point_of_disc(const BoundingSphere& sphere, const glm::vec3& across,
                        RandomSequence& random)
{
    const glm::vec2 disc = sphere.radius * sample_disc(random.next2());
    const Frame frame(across);
    return sphere.centre + frame.x * disc.x + frame.y * disc.y;
}

float height_of(const BoundingSphere& target, const LightPoint& point)
{
    return cone_height(target.centre - point.position, target.radius, point.axis,
                       std::acos(point.cos_reach));
}

/// Draws a target by weight.  Returns the number of targets if all weights are zero.
template <typename Weight>
std::size_t draw_target(std::span<const BoundingSphere> targets, float u, const Weight& weight)
{
    float sum = 0;
    for (const BoundingSphere& target : targets)
        sum += weight(target);
    float left = u * sum;
    std::size_t chosen = targets.size();
    for (std::size_t i = 0; i < targets.size(); ++i) {
        const float of_target = weight(targets[i]);
        if (!(of_target > 0))
            continue;
        chosen = i;
        if (left < of_target)
            break;
        left -= of_target;
    }
    return chosen;
}

bool passes(const BoundingSphere& target, const Ray& ray)
{
    const glm::vec3 way = target.centre - ray.origin;
    const glm::vec3 across = glm::cross(way, ray.direction);
    const float radius2 = target.radius * target.radius;
    return glm::dot(way, way) < radius2 ||
           (glm::dot(way, ray.direction) > 0 && glm::dot(across, across) < radius2);
}

/// Ends a ray by roulette with the number of targets that it could have been aimed at, so that rays
/// are no denser where targets overlap.
LightStart keep_some(LightStart start, std::span<const BoundingSphere> targets,
                     RandomSequence& random)
{
    const auto aims = std::ranges::count_if(
        targets, [&](const BoundingSphere& target) { return passes(target, start.ray); });
    if (random.next() * static_cast<float>(aims) >= 1)
        start.power = Rgb(0);
    return start;
}

LightStart aim_parallel(const MeanLights& sources, const LightPoint& point,
                        std::span<const BoundingSphere> targets, RandomSequence& random)
{
    const std::size_t chosen =
        draw_target(targets, random.next(),
                    [](const BoundingSphere& target) { return target.radius * target.radius; });
    const glm::vec3 through = point_of_disc(targets[chosen], point.axis, random);
    return keep_some({ray_from_afar(sources.scene, through, point.axis), point.power}, targets,
                     random);
}

} // namespace

MeanLights collect_mean_lights(const Scene& scene, std::span<const MeanMaterial> materials)
{
    MeanLights out{&scene.mesh, materials, {}, {}, {}};
    const Bounds<glm::vec3> box = bounds_of(scene.mesh);
    if (!box.empty())
        out.scene = {box.centre(), 0.5f * glm::length(box.extent())};
    for (const SceneLight& light : scene.lights)
        out.lights.push_back(
            source_of(std::visit([](const auto& of_kind) { return mean_emission(of_kind); }, light),
                      out.scene));
    add_emissive_objects(scene.mesh, materials, out.lights);
    const bool has_map = !scene.environment_map_file.empty();
    if (has_map || !is_black(scene.environment)) {
        LightSource sky;
        sky.kind = Kind::sky;
        sky.at.far = true;
        const double disc = kPi * double{out.scene.radius} * out.scene.radius;
        const Rgb radiance = has_map ? Rgb(scene.environment_strength) : scene.environment;
        out.lights.push_back(with_power(sky, glm::dvec3(radiance), 4 * kPi * disc));
    }
    std::erase_if(out.lights, [](const LightSource& light) { return !(light.power > 0); });
    double total = 0, sum = 0;
    for (const LightSource& light : out.lights)
        total += light.power;
    for (const LightSource& light : out.lights)
        out.cumulative.push_back(sum += kLightFloorShare / static_cast<double>(out.lights.size()) +
                                        (1 - kLightFloorShare) * light.power / total);
    return out;
}

LightPoint draw_light_point(const MeanLights& sources, double path, RandomSequence& random)
{
    const LightSource& light = sources.lights[place_in(sources.cumulative, path)];
    LightPoint out = light.at;
    switch (light.kind) {
    case Kind::faces:
        return point_on_faces(sources, light, random);
    case Kind::area: {
        const glm::vec2 u = random.next2();
        const glm::vec2 at = light.is_disc ? sample_disc(u) : 2.0f * u - 1.0f;
        out.position += at.x * light.half_right + at.y * light.half_up;
        break;
    }
    case Kind::sun:
        if (light.size > 0)
            out.axis = draw_in_cone(out.axis, std::cos(light.size), random.next2());
        break;
    case Kind::sky:
        out.axis = sample_sphere(random.next2());
        break;
    case Kind::point:
        if (light.size > 0)
            out.position += light.size * sample_sphere(random.next2());
        break;
    }
    return out;
}

LightStart draw_start(const MeanLights& sources, const LightPoint& point, RandomSequence& random)
{
    if (point.far)
        return {ray_from_afar(sources.scene, point_of_disc(sources.scene, point.axis, random),
                              point.axis),
                point.power};
    LightStart out;
    out.power = point.power;
    out.ray.origin = point.position;
    const glm::vec2 u = random.next2();
    out.ray.direction = point.by_cosine ? Frame(point.axis).to_world(sample_cosine_hemisphere(u))
                                        : draw_in_cone(point.axis, point.cos_reach, u);
    return out;
}

LightStart draw_aimed_start(const MeanLights& sources, const LightPoint& point,
                            std::span<const BoundingSphere> targets, RandomSequence& random)
{
    if (point.far)
        return aim_parallel(sources, point, targets, random);
    if (point.cos_reach >= 1) // one direction, which no aimed ray has
        return draw_start(sources, point, random);
    LightStart out;
    out.ray.origin = point.position;
    const std::size_t chosen =
        draw_target(targets, random.next(),
                    [&](const BoundingSphere& target) { return height_of(target, point); });
    if (chosen == targets.size())
        return out;
    const glm::vec3 way = targets[chosen].centre - point.position;
    const float height = height_of(targets[chosen], point);
    const glm::vec3 axis = height >= 2 ? glm::vec3(0, 0, 1) : glm::normalize(way);
    out.ray.direction = draw_in_cone(axis, 1 - height, random.next2());
    if (glm::dot(out.ray.direction, point.axis) > point.cos_reach)
        out.power = point.power;
    return keep_some(out, targets, random);
}

} // namespace hipmap
