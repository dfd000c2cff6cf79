#include "render/integrator/eye_path.h"

#include "render/integrator/media_beams.h"
#include "render/paths/path_state.h"

#include <array>

namespace hipmap {

namespace {

/// Up to this many specular surfaces both the reflected and the transmitted ray are followed, which
/// keeps glass free of noise; beyond it one of them is picked.
constexpr int kSplitDepth = 3;

/// Branches wait on a stack: each of the first kSplitDepth surfaces adds at most one.
struct EyeBranchStack {
    std::array<PathState, kSplitDepth + 2> branches;
    std::size_t size = 0;

    /// Unless Russian roulette ends it.
    void push(PathState branch, RandomSequence& random)
    {
        if (max_channel(branch.throughput) > 0 && survives(branch, random))
            branches[size++] = branch;
    }
};

/// What passes diffusely of light that photons bring to the other side of a surface.  query: of
/// this side.
[[gnu::noinline]] Rgb light_from_transmitted_side(const PassMaps& maps, const GatheredLobes& lobes,
                                                  PhotonQuery query, EyeScratch& scratch)
{
    query = transmitted_side(query);
    query.radius = PhotonQuery{}.radius;
    Rgb light = estimate_irradiance(maps.global, maps.surfaces, query, scratch.global);
    query.radius = even_radius(maps.caustic, maps.surfaces, query);
    light += estimate_irradiance(maps.caustic, maps.surfaces, query, scratch.caustic);
    return maps.scene.directional ? light : lobes.behind() * light;
}

/// Light that the gathered lobes send back along the path, from photons.
Rgb photon_light(const PassMaps& maps, const Interaction& at, EyeScratch& scratch)
{
    const GatheredLobes lobes(at);
    PhotonQuery query{at.point.position, at.normal, at.point.face, at.side};
    if (maps.scene.directional)
        query.lobes = &lobes;
    Rgb light = estimate_irradiance(maps.global, maps.surfaces, query, scratch.global);
    query.radius = even_radius(maps.caustic, maps.surfaces, query);
    light += estimate_irradiance(maps.caustic, maps.surfaces, query, scratch.caustic);
    light = maps.scene.directional ? light : lobes.base() * light;
    return at.bsdf().transmits_diffusely
               ? light + light_from_transmitted_side(maps, lobes, query, scratch)
               : light;
}

/// Light from lights and photons that the surface sends back along the path; what followed lobes
/// find by rays of their own is not in it.
Rgb scattered_light(const PassMaps& maps, const Interaction& at, RandomSequence& random,
                    EyeScratch& scratch)
{
    const bool gathers = at.gathers();
    const bool samples = gathers && maps.direct == DirectLight::shadow_rays;
    const LobeRays rays{samples ? 1.0f : 0.0f, at.follows() ? 1.0f : 0.0f};
    Rgb light(0.0f);
    if (rays.gathered + rays.followed > 0)
        light = light_sampled_light(maps.scene, at, rays, random);
    if (samples)
        light += bsdf_sampled_light(maps.scene, at, random);
    if (gathers)
        light += photon_light(maps, at, scratch);
    return light;
}

void follow_specular(const RenderScene& scene, const Interaction& at, const PathState& from,
                     RandomSequence& random, EyeBranchStack& stack)
{
    const SpecularLobes lobes = specular_lobes(at);
    const float mirror = max_channel(from.throughput * lobes.mirror);
    const float transmit = max_channel(from.throughput * lobes.transmit);
    if (!(mirror + transmit > 0))
        return;
    float mirror_probability = 1, transmit_probability = 1;
    if (from.depth >= kSplitDepth && mirror > 0 && transmit > 0) {
        mirror_probability = mirror / (mirror + transmit);
        const bool picked = random.next() < mirror_probability;
        transmit_probability = picked ? 0 : 1 - mirror_probability;
        mirror_probability = picked ? mirror_probability : 0;
    }
    if (transmit_probability > 0 && transmit > 0) {
        PathState next = from;
        go_through(scene, at, lobes, transmit_probability, next);
        stack.push(next, random);
    }
    if (mirror_probability > 0 && mirror > 0) {
        PathState next = from;
        go_by_mirror(scene, at, lobes, mirror_probability, next);
        stack.push(next, random);
    }
}

/// To the next surface; photons: of the media, null: what these scatter is not seen.
MediaFlight reach_by_beams(const RenderScene& scene, const VolumeMap* photons, bool sees_lights,
                           PathState& branch, Rgb& radiance)
{
    return reach(scene, branch, sees_lights, radiance, [&] {
        static const VolumeMap kNoPhotons;
        std::array<Rgb, 3> seen{};
        const MediaBeams beams{*scene.media, photons != nullptr ? *photons : kNoPhotons, {1, 1, 1}};
        const MediaFlight out{see_media(beams, branch.ray, photons != nullptr,
                                        {branch.inside, branch.throughput, seen})};
        radiance += seen[0];
        return out;
    });
}

/// One ray in a direction drawn from the followed lobes.
void follow_glossy(const RenderScene& scene, const Interaction& at, const PathState& from,
                   RandomSequence& random, EyeBranchStack& stack)
{
    PathState next = from;
    go_by_lobes(scene, at, {Lobes::followed}, random, next);
    stack.push(next, random);
}

EyeBranchStack begin(const RenderScene& scene, const Ray& ray)
{
    EyeBranchStack stack;
    stack.branches[stack.size++] = {path_from_eye(scene, ray)};
    return stack;
}

} // namespace

Rgb trace_eye_path(const PassMaps& maps, const Ray& ray, SeenLights seen, RandomSequence& random,
                   EyeScratch& scratch)
{
    Rgb radiance(0.0f);
    EyeBranchStack stack = begin(maps.scene, ray);
    while (stack.size > 0) {
        PathState branch = stack.branches[--stack.size];
        const bool sees_lights =
            seen == SeenLights::added || branch.behind != EyePathClass::specular;
        const MediaFlight reached =
            reach_by_beams(maps.scene, maps.volume, sees_lights, branch, radiance);
        if (!reached.hit)
            continue;
        const Interaction at = meet(maps.scene, *reached.hit, random, branch);
        if (sees_lights)
            radiance += met_emission(maps.scene, at, reached.hit->distance, branch);
        radiance += branch.throughput * scattered_light(maps, at, random, scratch);
        if (at.is_diffuse())
            continue;
        follow_specular(maps.scene, at, branch, random, stack);
        if (at.follows())
            follow_glossy(maps.scene, at, branch, random, stack);
    }
    return radiance;
}

Rgb trace_seen_lights(const RenderScene& scene, const Ray& ray, RandomSequence& random)
{
    Rgb radiance(0.0f);
    EyeBranchStack stack = begin(scene, ray);
    while (stack.size > 0) {
        PathState branch = stack.branches[--stack.size];
        const MediaFlight reached = reach_by_beams(scene, nullptr, true, branch, radiance);
        if (!reached.hit)
            continue;
        const Interaction at = meet(scene, *reached.hit, random, branch);
        radiance += met_emission(scene, at, reached.hit->distance, branch);
        if (!at.is_diffuse())
            follow_specular(scene, at, branch, random, stack);
    }
    return radiance;
}

} // namespace hipmap
