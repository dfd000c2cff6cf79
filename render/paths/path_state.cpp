#include "render/paths/path_state.h"

#include "render/paths/roulette.h"

namespace hipmap {

namespace {

/// Radiance scales with the square of the index, docs/light_transport.md (4).
void enter(float eta, PathState& path)
{
    path.throughput /= eta * eta;
    path.index2 *= eta * eta;
}

/// For a ray that a specular lobe has sent.  share: of the light that it leaves.
void depart(const Rgb& share, PathState& path)
{
    const Rgb photons = path.source.photons * share;
    path.source = {};
    path.source.photons = photons;
    path.behind = after_specular(path.behind);
    ++path.depth;
}

/// Draws a direction from the gathered lobes or from the guide.
ScatterSample sample_guided(const Interaction& at, const DirectionGuide& guide,
                            RandomSequence& random)
{
    ScatterSample out;
    if (random.next() < guide.by_lobes)
        out = sample_scatter(at, Lobes::gathered, random);
    else
        out.direction = draw(guide, random.next2());
    if (out.direction == glm::vec3(0))
        return out;
    const Scattered all = scattered(at, out.direction, Lobes::gathered);
    out.pdf = mixed_pdf(guide, all.pdf, out.direction);
    out.weight = out.pdf > 0 ? all.value / out.pdf : Rgb(0);
    return out;
}

} // namespace

PathState path_from_eye(const RenderScene& scene, const Ray& ray)
{
    PathState path;
    path.ray = ray;
    path.source.eye = true;
    if (scene.has_media())
        path.inside = medium_stack_at(*scene.media, ray.origin);
    return path;
}

bool survives(PathState& path, RandomSequence& random)
{
    return survives(survival_probability(path.behind, path.depth, importance(path)), random,
                    path.throughput);
}

void cross_air(const RenderScene& scene, const std::optional<RayHit>& hit, bool sees_lights,
               PathState& path, Rgb& light)
{
    if (sees_lights)
        light += path.throughput *
                 met_lights(scene, path.ray, distance_of(hit), path.absorption, path.source);
    if (!hit)
        return;
    const Rgb left = transmittance(path.absorption, hit->distance);
    path.throughput *= left;
    path.source.photons *= left;
}

void go_by_mirror(const RenderScene& scene, const Interaction& at, const SpecularLobes& lobes,
                  float probability, PathState& path)
{
    leave_by_mirror(scene, at, path);
    path.throughput *= specular_share(at, path.ray.direction) * lobes.mirror / probability;
    depart(lobes.mirror, path);
}

void go_through(const RenderScene& scene, const Interaction& at, const SpecularLobes& lobes,
                float probability, PathState& path)
{
    leave_through(scene, at, lobes.eta, path);
    path.throughput *= specular_share(at, path.ray.direction) * lobes.transmit / probability;
    enter(lobes.eta, path);
    depart(lobes.transmit, path);
}

bool go_by_lobes(const RenderScene& scene, const Interaction& at, const PickedLobes& picked,
                 RandomSequence& random, PathState& path)
{
    const ScatterSample sample = picked.guide != nullptr ? sample_guided(at, *picked.guide, random)
                                                         : sample_scatter(at, picked.lobes, random);
    path.throughput *= sample.weight / picked.probability;
    const bool gathered = picked.lobes == Lobes::gathered;
    path.behind = gathered ? EyePathClass::indirect : after_followed(path.behind);
    if (is_black(sample.weight))
        return false;
    path.source = source_at(at, picked.probability * sample.pdf);
    leave_by_lobes(scene, at, sample, picked.lobes, path);
    if (!gathered && sample.transmitted)
        enter(sample.eta, path);
    ++path.depth;
    return sample.transmitted;
}

} // namespace hipmap
