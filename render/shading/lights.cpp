#include "render/shading/lights.h"

#include "common/math/bounds.h"
#include "common/math/sampling.h"
#include "render/shading/lamps.h"
#include "render/shading/textured_material.h"

#include <algorithm>
#include <cmath>

namespace hipmap {

namespace {

/// More emissive faces than these, or more lamps, are chosen by a tree.
constexpr std::size_t kFewFaces = 2;
constexpr std::size_t kFewLamps = 16;

/// docs/light_transport.md (6): the glTF cone, squared linear fall-off in the cosine.
float spot_falloff(const PunctualLight& light, float cosine)
{
    const float t =
        std::clamp((cosine - light.cos_outer) / (light.cos_inner - light.cos_outer), 0.0f, 1.0f);
    return t * t;
}

void select_by_power(LightSet& lights, const Scene& scene, const std::vector<Bsdf>& bsdfs)
{
    const TriangleMesh& mesh = scene.mesh;
    const std::vector<std::uint8_t> varying = varying_materials(scene);
    std::vector<double> powers;
    for (FaceId face = 0; face < mesh.face_count(); ++face) {
        const MaterialId material = mesh.material_of_face[face];
        const Bsdf& bsdf = bsdfs[material];
        if (is_black(bsdf.emission))
            continue;
        const Rgb emission = varying[material] == 0 ? bsdf.emission : mean_emission(scene, face);
        const double sides = bsdf.emits_behind ? 2 : 1;
        const double power = sides * kPi * max_channel(emission) * face_area(mesh, face);
        if (!(power > 0))
            continue;
        lights.emissive_faces.push_back(face);
        powers.push_back(power);
        lights.emissive_power += power;
    }
    if (lights.emissive_faces.empty())
        return;
    lights.density.assign(mesh.face_count(), 0.0f);
    double sum = 0;
    for (std::size_t i = 0; i < powers.size(); ++i) {
        const double chance = powers[i] / lights.emissive_power;
        sum += chance;
        lights.cumulative.push_back(sum);
        const FaceId face = lights.emissive_faces[i];
        lights.density[face] = static_cast<float>(chance / face_area(mesh, face));
    }
    lights.cumulative.back() = 1;
}

/// Its place in emissive_faces.
std::size_t selected_face(const LightSet& lights, double u_face)
{
    const auto last = lights.cumulative.end() - 1;
    return static_cast<std::size_t>(std::upper_bound(lights.cumulative.begin(), last, u_face) -
                                    lights.cumulative.begin());
}

EmissivePoint point_on(const LightSet& lights, const TriangleMesh& mesh, std::size_t i,
                       const glm::vec2& u)
{
    const FaceId face = lights.emissive_faces[i];
    const glm::vec2 barycentric = sample_triangle(u);
    return {surface_point(mesh, face, barycentric), barycentric, lights.density[face]};
}

/// By power, and by a number that gives a point on it as well; what is left of it remains.
std::size_t select_by(float& u, const LightSet& lights)
{
    constexpr float kBelowOne = 0x1.fffffep-1f;
    const double u_face = u;
    const std::size_t i = selected_face(lights, u_face);
    const double first = i == 0 ? 0.0 : lights.cumulative[i - 1];
    u = std::min(static_cast<float>((u_face - first) / (lights.cumulative[i] - first)), kBelowOne);
    return i;
}

LightBounds bounds_of_face(const TriangleMesh& mesh, FaceId face, bool both_sides, double power)
{
    LightBounds out;
    for (int c = 0; c < 3; ++c)
        out.box.add(mesh.positions[mesh.corners[face][c]]);
    out.axis = glm::vec3(glm::normalize(scaled_normal(mesh, face)));
    out.both_sides = both_sides;
    out.power = power;
    return out;
}

void grow_face_tree(LightSet& lights, const TriangleMesh& mesh, const std::vector<Bsdf>& bsdfs)
{
    if (lights.emissive_faces.size() <= kFewFaces)
        return;
    lights.place_of_face.assign(mesh.face_count(), 0);
    std::vector<LightBounds> bounds;
    for (const FaceId face : lights.emissive_faces) {
        lights.place_of_face[face] = static_cast<std::uint32_t>(bounds.size());
        const double chance = lights.density[face] * face_area(mesh, face);
        bounds.push_back(
            bounds_of_face(mesh, face, bsdfs[mesh.material_of_face[face]].emits_behind, chance));
    }
    lights.face_tree = build_light_tree(bounds);
}

bool is_sun(const LightSet& lights, std::size_t lamp)
{
    return lamp < lights.punctual.size() && lights.punctual[lamp].kind == LightKind::directional;
}

void grow_lamp_tree(LightSet& lights)
{
    const bool few = lamp_count(lights) <= kFewLamps;
    std::vector<LightBounds> bounds;
    for (std::uint32_t lamp = 0; lamp < lamp_count(lights); ++lamp) {
        if (is_black(lamp_power(lights, lamp)))
            continue;
        const bool sized = has_size(lights, lamp);
        lights.has_lamps = true;
        lights.has_sized_lamps = lights.has_sized_lamps || sized;
        if (few || is_sun(lights, lamp)) {
            lights.other_lamps.push_back(lamp);
            if (sized)
                lights.sized_lamps.push_back(lamp);
            continue;
        }
        lights.chosen_lamps.push_back(lamp);
        lights.chosen_have_size = lights.chosen_have_size || sized;
        bounds.push_back(bounds_of_lamp(lights, lamp));
    }
    lights.lamp_tree = build_light_tree(bounds);
}

} // namespace

LightSet collect_lights(const Scene& scene, const std::vector<Bsdf>& bsdfs)
{
    const TriangleMesh& mesh = scene.mesh;
    LightSet lights;
    lights.punctual = scene.lights;
    lights.area = scene.area_lights;
    lights.environment = scene.environment;
    Bounds<glm::vec3> box;
    for (const glm::uvec3& corners : mesh.corners)
        for (int c = 0; c < 3; ++c)
            box.add(mesh.positions[corners[c]]);
    if (!box.empty()) {
        lights.centre = box.centre();
        lights.radius = 0.5f * glm::length(box.extent());
    }
    select_by_power(lights, scene, bsdfs);
    grow_face_tree(lights, mesh, bsdfs);
    grow_lamp_tree(lights);
    return lights;
}

bool has_sky(const LightSet& lights)
{
    return has_sky_picture(lights) || !is_black(lights.environment);
}

bool can_be_met(const LightSet& lights)
{
    return has_sky(lights) || !lights.emissive_faces.empty() || has_sized_lamps(lights);
}

Rgb sky_radiance(const LightSet& lights, const glm::vec3& direction)
{
    return has_sky_picture(lights) ? sky_radiance(lights.sky, direction) : lights.environment;
}

EmissivePoint sample_emissive_point(const LightSet& lights, const TriangleMesh& mesh, double u_face,
                                    const glm::vec2& u)
{
    return point_on(lights, mesh, selected_face(lights, u_face), u);
}

EmissivePoint sample_emissive_point(const LightSet& lights, const TriangleMesh& mesh,
                                    const LightReceiver& at, RandomSequence& random)
{
    if (lights.face_tree.empty()) {
        glm::vec2 u = random.next2();
        const std::size_t i = select_by(u.x, lights);
        return point_on(lights, mesh, i, u);
    }
    const std::optional<ChosenLight> chosen = choose_light(lights.face_tree, at, random.next());
    const glm::vec2 u = random.next2();
    if (!chosen)
        return {};
    EmissivePoint out = point_on(lights, mesh, chosen->light, u);
    out.density = static_cast<float>(chosen->chance / face_area(mesh, out.surface.face));
    return out;
}

float emissive_density(const LightSet& lights, const TriangleMesh& mesh, const LightReceiver& at,
                       FaceId face)
{
    if (lights.face_tree.empty() || lights.density[face] == 0)
        return lights.density[face];
    return static_cast<float>(chance_of(lights.face_tree, at, lights.place_of_face[face]) /
                              face_area(mesh, face));
}

bool shines_towards(const Bsdf& bsdf, const SurfacePoint& point, const glm::vec3& direction)
{
    return bsdf.emits_behind || glm::dot(direction, point.geometric_normal) > 0;
}

Rgb emitted_radiance(const Bsdf& bsdf, const SurfacePoint& point, const glm::vec3& direction)
{
    return shines_towards(bsdf, point, direction) ? bsdf.emission : Rgb(0);
}

Rgb light_intensity(const PunctualLight& light, const glm::vec3& direction)
{
    if (light.kind == LightKind::spot)
        return light.intensity * spot_falloff(light, glm::dot(direction, light.direction));
    return light.intensity;
}

Rgb light_power(const PunctualLight& light, float scene_radius)
{
    switch (light.kind) {
    case LightKind::point:
        return light.intensity * (4 * kPi);
    case LightKind::spot: // docs/light_transport.md (7)
        return light.intensity *
               (2 * kPi * ((1 - light.cos_inner) + (light.cos_inner - light.cos_outer) / 3));
    case LightKind::directional:
        // Its disc sends a little more than passes through a plane across its middle.
        return light.intensity * (kPi * scene_radius * scene_radius) *
               (2 / (1 + std::cos(light.half_angle)));
    }
    return Rgb(0);
}

} // namespace hipmap
