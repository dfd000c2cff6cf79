#include "render/integrator/eye_path.h"

#include "common/math/sampling.h"
#include "render/integrator/direct_light.h"

#include <array>

namespace hipmap {

namespace {

/// Up to this many specular surfaces both the reflected and the transmitted ray are followed, which
/// keeps glass free of noise; beyond it one of them is picked.
constexpr int kSplitDepth = 3;

/// From here on Russian roulette ends faint paths.
constexpr int kRouletteDepth = 6;

/// Roulette ends paths long before this; between perfect mirrors nothing else would.
constexpr int kMostDepth = 256;

/// A part of an eye path still to be followed.
struct Branch {
    Ray ray;
    Rgb weight{1.0f};
    Rgb absorption{0.0f}; ///< of what the ray travels in
    int depth = 0;        ///< specular surfaces behind it
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

/// Light that the diffuse lobe sends back along the path.
Rgb diffuse_radiance(const PassMaps& maps, const Interaction& at, RandomSequence& random,
                     EyeScratch& scratch)
{
    PhotonQuery query{at.point.position, at.normal, at.point.face, at.side};
    if (at.bsdf.burley_roughness >= 0)
        query.bsdf = &at.bsdf;
    query.shading_normal = at.shading_normal;
    query.toward_eye = at.back;
    Rgb irradiance = estimate_irradiance(maps.global, maps.surfaces, query, scratch.global);
    query.radius = even_radius(maps.caustic, maps.scene.partition, query);
    irradiance += estimate_irradiance(maps.caustic, maps.surfaces, query, scratch.caustic);
    if (maps.direct == DirectLight::shadow_rays)
        irradiance += direct_irradiance(maps.scene, at, random);
    return at.bsdf.diffuse * coat_half(at.bsdf, at.cosine) * irradiance / kPi;
}

/// False: Russian roulette ended the branch.
bool survives(Branch& branch, RandomSequence& random)
{
    if (branch.depth < kRouletteDepth)
        return true;
    const float chance = std::min(1.0f, max_channel(branch.weight));
    if (branch.depth >= kMostDepth || !(random.next() < chance))
        return false;
    branch.weight /= chance;
    return true;
}

void follow_specular(const Interaction& at, const Branch& from, RandomSequence& random,
                     BranchStack& stack)
{
    const SpecularLobes lobes = specular_lobes(at.bsdf, at.cosine, at.front, at.solid);
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
    if (transmit_chance > 0 && transmit > 0) {
        next.ray = transmitted_ray(at, lobes.eta);
        next.absorption = absorption_beyond(at);
        // Radiance scales with the square of the index, docs/light_transport.md (4).
        next.weight = from.weight * lobes.transmit / (transmit_chance * lobes.eta * lobes.eta);
        if (survives(next, random))
            stack.push(next);
    }
    if (mirror_chance > 0 && mirror > 0) {
        next.ray = mirror_ray(at);
        next.absorption = from.absorption;
        next.weight = from.weight * lobes.mirror / mirror_chance;
        if (survives(next, random))
            stack.push(next);
    }
}

} // namespace

Rgb trace_eye_path(const PassMaps& maps, const Ray& ray, RandomSequence& random,
                   EyeScratch& scratch)
{
    Rgb radiance(0.0f);
    BranchStack stack;
    Branch first;
    first.ray = ray;
    stack.push(first);
    while (stack.size > 0) {
        Branch branch = stack.branches[--stack.size];
        const std::optional<RayHit> hit = maps.scene.rays.nearest(branch.ray);
        if (!hit) {
            radiance += branch.weight * maps.scene.lights.environment;
            continue;
        }
        branch.weight *= transmittance(branch.absorption, hit->distance);
        const Interaction at = interact(maps.scene, branch.ray, *hit);
        radiance += branch.weight * emitted_radiance(at.bsdf, at.point, at.back);
        if (at.bsdf.has_diffuse())
            radiance += branch.weight * diffuse_radiance(maps, at, random, scratch);
        follow_specular(at, branch, random, stack);
    }
    return radiance;
}

} // namespace hipmap
