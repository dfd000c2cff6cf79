#include "render/integrator/eye_path.h"

#include "render/integrator/direct_light.h"
#include "render/integrator/media_beams.h"
#include "render/paths/roulette.h"
#include "render/shading/interface_index.h"
#include "render/shading/scatter.h"

#include <array>

namespace hipmap {

namespace {

/// Up to this many specular surfaces both the reflected and the transmitted ray are followed, which
/// keeps glass free of noise; beyond it one of them is picked.
constexpr int kSplitDepth = 3;

/// A part of an eye path still to be followed.
struct Branch {
    Ray ray;
    Rgb weight{1.0f};
    Rgb absorption{0.0f}; ///< of what the ray travels in
    float index2 = 1.0f;  ///< square of the index of what the ray travels in
    RaySource source;
    float nanometres = 0; ///< of the light followed; 0: all
    int depth = 0;        ///< surfaces behind it
    bool clear = true;    ///< nothing but mirrors and clear glass is behind it
    Interiors inside;     ///< what the ray travels in, where there are media
};

/// Branches wait on a stack: each of the first kSplitDepth surfaces adds at most one.
struct BranchStack {
    std::array<Branch, kSplitDepth + 2> branches;
    std::size_t size = 0;

    void push(const Branch& branch)
    {
        if (max_channel(branch.weight) > 0)
            branches[size++] = branch;
    }
};

/// What passes diffusely of light that photons bring to the other side of a surface.  query: of
/// this side.
[[gnu::noinline]] Rgb light_from_beyond(const PassMaps& maps, const GatheredLobes& lobes,
                                        PhotonQuery query, EyeScratch& scratch)
{
    query = beyond(query);
    query.radius = PhotonQuery{}.radius;
    Rgb light = estimate_irradiance(maps.global, maps.surfaces, query, scratch.global);
    query.radius = even_radius(maps.caustic, maps.surfaces, query);
    light += estimate_irradiance(maps.caustic, maps.surfaces, query, scratch.caustic);
    return maps.scene.directional ? light : lobes.beyond() * light;
}

/// Light that the gathered lobes send back along the path, from photons.
Rgb photon_light(const PassMaps& maps, const Interaction& at, EyeScratch& scratch)
{
    const GatheredLobes lobes(at.bsdf, at.shading_normal, at.normal, at.back);
    PhotonQuery query{at.point.position, at.normal, at.point.face, at.side};
    if (maps.scene.directional)
        query.lobes = &lobes;
    Rgb light = estimate_irradiance(maps.global, maps.surfaces, query, scratch.global);
    query.radius = even_radius(maps.caustic, maps.surfaces, query);
    light += estimate_irradiance(maps.caustic, maps.surfaces, query, scratch.caustic);
    light = maps.scene.directional ? light : lobes.base() * light;
    return at.bsdf.passes_diffusely() ? light + light_from_beyond(maps, lobes, query, scratch)
                                      : light;
}

/// Light from lights and photons that the surface sends back along the path; what followed lobes
/// find by rays of their own is not in it.
Rgb scattered_light(const PassMaps& maps, const Interaction& at, RandomSequence& random,
                    EyeScratch& scratch)
{
    const bool gathers = at.bsdf.gathers();
    const bool samples = gathers && maps.direct == DirectLight::shadow_rays;
    const LobeRays rays{samples ? 1.0f : 0.0f, at.bsdf.follows() ? 1.0f : 0.0f};
    Rgb light(0.0f);
    if (rays.gathered + rays.followed > 0)
        light = sampled_light(maps.scene, at, rays, random);
    if (samples)
        light += found_light(maps.scene, at, random);
    if (gathers)
        light += photon_light(maps, at, scratch);
    return light;
}

/// False: Russian roulette ended the branch.
bool survives(Branch& branch, RandomSequence& random)
{
    const float carried = branch.index2 * max_channel(branch.weight);
    return survives(survival_chance(branch.depth, carried), random, branch.weight);
}

/// Radiance scales with the square of the index, docs/light_transport.md (4).
void go_beyond(const RenderScene& scene, const Interaction& at, float eta, Branch& branch)
{
    branch.weight /= eta * eta;
    branch.index2 *= eta * eta;
    branch.absorption = absorption_beyond(at);
    if (scene.has_media())
        cross(*scene.media, at.point.face, at.front, branch.inside);
}

void follow_specular(const RenderScene& scene, const Interaction& at, const Branch& from,
                     RandomSequence& random, BranchStack& stack)
{
    const SpecularLobes lobes = specular_lobes(at.bsdf, at.seen(), at.front, at.solid);
    const float mirror = max_channel(from.weight * lobes.mirror);
    const float transmit = max_channel(from.weight * lobes.transmit);
    if (!(mirror + transmit > 0))
        return;
    float mirror_chance = 1, transmit_chance = 1;
    if (from.depth >= kSplitDepth && mirror > 0 && transmit > 0) {
        mirror_chance = mirror / (mirror + transmit);
        const bool picked = random.next() < mirror_chance;
        transmit_chance = picked ? 0 : 1 - mirror_chance;
        mirror_chance = picked ? mirror_chance : 0;
    }
    Branch next = from;
    next.depth = from.depth + 1;
    next.source = {};
    if (transmit_chance > 0 && transmit > 0) {
        next.ray = transmitted_ray(at, lobes.eta);
        next.weight = from.weight * lobes.transmit / transmit_chance;
        go_beyond(scene, at, lobes.eta, next);
        if (survives(next, random))
            stack.push(next);
    }
    if (mirror_chance > 0 && mirror > 0) {
        next.ray = mirror_ray(at);
        next.absorption = from.absorption;
        next.index2 = from.index2;
        next.inside = from.inside;
        next.weight = from.weight * lobes.mirror / mirror_chance;
        if (survives(next, random))
            stack.push(next);
    }
}

/// Where media are: the first surface on the way; adds what they glow, and scatter by the photons
/// in them; null: nothing of that.
std::optional<RayHit> see_in_media(const RenderScene& scene, const VolumeMap* photons,
                                   Branch& branch, Rgb& radiance)
{
    static const VolumeMap kNoPhotons;
    std::array<Rgb, 3> seen{};
    const std::optional<RayHit> hit =
        see_media({*scene.media, photons != nullptr ? *photons : kNoPhotons, {1, 1, 1}}, branch.ray,
                  photons != nullptr, {branch.inside, branch.weight, seen});
    radiance += seen[0];
    return hit;
}

/// From the lamps that the branch runs into before it hits a surface, or else from the sky.
/// start: the branch before what is on the way has changed it.
Rgb light_on_way(const RenderScene& scene, const Branch& start, const Branch& branch,
                 const std::optional<RayHit>& hit)
{
    const Rgb lamps =
        scene.has_media()
            ? met_lamps_in_media(scene, start.ray, start.inside, start.source)
            : met_lamps(scene, start.ray, distance_of(hit), start.absorption, start.source);
    const Rgb sky = hit ? Rgb(0) : met_sky(scene, branch.ray.direction, branch.source);
    return start.weight * lamps + branch.weight * sky;
}

/// `see` where something lies between surfaces.
[[gnu::noinline]] std::optional<RayHit> see_through_air(const RenderScene& scene,
                                                        const VolumeMap* photons, bool sees_lights,
                                                        Branch& branch, Rgb& radiance)
{
    const Branch start = branch;
    std::optional<RayHit> hit;
    if (scene.has_media())
        hit = see_in_media(scene, photons, branch, radiance);
    else
        hit = scene.rays.nearest(branch.ray);
    if (hit && !scene.has_media())
        absorb(branch.absorption, hit->distance, branch.weight);
    if (sees_lights)
        radiance += light_on_way(scene, start, branch, hit);
    return hit;
}

/// The first surface on the way; takes what lies between absorbs, and adds what it sends, the lamps
/// and the sky behind it.  photons: in media.
std::optional<RayHit> see(const RenderScene& scene, const VolumeMap* photons, bool sees_lights,
                          Branch& branch, Rgb& radiance)
{
    if (!scene.is_clear())
        return see_through_air(scene, photons, sees_lights, branch, radiance);
    const std::optional<RayHit> hit = scene.rays.nearest(branch.ray);
    if (!hit && sees_lights)
        radiance += branch.weight * met_sky(scene, branch.ray.direction, branch.source);
    return hit;
}

/// One ray in a direction drawn from the followed lobes.
void follow_glossy(const RenderScene& scene, const Interaction& at, const Branch& from,
                   RandomSequence& random, BranchStack& stack)
{
    const ScatterSample sample = sample_scatter(at, Lobes::followed, random);
    Branch next = from;
    next.depth = from.depth + 1;
    next.weight *= sample.weight;
    next.source = source_at(at, sample.density);
    next.clear = false;
    next.ray = scattered_ray(at, sample);
    if (sample.transmitted)
        go_beyond(scene, at, sample.eta, next);
    if (max_channel(next.weight) > 0 && survives(next, random))
        stack.push(next);
}

BranchStack begin(const RenderScene& scene, const Ray& ray)
{
    BranchStack stack;
    Branch first;
    first.ray = ray;
    first.source.eye = true;
    if (scene.has_media())
        first.inside = interiors_at(*scene.media, ray.origin);
    stack.push(first);
    return stack;
}

} // namespace

Rgb trace_eye_path(const PassMaps& maps, const Ray& ray, SeenLights seen, RandomSequence& random,
                   EyeScratch& scratch)
{
    Rgb radiance(0.0f);
    BranchStack stack = begin(maps.scene, ray);
    while (stack.size > 0) {
        Branch branch = stack.branches[--stack.size];
        const bool sees_lights = seen == SeenLights::added || !branch.clear;
        const std::optional<RayHit> hit =
            see(maps.scene, maps.volume, sees_lights, branch, radiance);
        if (!hit)
            continue;
        Interaction at = interact(maps.scene, branch.ray, *hit);
        at.inside = maps.scene.has_media() ? &branch.inside : nullptr;
        find_index(maps.scene, at, branch.nanometres, branch.weight, random);
        if (sees_lights)
            radiance += branch.weight * emitted_radiance(at.bsdf, at.point, at.back) *
                        hit_weight(maps.scene, at.point, branch.ray.direction, hit->distance,
                                   branch.source);
        radiance += branch.weight * scattered_light(maps, at, random, scratch);
        if (at.bsdf.is_matt())
            continue;
        follow_specular(maps.scene, at, branch, random, stack);
        if (at.bsdf.follows())
            follow_glossy(maps.scene, at, branch, random, stack);
    }
    return radiance;
}

Rgb trace_seen_lights(const RenderScene& scene, const Ray& ray, RandomSequence& random)
{
    Rgb radiance(0.0f);
    BranchStack stack = begin(scene, ray);
    while (stack.size > 0) {
        Branch branch = stack.branches[--stack.size];
        const std::optional<RayHit> hit = see(scene, nullptr, true, branch, radiance);
        if (!hit)
            continue;
        Interaction at = interact(scene, branch.ray, *hit);
        at.inside = scene.has_media() ? &branch.inside : nullptr;
        find_index(scene, at, branch.nanometres, branch.weight, random);
        radiance += branch.weight * emitted_radiance(at.bsdf, at.point, at.back);
        if (!at.bsdf.is_matt())
            follow_specular(scene, at, branch, random, stack);
    }
    return radiance;
}

} // namespace hipmap
