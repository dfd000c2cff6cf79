#include "experiments/rivals/light_starts.h"

#include "common/input_error.h"
#include "common/math/frame.h"
#include "common/math/sampling.h"

#include <algorithm>

namespace hipmap {

namespace {

float sides_of(const RenderScene& scene, FaceId face)
{
    return scene.surface_emission.of_face(face).both_sides ? 2.0f : 1.0f;
}

LightStart start_of(const RenderScene&, const PointLight& light, RandomSequence& random)
{
    LightStart out;
    out.is_point = true;
    out.ray.origin = light.position;
    out.ray.direction = sample_sphere(random.next2());
    out.power = light.intensity * (4 * kPi);
    out.pdf = 1 / (4 * kPi);
    return out;
}

LightStart start_of(const RenderScene& scene, const EmissiveMesh& light, RandomSequence& random)
{
    LightStart out;
    const std::optional<EmissivePoint> from = sample_point(light, {}, random);
    if (!from)
        return out;
    out.on_face = from->surface;
    const float sides = sides_of(scene, out.on_face.face);
    const bool behind = sides > 1 && random.next() < 0.5f;
    const glm::vec3 normal = (behind ? -1.0f : 1.0f) * out.on_face.geometric_normal;
    const glm::vec3 local = sample_cosine_hemisphere(random.next2());
    out.cosine = local.z;
    out.ray.direction = Frame(normal).to_world(local);
    out.ray.origin = offset_origin(out.on_face, normal);
    out.power = radiance_towards(light, *from, normal) * (kPi * sides / from->area_pdf);
    out.pdf = from->area_pdf * local.z / (kPi * sides);
    return out;
}

} // namespace

LightStarts plan_starts(const RenderScene& scene)
{
    const std::vector<Light>& lights = scene.lights.lights;
    LightStarts out;
    double sum = 0;
    for (const Light& light : lights) {
        if (!std::holds_alternative<PointLight>(light) &&
            !std::holds_alternative<EmissiveMesh>(light))
            throw InputError("the scene has a light that is neither a point nor emissive faces; "
                             "bidirectional path tracing here knows no other: use another method");
        out.cumulative.push_back(sum += path_power(light));
    }
    for (double& part : out.cumulative)
        part /= sum;
    out.face_pdf.assign(scene.mesh().face_count(), 0.0f);
    for (std::size_t i = 0; i < lights.size(); ++i)
        if (const auto* mesh = std::get_if<EmissiveMesh>(&lights[i]))
            for (const FaceId face : mesh->faces)
                out.face_pdf[face] =
                    probability_of(out, i) * mesh->area_pdf[face - mesh->faces.front()];
    return out;
}

LightStart draw_start(const RenderScene& scene, const LightStarts& starts, RandomSequence& random)
{
    if (starts.cumulative.empty())
        return {};
    const auto last = starts.cumulative.end() - 1;
    const auto light =
        static_cast<std::size_t>(std::upper_bound(starts.cumulative.begin(), last, random.next()) -
                                 starts.cumulative.begin());
    const Light& chosen = scene.lights.lights[light];
    LightStart out = std::holds_alternative<PointLight>(chosen)
                         ? start_of(scene, std::get<PointLight>(chosen), random)
                         : start_of(scene, std::get<EmissiveMesh>(chosen), random);
    const float probability = probability_of(starts, light);
    out.power /= probability;
    out.pdf *= probability;
    return out;
}

float start_pdf(const RenderScene& scene, const LightStarts& starts, FaceId face, float cosine)
{
    return starts.face_pdf[face] * cosine / (kPi * sides_of(scene, face));
}

} // namespace hipmap
