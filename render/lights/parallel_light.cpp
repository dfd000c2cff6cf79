#include "render/lights/parallel_light.h"

#include "common/math/frame.h"
#include "common/math/sampling.h"

namespace hipmap {

float SceneSphere::disc_area() const
{
    return kPi * radius * radius;
}

Ray ray_into(const SceneSphere& scene, const glm::vec3& direction, const glm::vec2& u)
{
    const Frame frame(direction);
    const glm::vec2 d = sample_disc(u) * scene.radius;
    Ray ray;
    ray.origin = scene.centre + frame.x * d.x + frame.y * d.y - direction * (2 * scene.radius);
    ray.direction = direction;
    return ray;
}

glm::vec2 disc_sample_of(const SceneSphere& scene, const Ray& ray)
{
    const glm::vec3 at = Frame(ray.direction).to_local(ray.origin - scene.centre) / scene.radius;
    return disc_sample_of(glm::vec2(at));
}

EmittedPath path_along(const SceneSphere& scene, const ParallelLight& light, RandomSequence& random)
{
    EmittedPath out;
    out.ray = ray_into(scene, light.direction, random.next2());
    out.power = light.irradiance * scene.disc_area();
    out.radiance = light.radiance;
    return out;
}

EmittedPath aimed_path_along(const SceneSphere& scene, const ParallelLight& light,
                             const std::vector<TargetSphere>& targets, RandomSequence& random)
{
    const AimedPoint aimed = aim_parallel(targets, light.direction, random);
    const float behind =
        glm::dot(aimed.position - scene.centre, light.direction) + 2 * scene.radius;
    EmittedPath out;
    out.ray.origin = aimed.position - light.direction * behind;
    out.ray.direction = light.direction;
    out.power = light.irradiance * aimed.weight;
    out.radiance = light.radiance;
    return out;
}

} // namespace hipmap
