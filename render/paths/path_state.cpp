#include "render/paths/path_state.h"

#include "render/paths/roulette.h"

namespace hipmap {

namespace {

void enter(const Interaction& at, float eta, PathState& path)
{
    // Radiance scales with the square of the index, docs/light_transport.md (4).
    path.throughput /= eta * eta;
    path.index2 *= eta * eta;
    path.absorption = absorption_behind(at);
}

/// For a ray already sent.
void depart(const RenderScene& scene, const Interaction& at, PathState& path)
{
    ++path.depth;
    if (scene.has_media() && glm::dot(path.ray.direction, at.normal) < 0)
        cross(*scene.media, at.point.face, at.front, path.inside);
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
    return survives(survival_probability(path.depth, importance(path)), random, path.throughput);
}

void cross_air(const RenderScene& scene, const std::optional<RayHit>& hit, bool sees_lights,
               PathState& path, Rgb& light)
{
    if (sees_lights)
        light += path.throughput *
                 met_lights(scene, path.ray, distance_of(hit), path.absorption, path.source);
    if (hit)
        absorb(path.absorption, hit->distance, path.throughput);
}

void go_by_mirror(const RenderScene& scene, const Interaction& at, const SpecularLobes& lobes,
                  float probability, PathState& path)
{
    path.ray = mirror_ray(at);
    path.throughput *= lobes.mirror / probability;
    path.source = {};
    path.behind = after_specular(path.behind);
    depart(scene, at, path);
}

void go_through(const RenderScene& scene, const Interaction& at, const SpecularLobes& lobes,
                float probability, PathState& path)
{
    path.ray = transmitted_ray(at, lobes.eta);
    path.throughput *= lobes.transmit / probability;
    path.source = {};
    path.behind = after_specular(path.behind);
    enter(at, lobes.eta, path);
    depart(scene, at, path);
}

bool go_by_lobes(const RenderScene& scene, const Interaction& at, const PickedLobes& picked,
                 RandomSequence& random, PathState& path)
{
    const ScatterSample sample = sample_scatter(at, picked.lobes, random);
    path.throughput *= sample.weight / picked.probability;
    const bool gathered = picked.lobes == Lobes::gathered;
    path.behind = gathered ? EyePathClass::indirect : after_followed(path.behind);
    if (is_black(sample.weight))
        return false;
    path.source = source_at(at, picked.probability * sample.pdf);
    path.ray = scattered_ray(at, sample);
    if (gathered)
        path.nanometres = 0;
    else if (sample.transmitted)
        enter(at, sample.eta, path);
    depart(scene, at, path);
    return sample.transmitted;
}

} // namespace hipmap
