#include "render/integrator/gather_path.h"

#include "render/film/pass_images.h"
#include "render/integrator/direct_light.h"
#include "render/shading/scatter.h"

#include <algorithm>
#include <array>

namespace hipmap {

namespace {

/// From here on only one of the rays that leave a surface is followed.
constexpr int kSplitDepth = 4;

/// Rays that may leave one surface: by gathered and followed lobes, mirror and clear glass.
constexpr int kMostRays = 4;

/// A ray that weighs less is followed with a chance in proportion.
constexpr float kFullWeight = 0.1f;

/// From here on also heavier ones; between perfect mirrors nothing else would end them.
constexpr int kRouletteDepth = 8;
constexpr float kMostChance = 0.98f;

/// A part of an eye path still to be followed.
struct Branch {
    Ray ray;
    Rgb weight{1.0f};
    Rgb absorption{0.0f}; ///< of what the ray travels in
    float index2 = 1.0f;  ///< square of the index of what the ray travels in
    RaySource source;
    bool clear = true;         ///< nothing but mirrors and clear glass is behind it
    bool gathers = false;      ///< a gathered lobe is behind it
    bool straight = false;     ///< nothing else is since
    float indirect_radius = 0; ///< the first, of the indirect map where that lobe is
    int depth = 0;             ///< surfaces behind it
};

float importance(const Branch& branch)
{
    return branch.index2 * max_channel(branch.weight);
}

/// The branches that leave a surface.
struct Departures {
    std::array<Branch, kMostRays> branches;
    std::size_t size = 0;

    void add(const Branch& branch)
    {
        if (importance(branch) > 0)
            branches[size++] = branch;
    }
};

/// Branches wait on a stack: a surface before kSplitDepth takes one off and adds at most kMostRays.
struct BranchStack {
    std::array<Branch, kMostRays*(kSplitDepth + 1)> branches;
    std::size_t size = 0;
};

Branch after(const Branch& from)
{
    Branch next = from;
    next.source = {};
    next.straight = false;
    ++next.depth;
    return next;
}

/// Radiance scales with the square of the index, docs/light_transport.md (4).
void enter(const Interaction& at, float eta, Branch& branch)
{
    branch.weight /= eta * eta;
    branch.index2 *= eta * eta;
    branch.absorption = absorption_beyond(at);
}

/// One ray in a direction drawn from the lobes.
Branch scatter(const Branch& from, const Interaction& at, Lobes lobes, RandomSequence& random)
{
    const ScatterSample sample = sample_scatter(at, lobes, random);
    Branch next = after(from);
    next.weight *= sample.weight;
    next.source = source_at(at, sample.density);
    next.clear = false;
    if (lobes == Lobes::gathered)
        next.gathers = next.straight = true;
    next.ray = scattered_ray(at, sample);
    if (sample.transmitted)
        enter(at, sample.eta, next);
    return next;
}

void add_mirror_and_glass(const Branch& from, const Interaction& at, Departures& out)
{
    const SpecularLobes lobes = specular_lobes(at.bsdf, at.cosine, at.front, at.solid);
    if (!is_black(lobes.transmit)) {
        Branch next = after(from);
        next.ray = transmitted_ray(at, lobes.eta);
        next.weight *= lobes.transmit;
        enter(at, lobes.eta, next);
        out.add(next);
    }
    if (!is_black(lobes.mirror)) {
        Branch next = after(from);
        next.ray = mirror_ray(at);
        next.weight *= lobes.mirror;
        out.add(next);
    }
}

/// Leaves one of the branches, picked by importance.
void pick_one(Departures& out, RandomSequence& random)
{
    float sum = 0;
    for (std::size_t i = 0; i < out.size; ++i)
        sum += importance(out.branches[i]);
    float drawn = random.next() * sum;
    std::size_t picked = 0;
    while (picked + 1 < out.size && !(drawn < importance(out.branches[picked])))
        drawn -= importance(out.branches[picked++]);
    out.branches[0] = out.branches[picked];
    out.branches[0].weight *= sum / importance(out.branches[0]);
    out.size = 1;
}

/// False: Russian roulette ended it.
bool survives(Branch& branch, RandomSequence& random)
{
    const float chance = branch.depth < kRouletteDepth
                             ? std::min(1.0f, importance(branch) / kFullWeight)
                             : std::min(kMostChance, importance(branch));
    if (!(random.next() < chance))
        return false;
    branch.weight /= chance;
    return true;
}

class GatherTracer {
  public:
    GatherTracer(const GatherMaps& maps, SeenLights seen, RandomSequence& random,
                 GatherScratch& scratch)
        : maps_(maps), seen_(seen), random_(random), scratch_(scratch)
    {
    }

    RadianceByRadius trace(const Ray& ray)
    {
        stack_.branches[0].ray = ray;
        stack_.branches[0].source.eye = true;
        stack_.size = 1;
        while (stack_.size > 0)
            follow(stack_.branches[--stack_.size]);
        return radiance_;
    }

  private:
    /// Light that the ray runs into counts: else it is the caustic map's, or has its own samples.
    bool sees_lights(const Branch& branch) const
    {
        if (branch.clear)
            return seen_ == SeenLights::added;
        return !branch.gathers || branch.straight;
    }

    void add(const Rgb& radiance)
    {
        for (Rgb& sum : radiance_)
            sum += radiance;
    }

    void follow(Branch branch)
    {
        const RenderScene& scene = maps_.scene;
        const std::optional<RayHit> hit = scene.rays.nearest(branch.ray);
        if (sees_lights(branch))
            add(branch.weight *
                met_lamps(scene, branch.ray, distance_of(hit), branch.absorption, branch.source));
        if (!hit) {
            if (sees_lights(branch))
                add(branch.weight * met_sky(scene, branch.ray.direction, branch.source));
            return;
        }
        branch.weight *= transmittance(branch.absorption, hit->distance);
        const Interaction at = interact(scene, branch.ray, *hit);
        if (sees_lights(branch))
            add(branch.weight * emitted_radiance(at.bsdf, at.point, at.back) *
                hit_weight(scene, at.point, branch.ray.direction, hit->distance, branch.source));
        Branch gathering = branch;
        const bool onward = at.bsdf.gathers() && !add_photons(gathering, at, hit->distance);
        if (onward)
            add(gathering.weight * sampled_light(scene, at, {.gathered = 1}, random_));
        if (onward && !maps_.bounces)
            add(gathering.weight * found_light(scene, at, random_));
        if (at.bsdf.follows() && !branch.gathers)
            add(branch.weight * sampled_light(scene, at, {.followed = 1}, random_));
        send_on(onward && maps_.bounces ? &gathering : nullptr, branch, at);
    }

    /// Adds what the gathered lobes send back of light from the maps.  True: that is all; false:
    /// they are to send a ray on, with the weight and radius now in `branch`.
    bool add_photons(Branch& branch, const Interaction& at, float distance)
    {
        const GatheredLobes lobes(at.bsdf, at.shading_normal, at.normal, at.back);
        PhotonQuery query{at.point.position, at.normal, at.point.face, at.side};
        if (maps_.scene.directional)
            query.lobes = &lobes;
        const Rgb factor = maps_.scene.directional ? Rgb(1) : lobes.base();
        add_caustic(branch, factor, query);
        if (branch.gathers) {
            if (maps_.global.maps.empty())
                return true; // no photon has come anywhere
            const float first = radius_at(maps_.first.global, maps_.surfaces, query);
            branch.weight *= gather_weight(first, branch.indirect_radius);
            const float radius = maps_.shrink * first;
            if (!(branch.straight && distance < radius)) {
                if (!add_precomputed(branch.weight * factor, query))
                    add_within(branch.weight * factor, maps_.global, query, radius,
                               scratch_.global);
                return true;
            }
        }
        if (!maps_.indirect.maps.empty()) {
            branch.indirect_radius = radius_at(maps_.first.indirect, maps_.surfaces, query);
            add_within(branch.weight * factor, maps_.indirect, query,
                       maps_.shrink * branch.indirect_radius, scratch_.indirect);
        }
        return false;
    }

    void add_caustic(const Branch& branch, const Rgb& factor, const PhotonQuery& query)
    {
        if (maps_.caustic.maps.empty())
            return;
        const float first = radius_at(maps_.first.caustic, maps_.surfaces, query);
        const float share = branch.gathers ? gather_weight(first, branch.indirect_radius) : 1.0f;
        add_within(branch.weight * factor * share, maps_.caustic, query, maps_.shrink * first,
                   scratch_.caustic);
    }

    /// False: nothing is.
    bool add_precomputed(const Rgb& factor, const PhotonQuery& query)
    {
        if (maps_.irradiance == nullptr)
            return false;
        const std::optional<Rgb> found = nearest_irradiance(
            *maps_.irradiance, maps_.global, maps_.surfaces.partition, query, scratch_.irradiance);
        if (found)
            add(factor * *found);
        return found.has_value();
    }

    void add_within(const Rgb& factor, const PhotonMaps& photons, const PhotonQuery& query,
                    float radius, EstimateScratch& scratch)
    {
        constexpr auto narrowing = static_cast<float>(kNarrowing);
        const std::array<float, 3> radii = {radius, narrowing * radius,
                                            narrowing * narrowing * radius};
        const RadiusEstimates found =
            estimate_within(photons, maps_.surfaces, query, radii, scratch);
        for (std::size_t i = 0; i < radiance_.size(); ++i)
            radiance_[i] += factor * found.irradiance[i];
    }

    /// gathering: the branch for the gathered lobes; null: they send no ray.
    void send_on(const Branch* gathering, const Branch& from, const Interaction& at)
    {
        Departures out;
        if (gathering != nullptr)
            out.add(scatter(*gathering, at, Lobes::gathered, random_));
        if (at.bsdf.follows())
            out.add(scatter(from, at, Lobes::followed, random_));
        add_mirror_and_glass(from, at, out);
        if (out.size > 1 && (from.gathers || from.depth >= kSplitDepth))
            pick_one(out, random_);
        for (std::size_t i = 0; i < out.size; ++i)
            if (survives(out.branches[i], random_))
                stack_.branches[stack_.size++] = out.branches[i];
    }

    const GatherMaps& maps_;
    const SeenLights seen_;
    RandomSequence& random_;
    GatherScratch& scratch_;
    BranchStack stack_;
    RadianceByRadius radiance_{};
};

} // namespace

RadianceByRadius trace_gather_path(const GatherMaps& maps, const Ray& ray, SeenLights seen,
                                   RandomSequence& random, GatherScratch& scratch)
{
    return GatherTracer(maps, seen, random, scratch).trace(ray);
}

} // namespace hipmap
