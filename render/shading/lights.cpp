#include "render/shading/lights.h"

#include "common/math/bounds.h"
#include "common/math/sampling.h"

#include <algorithm>

namespace hipmap {

namespace {

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

} // namespace

LightSet collect_lights(const Scene& scene, const std::vector<Bsdf>& bsdfs)
{
    const TriangleMesh& mesh = scene.mesh;
    LightSet lights;
    lights.punctual = scene.lights;
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
    return lights;
}

EmissivePoint sample_emissive_point(const LightSet& lights, const TriangleMesh& mesh, double u_face,
                                    const glm::vec2& u)
{
    return point_on(lights, mesh, selected_face(lights, u_face), u);
}

EmissivePoint sample_emissive_point(const LightSet& lights, const TriangleMesh& mesh, glm::vec2 u)
{
    constexpr float kBelowOne = 0x1.fffffep-1f;
    const double u_face = u.x;
    const std::size_t i = selected_face(lights, u_face);
    const double first = i == 0 ? 0.0 : lights.cumulative[i - 1];
    u.x =
        std::min(static_cast<float>((u_face - first) / (lights.cumulative[i] - first)), kBelowOne);
    return point_on(lights, mesh, i, u);
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
        return light.intensity * (kPi * scene_radius * scene_radius);
    }
    return Rgb(0);
}

} // namespace hipmap
