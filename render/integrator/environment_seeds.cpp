#include "render/integrator/environment_seeds.h"

#include "render/integrator/sky_rays.h"

#include <tbb/parallel_for.h>

namespace hipmap {

namespace {

/// Importons that rays start from, of each kind; more are passed over evenly.
constexpr std::size_t kMostImportons = 1 << 15;

/// Directions of each importon, of each of two ways to draw them.
constexpr int kRays = 4;

/// Adds the seeds of a ray from an importon that leaves the scene, drawn by the cosine or by a
/// light (balance heuristic).  docs/light_transport.md (41).
void add_seeds(const RenderScene& scene, const Ray& ray, const Photon& importon,
               RandomSequence& random, std::vector<EmissionSeed>& out)
{
    const double weight = double{importon.power.x + importon.power.y + importon.power.z};
    const double cosine = glm::dot(importon.direction, ray.direction);
    Ray light = ray;
    light.direction = -ray.direction;
    for (const std::uint32_t environment : scene.lights.environments) {
        const Light& from = scene.lights.lights[environment];
        const std::optional<LightHit> hit = intersect(from, ray);
        std::optional<PrimarySample> at = primary_of(from, light);
        if (!hit || !at || !(cosine > 0))
            continue;
        const Rgb& sent = hit->radiance;
        const double worth = weight * double{sent.x + sent.y + sent.z} * cosine /
                             (cosine / double{kPi} + double{hit->pdf});
        if (!(worth > 0))
            continue;
        for (std::size_t step = 2; step < at->size(); ++step)
            (*at)[step] = random.next2();
        out.push_back({environment, *at, worth});
    }
}

} // namespace

std::vector<EmissionSeed> environment_seeds(const RenderScene& scene, const Importons& importons,
                                            std::uint64_t seed)
{
    if (scene.lights.environments.empty())
        return {};
    std::vector<EmissionSeed> out;
    for (const std::vector<Photon>* kind : {&importons.global, &importons.indirect}) {
        const std::size_t step = kind->size() / kMostImportons + 1;
        std::vector<std::vector<EmissionSeed>> found((kind->size() + step - 1) / step);
        tbb::parallel_for(std::size_t{0}, found.size(), [&](std::size_t i) {
            RandomSequence random(seed, RandomStream::seeds, kind == &importons.global, i);
            const Photon& importon = (*kind)[i * step];
            draw_sky_rays(scene, importon, kRays, random, [&](const Ray& ray) {
                if (!scene.rays.nearest(ray))
                    add_seeds(scene, ray, importon, random, found[i]);
            });
        });
        for (const std::vector<EmissionSeed>& seeds : found)
            out.insert(out.end(), seeds.begin(), seeds.end());
    }
    return out;
}

} // namespace hipmap
