#include "render/integrator/path_tracer.h"

#include "common/math/frame.h"
#include "common/math/sampling.h"
#include "render/integrator/direct_light.h"

#include <algorithm>

namespace hipmap {

namespace {

/// From here on Russian roulette ends faint paths.
constexpr int kRouletteDepth = 4;

/// The largest chance to go on that roulette gives: between perfect mirrors nothing else would end.
constexpr float kMostChance = 0.98f;

/// A path on its way from the eye.
struct Path {
    Ray ray;
    Rgb weight{1.0f};
    Rgb absorption{0.0f};        ///< of what the ray travels in
    float index2 = 1.0f;         ///< square of the index of what the ray travels in
    float diffuse_chance = 0.0f; ///< per solid angle, that a diffuse lobe sent the ray; 0: none did
};

/// Chances of the lobes of a surface; they add up to one, or are all zero if it is black.
struct LobeChances {
    float diffuse = 0.0f, mirror = 0.0f, transmit = 0.0f;
};

LobeChances chances_of(const Path& path, const Interaction& at, const SpecularLobes& lobes)
{
    LobeChances out{
        max_channel(path.weight * at.bsdf.diffuse) * max_channel(coat_half(at.bsdf, at.cosine)),
        max_channel(path.weight * lobes.mirror), max_channel(path.weight * lobes.transmit)};
    const float sum = out.diffuse + out.mirror + out.transmit;
    if (!(sum > 0))
        return {};
    out.diffuse /= sum;
    out.mirror /= sum;
    out.transmit /= sum;
    return out;
}

/// Weight of light that the path ran into by itself; the light sampling at the diffuse surface
/// before has the rest.  Behind a specular surface or the eye nothing else could have found it.
float weight_of_hit(const RenderScene& scene, const Path& path, const SurfacePoint& on_light,
                    float distance)
{
    if (path.diffuse_chance == 0 || scene.lights.density.empty())
        return 1;
    return path.diffuse_chance /
           (path.diffuse_chance + emissive_density(scene, on_light, path.ray.direction, distance));
}

Rgb sampled_light(const RenderScene& scene, const Interaction& at, float diffuse,
                  RandomSequence& random)
{
    Rgb irradiance = punctual_irradiance(scene, at, random);
    if (!scene.lights.emissive_faces.empty())
        irradiance += emissive_irradiance(scene, at, diffuse, random);
    return at.bsdf.diffuse * coat_half(at.bsdf, at.cosine) * irradiance / kPi;
}

/// False: the direction drawn goes into the surface.
bool follow_diffuse(const Interaction& at, float chance, RandomSequence& random, Path& path)
{
    const glm::vec3 direction =
        Frame(at.shading_normal).to_world(sample_cosine_hemisphere(random.next2()));
    const Rgb received = receive(at, direction);
    if (is_black(received))
        return false;
    const float own = glm::dot(direction, at.shading_normal) / kPi;
    path.weight *=
        at.bsdf.diffuse * coat_half(at.bsdf, at.cosine) * received / (kPi * own * chance);
    path.diffuse_chance = chance * own;
    path.ray = {};
    path.ray.direction = direction;
    path.ray.origin = offset_origin(at.point, direction);
    return true;
}

/// Draws a lobe and sends the path along it; false: it ends here.
bool follow(const Interaction& at, const LobeChances& chances, const SpecularLobes& lobes,
            RandomSequence& random, Path& path)
{
    const float drawn = random.next();
    if (drawn < chances.diffuse)
        return follow_diffuse(at, chances.diffuse, random, path);
    path.diffuse_chance = 0;
    if (drawn < chances.diffuse + chances.mirror) {
        path.ray = mirror_ray(at);
        path.weight *= lobes.mirror / chances.mirror;
        return true;
    }
    if (!(chances.transmit > 0))
        return false;
    path.ray = transmitted_ray(at, lobes.eta);
    // Radiance scales with the square of the index, docs/light_transport.md (4).
    path.weight *= lobes.transmit / (chances.transmit * lobes.eta * lobes.eta);
    path.index2 *= lobes.eta * lobes.eta;
    path.absorption = absorption_beyond(at);
    return true;
}

bool survives(int depth, Path& path, RandomSequence& random)
{
    if (depth < kRouletteDepth)
        return true;
    const float chance = std::min(kMostChance, path.index2 * max_channel(path.weight));
    if (!(random.next() < chance))
        return false;
    path.weight /= chance;
    return true;
}

} // namespace

Rgb trace_path(const RenderScene& scene, const Ray& ray, RandomSequence& random)
{
    Rgb radiance(0.0f);
    Path path;
    path.ray = ray;
    for (int depth = 0; survives(depth, path, random); ++depth) {
        const std::optional<RayHit> hit = scene.rays.nearest(path.ray);
        if (!hit)
            return radiance + path.weight * scene.lights.environment;
        path.weight *= transmittance(path.absorption, hit->distance);
        const Interaction at = interact(scene, path.ray, *hit);
        radiance += path.weight * emitted_radiance(at.bsdf, at.point, at.back) *
                    weight_of_hit(scene, path, at.point, hit->distance);
        const SpecularLobes lobes = specular_lobes(at.bsdf, at.cosine, at.front, at.solid);
        const LobeChances chances = chances_of(path, at, lobes);
        if (chances.diffuse > 0)
            radiance += path.weight * sampled_light(scene, at, chances.diffuse, random);
        if (!follow(at, chances, lobes, random, path))
            return radiance;
    }
    return radiance;
}

} // namespace hipmap
