#include "render/lights/emissive_mesh.h"

#include "common/math/frame.h"
#include "common/math/sampling.h"
#include "common/rays/flat_point.h"

#include <algorithm>
#include <cmath>

namespace hipmap {

namespace {

/// Receivers select more faces than these by a tree.
constexpr std::size_t kFewFaces = 2;

double largest(const glm::dvec3& power)
{
    return std::max({power.x, power.y, power.z});
}

/// Place of a face among those from the first emissive face to the last; none: it is outside.
std::optional<std::size_t> place_from_first(const EmissiveMesh& light, FaceId face)
{
    const std::size_t place = std::size_t{face} - light.faces.front();
    return place < light.area_pdf.size() ? std::optional(place) : std::nullopt;
}

/// Its place in `faces`.
std::size_t selected_face(const EmissiveMesh& light, double u_face)
{
    const auto last = light.cumulative.end() - 1;
    return static_cast<std::size_t>(std::upper_bound(light.cumulative.begin(), last, u_face) -
                                    light.cumulative.begin());
}

EmissivePoint point_on(const EmissiveMesh& light, std::size_t i, const glm::vec2& u)
{
    const FaceId face = light.faces[i];
    const glm::vec2 barycentric = sample_triangle(u);
    return {flat_point(*light.emission->mesh, face, barycentric), barycentric,
            light.area_pdf[face - light.faces.front()]};
}

constexpr float kBelowOne = 0x1.fffffep-1f;

/// By power, and by a number that gives a point on it as well; what is left of it remains.
std::size_t select_by(float& u, const EmissiveMesh& light)
{
    const double u_face = u;
    const std::size_t i = selected_face(light, u_face);
    const double first = i == 0 ? 0.0 : light.cumulative[i - 1];
    u = std::min(static_cast<float>((u_face - first) / (light.cumulative[i] - first)), kBelowOne);
    return i;
}

LightBounds bounds_of_face(const EmissiveMesh& light, FaceId face)
{
    const TriangleMesh& mesh = *light.emission->mesh;
    LightBounds out;
    for (const glm::vec3& corner : mesh.triangle(face))
        out.box.add(corner);
    out.axis = glm::vec3(glm::normalize(scaled_normal(mesh, face)));
    out.both_sides = light.emission->of_face(face).both_sides;
    out.power = light.area_pdf[face - light.faces.front()] * face_area(mesh, face);
    return out;
}

/// The start of a path by power, stratified over the paths of the light.
EmissivePoint draw_start(const EmissiveMesh& light, const PathPlace& path, RandomSequence& random)
{
    const double stratum =
        (static_cast<double>(path.place) + random.next()) / static_cast<double>(path.paths);
    return point_on(light, selected_face(light, stratum), random.next2());
}

} // namespace

EmissiveMesh make_emissive_mesh(const SurfaceEmission& emission, std::span<const FacePower> faces)
{
    EmissiveMesh light;
    light.emission = &emission;
    if (faces.empty())
        return light;
    for (const FacePower& face : faces) {
        light.faces.push_back(face.face);
        light.total += face.power;
        light.brightest += largest(face.power);
    }
    light.area_pdf.assign(light.faces.back() - light.faces.front() + 1, 0.0f);
    double sum = 0;
    for (const FacePower& face : faces) {
        const double probability = largest(face.power) / light.brightest;
        sum += probability;
        light.cumulative.push_back(sum);
        light.area_pdf[face.face - light.faces.front()] =
            static_cast<float>(probability / face_area(*emission.mesh, face.face));
    }
    light.cumulative.back() = 1;
    return light;
}

void grow_tree(EmissiveMesh& light)
{
    if (light.faces.size() <= kFewFaces)
        return;
    light.place_of_face.assign(light.area_pdf.size(), 0);
    std::vector<LightBounds> bounds;
    for (const FaceId face : light.faces) {
        light.place_of_face[face - light.faces.front()] = static_cast<std::uint32_t>(bounds.size());
        bounds.push_back(bounds_of_face(light, face));
    }
    light.tree = build_light_tree(bounds);
}

std::optional<EmissivePoint> sample_point(const EmissiveMesh& light, const LightReceiver& at,
                                          RandomSequence& random, const PointPlace& of)
{
    const auto stratum = [&of](auto u) {
        return (static_cast<decltype(u)>(of.place) + u) / static_cast<decltype(u)>(of.points);
    };
    if (light.tree.empty()) {
        glm::vec2 u = random.next2();
        u.x = std::min(stratum(u.x), kBelowOne);
        const std::size_t i = select_by(u.x, light);
        return point_on(light, i, u);
    }
    const std::optional<ChosenLight> chosen =
        choose_light(light.tree, at, stratum(double{random.next()}));
    const glm::vec2 u = random.next2();
    if (!chosen)
        return std::nullopt;
    EmissivePoint out = point_on(light, chosen->light, u);
    out.area_pdf = static_cast<float>(chosen->probability /
                                      face_area(*light.emission->mesh, out.surface.face));
    return out;
}

float pdf_li(const EmissiveMesh& light, const LightReceiver& at, const SurfacePoint& on_light,
             const glm::vec3& direction, float distance)
{
    if (light.empty())
        return 0;
    const std::optional<std::size_t> place = place_from_first(light, on_light.face);
    float area_pdf = place ? light.area_pdf[*place] : 0;
    if (area_pdf > 0 && !light.tree.empty())
        area_pdf = static_cast<float>(probability_of(light.tree, at, light.place_of_face[*place]) /
                                      face_area(*light.emission->mesh, on_light.face));
    return per_solid_angle(area_pdf, on_light, direction, distance);
}

std::optional<LightSample> sample_li(const EmissiveMesh& light, const LightReceiver& at,
                                     RandomSequence& random)
{
    const std::optional<EmissivePoint> point = sample_point(light, at, random);
    if (!point)
        return std::nullopt;
    const glm::vec3 way = point->surface.position - at.position;
    const float distance = glm::length(way);
    LightSample out;
    out.point = point->surface.position;
    out.direction = way / distance;
    out.pdf = per_solid_angle(point->area_pdf, point->surface, out.direction, distance);
    out.light = radiance_towards(light, *point, -out.direction) / out.pdf;
    return out.pdf > 0 && !is_black(out.light) ? std::optional(out) : std::nullopt;
}

EmittedPath sample_emission(const EmissiveMesh& light, const PathPlace& path,
                            RandomSequence& random)
{
    const EmissivePoint from = draw_start(light, path, random);
    const bool both_sides = light.emission->of_face(from.surface.face).both_sides;
    const bool behind = both_sides && random.next() < 0.5f;
    const glm::vec3 normal =
        behind ? -from.surface.geometric_normal : from.surface.geometric_normal;
    EmittedPath out;
    out.ray.direction = Frame(normal).to_world(sample_cosine_hemisphere(random.next2()));
    out.ray.origin = offset_origin(from.surface, normal);
    out.radiance = radiance_towards(light, from, normal);
    out.power = out.radiance * (kPi * (both_sides ? 2.0f : 1.0f) / from.area_pdf);
    return out;
}

EmittedPath sample_aimed_emission(const EmissiveMesh& light, const PathPlace& path,
                                  const std::vector<TargetSphere>& targets, RandomSequence& random)
{
    const EmissivePoint from = draw_start(light, path, random);
    LightCone cone;
    if (!light.emission->of_face(from.surface.face).both_sides)
        cone = {from.surface.geometric_normal, kPi / 2};
    const AimedRay aimed = aim_from_point(targets, from.surface.position, cone, random);
    const float cosine = std::abs(glm::dot(aimed.direction, from.surface.geometric_normal));
    EmittedPath out;
    out.ray.direction = aimed.direction;
    out.ray.origin = offset_origin(from.surface, aimed.direction);
    out.radiance = radiance_towards(light, from, aimed.direction);
    out.power = out.radiance * (cosine * aimed.weight / from.area_pdf);
    return out;
}

glm::dvec3 power(const EmissiveMesh& light)
{
    return light.total;
}

double path_power(const EmissiveMesh& light)
{
    return light.brightest;
}

std::optional<LightBounds> bounds(const EmissiveMesh& light)
{
    std::optional<LightBounds> out;
    for (const FaceId face : light.faces) {
        const LightBounds of_face = bounds_of_face(light, face);
        out = out ? together(*out, of_face) : of_face;
    }
    if (out)
        out->power = light.brightest / kPi;
    return out;
}

} // namespace hipmap
