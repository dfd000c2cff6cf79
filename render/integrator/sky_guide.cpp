#include "render/integrator/sky_guide.h"

#include "render/integrator/sky_rays.h"

#include <tbb/parallel_for.h>

namespace hipmap {

namespace {

/// Importons that rays start from; more are passed over evenly.
constexpr std::size_t kMostImportons = 1 << 14;

/// Rays of each importon, of each way to draw them, and what is learnt from all so far.
struct Round {
    int rays;
    LearningRule rule;
};

/// First few rays, which show whether the sky is worth samples of its own.
constexpr Round kRounds[] = {{4, {.fewest_rays = 512, .least_gain = 2}},
                             {60, {.fewest_rays = 4096, .least_gain = 2}}};

/// Appends what a ray from an importon finds, drawn by the cosine or by an environment (balance
/// heuristic).
void add_record(const RenderScene& scene, const Ray& ray, const Photon& importon,
                std::vector<GatherRecord>& out)
{
    const float cosine = glm::dot(importon.direction, ray.direction);
    if (!(cosine > 0))
        return;
    GatherRecord record{.at = {importon.position, importon.face, importon.side},
                        .direction = ray.direction,
                        .pdf = cosine / kPi};
    Rgb sky(0.0f);
    for (const std::uint32_t environment : scene.lights.environments)
        if (const std::optional<LightHit> hit = intersect(scene.lights.lights[environment], ray)) {
            sky += hit->radiance;
            record.pdf += hit->pdf;
        }
    if (!is_black(sky) && !scene.rays.nearest(ray)) {
        const Rgb light = importon.power * sky * (cosine / (kPi * record.pdf));
        record.light = sum_of_channels(light);
    }
    out.push_back(record);
}

} // namespace

PlacedGuides learn_sky(const RenderScene& scene, std::span<const Photon> from, std::uint64_t seed)
{
    PlacedGuides out;
    if (scene.lights.environments.empty())
        return out;
    const std::size_t step = from.size() / kMostImportons + 1;
    std::vector<GatherRecord> records;
    for (const Round& round : kRounds) {
        std::vector<std::vector<GatherRecord>> found((from.size() + step - 1) / step);
        tbb::parallel_for(std::size_t{0}, found.size(), [&](std::size_t i) {
            RandomSequence random(seed, RandomStream::sky, static_cast<std::uint64_t>(round.rays),
                                  i);
            const Photon& importon = from[i * step];
            draw_sky_rays(scene, importon, round.rays, random,
                          [&](const Ray& ray) { add_record(scene, ray, importon, found[i]); });
        });
        for (const std::vector<GatherRecord>& rays : found)
            records.insert(records.end(), rays.begin(), rays.end());
        out = learn_directions(scene.partition, records, round.rule);
        if (out.values.empty())
            break;
    }
    for (DirectionGuide& directions : out.values)
        if (directions.by_lobes < 1)
            directions.by_lobes = 0; // lobes draw samples of their own
    return out;
}

} // namespace hipmap
