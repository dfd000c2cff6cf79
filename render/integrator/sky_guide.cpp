#include "render/integrator/sky_guide.h"

#include "common/math/frame.h"
#include "common/math/sampling.h"
#include "render/paths/direct_light.h"

#include <tbb/parallel_for.h>

#include <span>

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

/// Appends rays from an importon, drawn by the cosine or by an environment (balance heuristic).
class SkyRays {
  public:
    SkyRays(const RenderScene& scene, const Photon& importon) : scene_(scene), importon_(importon)
    {
    }

    void look(int rays, RandomSequence& random, std::vector<GatherRecord>& out) const
    {
        const glm::vec3& normal = importon_.direction;
        for (int i = 0; i < rays; ++i) {
            add(Frame(normal).to_world(sample_cosine_hemisphere(random.next2())), out);
            for (const std::uint32_t environment : scene_.lights.environments)
                if (const std::optional<LightSample> drawn = sample_li(
                        scene_.lights.lights[environment], {importon_.position, normal}, random))
                    add(drawn->direction, out);
        }
    }

  private:
    void add(const glm::vec3& direction, std::vector<GatherRecord>& out) const
    {
        const float cosine = glm::dot(importon_.direction, direction);
        if (!(cosine > 0))
            return;
        const Ray ray = far_ray({.face = importon_.face,
                                 .position = importon_.position,
                                 .geometric_normal = importon_.direction},
                                direction);
        GatherRecord record{.position = importon_.position,
                            .direction = direction,
                            .face = importon_.face,
                            .side = importon_.side,
                            .pdf = cosine / kPi};
        Rgb sky(0.0f);
        for (const std::uint32_t environment : scene_.lights.environments)
            if (const std::optional<LightHit> hit =
                    intersect(scene_.lights.lights[environment], ray)) {
                sky += hit->radiance;
                record.pdf += hit->pdf;
            }
        if (!is_black(sky) && !scene_.rays.nearest(ray)) {
            const Rgb light = importon_.power * sky * (cosine / (kPi * record.pdf));
            record.light = light.x + light.y + light.z;
        }
        out.push_back(record);
    }

    const RenderScene& scene_;
    const Photon& importon_;
};

} // namespace

PlacedGuides learn_sky(const RenderScene& scene, const Importons& importons, std::uint64_t seed)
{
    PlacedGuides out;
    if (scene.lights.environments.empty())
        return out;
    const std::vector<Photon>& from = importons.indirect;
    const std::size_t step = from.size() / kMostImportons + 1;
    std::vector<GatherRecord> records;
    for (const Round& round : kRounds) {
        std::vector<std::vector<GatherRecord>> found((from.size() + step - 1) / step);
        tbb::parallel_for(std::size_t{0}, found.size(), [&](std::size_t i) {
            RandomSequence random(seed, RandomStream::sky, static_cast<std::uint64_t>(round.rays),
                                  i);
            SkyRays(scene, from[i * step]).look(round.rays, random, found[i]);
        });
        for (const std::vector<GatherRecord>& rays : found)
            records.insert(records.end(), rays.begin(), rays.end());
        out = learn_directions(scene.partition, records, round.rule);
        if (out.directions.empty())
            break;
    }
    for (DirectionGuide& directions : out.directions)
        if (directions.by_lobes < 1)
            directions.by_lobes = 0; // lobes draw samples of their own
    return out;
}

} // namespace hipmap
