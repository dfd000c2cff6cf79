#include "render/integrator/emission_seeds.h"

#include "render/integrator/sky_rays.h"
#include "render/shading/scatter.h"

#include <tbb/parallel_for.h>

namespace hipmap {

namespace {

/// Importons that rays start from, of each kind; more are passed over evenly.
constexpr std::size_t kMostImportons = 1 << 15;

/// Directions of each importon, of each way to draw them.
constexpr int kRays = 4;

/// Looks for light from beyond the scene at one importon after another.
class SeedFinder {
  public:
    explicit SeedFinder(const RenderScene& scene) : scene_(scene)
    {
        for (const std::uint32_t light : scene.lights.sampled)
            if (far_light(scene.lights.lights[light]))
                suns_.push_back(light);
    }

    bool can_find() const { return !suns_.empty() || !scene_.lights.environments.empty(); }

    /// Adds the light that comes straight to an importon.  rays: of each way to find it.
    void find(const Photon& importon, int rays, RandomSequence& random,
              std::vector<EmissionSeed>& out) const
    {
        if (!scene_.lights.environments.empty())
            draw_sky_rays(scene_, importon, rays, random, [&](const Ray& ray) {
                if (!scene_.rays.nearest(ray))
                    add_of_sky(ray, importon, random, out);
            });
        for (const std::uint32_t sun : suns_)
            for (int i = 0; i < rays; ++i)
                add_of_sun(sun, importon, random, out);
    }

    /// Adds the light that comes to it by a bounce.
    void find_bounced(const Photon& importon, RandomSequence& random,
                      std::vector<EmissionSeed>& out) const
    {
        for (int i = 0; i < kRays; ++i) {
            const Ray ray = ray_by_cosine(importon, random);
            const std::optional<RayHit> hit = scene_.rays.nearest(ray);
            if (!hit)
                continue;
            const Interaction at = interact(scene_, ray, *hit);
            const Rgb worth = importon.power * scattered_share(at, Lobes::gathered);
            if (!is_black(worth))
                find({at.point.position, worth, at.normal, hit->face, at.side}, 1, random, out);
        }
    }

  private:
    /// Adds the seeds of a ray that leaves the scene, drawn by the cosine or by an environment
    /// (balance heuristic).  docs/light_transport.md (41).
    void add_of_sky(const Ray& ray, const Photon& importon, RandomSequence& random,
                    std::vector<EmissionSeed>& out) const
    {
        const double cosine = glm::dot(importon.direction, ray.direction);
        for (const std::uint32_t light : scene_.lights.environments)
            if (const auto hit = intersect(scene_.lights.lights[light], ray))
                add(light, ray,
                    double{sum_of_channels(importon.power)} * sum_of_channels(hit->radiance) *
                        cosine / (cosine / double{kPi} + double{hit->pdf}),
                    random, out);
    }

    void add_of_sun(std::uint32_t sun, const Photon& importon, RandomSequence& random,
                    std::vector<EmissionSeed>& out) const
    {
        const auto drawn =
            sample_li(scene_.lights.lights[sun], {importon.position, importon.direction}, random);
        if (!drawn || !(glm::dot(importon.direction, drawn->direction) > 0))
            return;
        const Ray ray = ray_from_importon(importon, drawn->direction);
        if (!scene_.rays.nearest(ray))
            add(sun, ray,
                double{sum_of_channels(importon.power)} * sum_of_channels(drawn->light) *
                    double{glm::dot(importon.direction, drawn->direction)},
                random, out);
    }

    /// ray: towards the light.
    void add(std::uint32_t light, const Ray& ray, double worth, RandomSequence& random,
             std::vector<EmissionSeed>& out) const
    {
        if (!(worth > 0))
            return;
        Ray path = ray;
        path.direction = -ray.direction;
        PrimarySample unused;
        for (glm::vec2& step : unused)
            step = random.next2();
        if (const auto at = primary_of(scene_.lights.lights[light], path, unused))
            out.push_back({light, *at, worth});
    }

    const RenderScene& scene_;
    std::vector<std::uint32_t> suns_;
};

} // namespace

std::vector<EmissionSeed> emission_seeds(const RenderScene& scene, const Importons& importons,
                                         std::uint64_t seed)
{
    const SeedFinder finder(scene);
    if (!finder.can_find())
        return {};
    std::vector<EmissionSeed> out;
    const bool bounced = importons.indirect.empty(); // none lies where gather rays end
    for (const std::vector<Photon>* kind : {&importons.global, &importons.indirect}) {
        const std::size_t step = kind->size() / kMostImportons + 1;
        std::vector<std::vector<EmissionSeed>> found((kind->size() + step - 1) / step);
        tbb::parallel_for(std::size_t{0}, found.size(), [&](std::size_t i) {
            RandomSequence random(seed, RandomStream::seeds, kind == &importons.global, i);
            const Photon& importon = (*kind)[i * step];
            finder.find(importon, kRays, random, found[i]);
            if (bounced)
                finder.find_bounced(importon, random, found[i]);
        });
        for (const std::vector<EmissionSeed>& seeds : found)
            out.insert(out.end(), seeds.begin(), seeds.end());
    }
    return out;
}

} // namespace hipmap
