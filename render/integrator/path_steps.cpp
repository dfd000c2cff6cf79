#include "render/integrator/path_steps.h"

#include "render/paths/roulette.h"
#include "render/shading/scatter.h"

namespace hipmap {

namespace {

/// Chances of the lobes of a surface; they add up to one, or are all zero if it is black.
struct LobeChances {
    float gathered = 0.0f, followed = 0.0f, mirror = 0.0f, transmit = 0.0f;
};

LobeChances chances_of(const Path& path, const Interaction& at, const SpecularLobes& lobes,
                       const LightClasses& light)
{
    LobeChances out;
    if (at.bsdf.gathers() && (light.indirect || !path.gathers))
        out.gathered = max_channel(path.weight * scattered_share(at, Lobes::gathered));
    if (at.bsdf.follows())
        out.followed = max_channel(path.weight * scattered_share(at, Lobes::followed));
    out.mirror = max_channel(path.weight * lobes.mirror);
    out.transmit = max_channel(path.weight * lobes.transmit);
    const float sum = out.gathered + out.followed + out.mirror + out.transmit;
    if (!(sum > 0))
        return {};
    out.gathered /= sum;
    out.followed /= sum;
    out.mirror /= sum;
    out.transmit /= sum;
    return out;
}

void enter(const Interaction& at, float eta, Path& path)
{
    // Radiance scales with the square of the index, docs/light_transport.md (4).
    path.weight /= eta * eta;
    path.index2 *= eta * eta;
    path.absorption = absorption_beyond(at);
}

/// False: the direction drawn leads nowhere.
bool follow_lobes(const Interaction& at, Lobes lobes, float chance, RandomSequence& random,
                  Path& path)
{
    const ScatterSample sample = sample_scatter(at, lobes, random);
    if (is_black(sample.weight))
        return false;
    path.straight = lobes == Lobes::gathered;
    path.gathers = path.gathers || path.straight;
    if (path.straight)
        path.nanometres = 0;
    path.weight *= sample.weight / chance;
    path.source = source_at(at, chance * sample.density);
    path.ray = scattered_ray(at, sample);
    if (sample.transmitted && lobes == Lobes::followed)
        enter(at, sample.eta, path);
    return true;
}

/// Draws a lobe and sends the path along it; false: it ends here.
bool follow(const Interaction& at, const LobeChances& chances, const SpecularLobes& lobes,
            RandomSequence& random, Path& path)
{
    float drawn = random.next();
    if (drawn < chances.gathered)
        return follow_lobes(at, Lobes::gathered, chances.gathered, random, path);
    drawn -= chances.gathered;
    if (drawn < chances.followed)
        return follow_lobes(at, Lobes::followed, chances.followed, random, path);
    drawn -= chances.followed;
    path.source = {};
    path.straight = false;
    if (drawn < chances.mirror) {
        path.ray = mirror_ray(at);
        path.weight *= lobes.mirror / chances.mirror;
        return true;
    }
    if (!(chances.transmit > 0))
        return false;
    path.ray = transmitted_ray(at, lobes.eta);
    path.weight *= lobes.transmit / chances.transmit;
    enter(at, lobes.eta, path);
    return true;
}

/// Adds the light sampled at a surface, and sends the path on; false: it ends there.
bool leave(const RenderScene& scene, const Interaction& at, const LightClasses& light,
           RandomSequence& random, Path& path, Rgb& radiance)
{
    const SpecularLobes lobes = specular_lobes(at.bsdf, at.seen(), at.front, at.solid);
    const LobeChances chances = chances_of(path, at, lobes, light);
    const LobeRays rays{chances.gathered, light.caustic || !path.gathers ? chances.followed : 0};
    if (rays.gathered + rays.followed > 0)
        radiance += path.weight * sampled_light(scene, at, rays, random);
    return follow(at, chances, lobes, random, path);
}

/// The same where the diffuse lobe is all.
bool leave_matt(const RenderScene& scene, const Interaction& at, const LightClasses& light,
                RandomSequence& random, Path& path, Rgb& radiance)
{
    if (!(light.indirect || !path.gathers) || !(max_channel(path.weight * at.bsdf.diffuse) > 0))
        return false;
    radiance += path.weight * sampled_light(scene, at, {.gathered = 1}, random);
    const ScatterSample sample = sample_scatter(at, Lobes::gathered, random);
    path.gathers = path.straight = true;
    path.nanometres = 0;
    path.weight *= sample.weight;
    path.source = source_at(at, sample.density);
    path.ray = scattered_ray(at, sample);
    return !is_black(sample.weight);
}

} // namespace

bool survives(int depth, Path& path, RandomSequence& random)
{
    return survives(survival_chance(depth, path.index2 * max_channel(path.weight)), random,
                    path.weight);
}

bool pass_surface(const RenderScene& scene, const Interaction& at, float distance,
                  const LightClasses& light, RandomSequence& random, Path& path, Rgb& radiance)
{
    if (path.sees_lights(light))
        radiance += path.weight * emitted_radiance(at.bsdf, at.point, at.back) *
                    hit_weight(scene, at.point, path.ray.direction, distance, path.source);
    return at.bsdf.is_matt() ? leave_matt(scene, at, light, random, path, radiance)
                             : leave(scene, at, light, random, path, radiance);
}

} // namespace hipmap
