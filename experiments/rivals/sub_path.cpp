#include "experiments/rivals/sub_path.h"

#include "render/paths/roulette.h"

namespace hipmap {

namespace {

/// Sends the path on by a direction of the spread lobes.
bool leave_by_spread(const RenderScene& scene, const Vertex& from, Lobes lobes,
                     RandomSequence& random, SubPath& path)
{
    const ScatterSample sample = sample_scatter(from.at, lobes, random);
    if (is_black(sample.weight))
        return false;
    const SpreadValue found = spread_value(scene, from.at, from.ways, from.hit, sample.direction);
    if (is_black(found.value))
        return false;
    path.carried *= found.value / found.pdf;
    if (path.from_light)
        path.carried *= particle_factor(from.at, sample.direction);
    const float cosine = cosine_to(from.at, sample.direction);
    path.weights.before =
        cosine / found.pdf * (path.weights.before * found.reverse + path.weights.here);
    path.weights.here = 1 / found.pdf;
    leave_by_lobes(scene, from.at, sample, lobes, path);
    return true;
}

/// Sends the path on by a mirror or through glass, whose probabilities the weights leave out on
/// both sides.
void leave_by_specular(const RenderScene& scene, const Vertex& from, bool mirror, SubPath& path)
{
    const SpecularLobes& lobes = from.ways.specular;
    if (mirror) {
        leave_by_mirror(scene, from.at, path);
        path.carried *= lobes.mirror / from.ways.mirror;
    } else {
        leave_through(scene, from.at, lobes.eta, path);
        path.carried *= lobes.transmit / from.ways.transmit;
        if (!path.from_light) {
            path.carried /= lobes.eta * lobes.eta;
            path.index2 *= lobes.eta * lobes.eta;
        }
    }
    path.carried *= path.from_light ? specular_correction(from.at, path.ray.direction)
                                    : specular_share(from.at, path.ray.direction);
    path.weights.here = 0;
    path.weights.before *= cosine_to(from.at, path.ray.direction);
}

} // namespace

LightReceiver receiver(const Interaction& at)
{
    const bool both = at.bsdf().transmits || at.bsdf().transmits_diffusely;
    return {at.point.position, both ? glm::vec3(0) : at.normal};
}

bool survives(SubPath& path, RandomSequence& random)
{
    const float carried = path.index2 * max_channel(path.carried) / path.begun;
    // By one rule for all, as the vertices of both sub-paths are joined, whatever they lie behind.
    const float probability = survival_probability(EyePathClass::indirect, path.depth, carried);
    return survives(probability, random, path.carried);
}

std::optional<Vertex> reach_vertex(const RenderScene& scene, RandomSequence& random, SubPath& path)
{
    const std::optional<RayHit> hit = scene.rays.nearest(path.ray);
    if (!hit)
        return std::nullopt;
    absorb(path.absorption, hit->distance, path.carried);
    Vertex out;
    out.hit = *hit;
    out.at = meet_face(scene, *hit, path);
    find_index(scene, out.at, path.nanometres, path.carried, random);
    out.ways = ways_on(out.at);
    out.carried = path.carried;
    const float cosine = cosine_to(out.at, path.ray.direction);
    path.weights.here *= hit->distance * hit->distance / cosine;
    path.weights.before /= cosine;
    out.weights = path.weights;
    return out;
}

bool leave_vertex(const RenderScene& scene, const Vertex& from, RandomSequence& random,
                  SubPath& path)
{
    const float drawn = random.next();
    const WaysOn& ways = from.ways;
    ++path.depth;
    if (drawn < ways.spread())
        return leave_by_spread(
            scene, from, drawn < ways.gathered ? Lobes::gathered : Lobes::followed, random, path);
    const bool mirror = drawn < ways.spread() + ways.mirror;
    if (!mirror && !(ways.transmit > 0))
        return false;
    leave_by_specular(scene, from, mirror, path);
    return true;
}

} // namespace hipmap
