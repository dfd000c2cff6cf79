#include "render/integrator/eye_path.h"

#include "render/integrator/gather_branch.h"
#include "render/integrator/importons.h"
#include "render/integrator/media_beams.h"
#include "render/integrator/placed_guides.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <type_traits>

namespace hipmap {

namespace {

/// What passes diffusely of light that photons bring to the other side of a surface.  query: of
/// this side.
[[gnu::noinline]] Rgb light_from_transmitted_side(const PassMaps& maps, const PhotonLobes& lobes,
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
    const PhotonLobes lobes(at);
    PhotonQuery query = query_of(maps.scene, at, lobes);
    Rgb light = estimate_irradiance(maps.global, maps.surfaces, query, scratch.global);
    query.radius = even_radius(maps.caustic, maps.surfaces, query);
    light += estimate_irradiance(maps.caustic, maps.surfaces, query, scratch.caustic);
    light = maps.scene.directional ? light : lobes.base() * light;
    return at.bsdf().transmits_diffusely
               ? light + light_from_transmitted_side(maps, lobes, query, scratch)
               : light;
}

/// Keeps where photon_light asks for photons.  weight: of what it returns.
void keep_queries(const PassMaps& maps, const Interaction& at, const Rgb& weight,
                  Importons& importons)
{
    const PhotonLobes lobes(at);
    PhotonQuery query = query_of(maps.scene, at, lobes);
    const auto keep_both = [&](const Rgb& factor) {
        const Rgb each = maps.scene.directional ? weight : weight * factor;
        keep(&importons, &Importons::global, query, each);
        keep(&importons, &Importons::caustic, query, each);
    };
    keep_both(lobes.base());
    if (!at.bsdf().transmits_diffusely)
        return;
    query = transmitted_side(query);
    keep_both(lobes.behind());
}

/// Light from lights and photons that the surface sends back along the path; what followed lobes
/// find by rays of their own is not in it.  highlights: also what they send of the lights sampled.
Rgb scattered_light(const PassMaps& maps, const Interaction& at, bool highlights,
                    RandomSequence& random, EyeScratch& scratch)
{
    const bool gathers = at.gathers();
    const bool samples = gathers && maps.direct == DirectLight::shadow_rays;
    LobeRays rays{samples ? 1.0f : 0.0f, highlights && at.follows() ? 1.0f : 0.0f};
    if (samples && maps.sky != nullptr)
        rays.sky = directions_at(*maps.sky, maps.scene.partition, query_at(at));
    Rgb light(0.0f);
    if (rays.gathered + rays.followed > 0)
        light = light_sampled_light(maps.scene, at, rays, random);
    if (samples)
        light += bsdf_sampled_light(maps.scene, at, {.gathered = 1, .sky = rays.sky}, random);
    if (gathers)
        light += photon_light(maps, at, scratch);
    return light;
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

/// Sends the path on by all lobes that are not gathered.
void send_on(const RenderScene& scene, const Interaction& at, const GatherBranch& from,
             RandomSequence& random, GatherBranchStack& stack)
{
    if (at.is_diffuse())
        return;
    Departures out;
    if (at.follows())
        out.add(scatter(scene, from, at, Lobes::followed, random));
    add_mirror_and_glass(scene, from, at, out);
    send(out, from.depth >= kSplitDepth, random, stack);
}

/// Calls visit(branch, at, distance) at all surfaces that an eye path meets behind specular
/// surfaces and followed lobes alone, and visit(branch), if it can be called so, where it leaves
/// the scene. Adds the lights on the way to `radiance`.
template <typename Visit>
void over_surfaces(const RenderScene& scene, const Ray& ray, RandomSequence& random, Rgb& radiance,
                   Visit&& visit)
{
    GatherBranchStack stack;
    stack.push({path_from_eye(scene, ray)});
    while (!stack.empty()) {
        GatherBranch branch = stack.pop();
        const MediaFlight reached = reach_by_beams(scene, nullptr, true, branch, radiance);
        if (!reached.hit) {
            if constexpr (std::is_invocable_v<Visit, const GatherBranch&>)
                visit(branch);
            continue;
        }
        const Interaction at = meet(scene, *reached.hit, random, branch);
        visit(branch, at, reached.hit->distance);
        send_on(scene, at, branch, random, stack);
    }
}

bool is_long(const GatherBranch& branch)
{
    constexpr int kSpecular = 6, kFollowed = 2;
    return branch.depth >= (branch.behind == EyePathClass::specular ? kSpecular : kFollowed);
}

/// The cosine of the angle around a sun within which directions count as alike: 60 degrees.
constexpr float kNearCosine = 0.5f;

/// The mean over the directions near a sun of its light that a ray meets, and the variance.  Light
/// samples find it too if followed lobes sent the ray.  pdf: of the ray, as in RaySource.
glm::dvec2 moments(const FarLight& sun, float pdf)
{
    constexpr double kNear = 2 * std::numbers::pi * (1 - kNearCosine); // solid angle
    const double second = pdf > 0 ? std::min(sun.second, sun.first * sun.first * pdf) : sun.second;
    if (!std::isfinite(second))
        return glm::dvec2(0);
    const double mean = sun.first / kNear;
    return {mean, std::max(0.0, second / kNear - mean * mean)};
}

struct LongPathVisitor {
    std::span<const FarLight> suns;
    LongPaths found{};

    void operator()(const GatherBranch&, const Interaction&, float) { ++found.surfaces; }
    void operator()(const GatherBranch& branch)
    {
        if (!is_long(branch))
            return;
        const double passed = max_channel(branch.throughput);
        for (const FarLight& sun : suns)
            if (glm::dot(sun.towards, branch.ray.direction) > kNearCosine) {
                const glm::dvec2 met = moments(sun, branch.source.pdf);
                found.mean += passed * met.x;
                found.variance += passed * passed * met.y;
            }
    }
};

} // namespace

Rgb trace_eye_path(const PassMaps& maps, const Ray& ray, SeenLights seen, RandomSequence& random,
                   EyeScratch& scratch)
{
    Rgb radiance(0.0f);
    const bool sees = seen == SeenLights::added;
    GatherBranchStack stack;
    stack.push({path_from_eye(maps.scene, ray)});
    while (!stack.empty()) {
        GatherBranch branch = stack.pop();
        const MediaFlight reached = reach_by_beams(maps.scene, maps.volume, sees, branch, radiance);
        if (!reached.hit)
            continue;
        const Interaction at = meet(maps.scene, *reached.hit, random, branch);
        if (sees)
            radiance += met_emission(maps.scene, at, reached.hit->distance, branch);
        radiance += branch.throughput * scattered_light(maps, at, sees, random, scratch);
        if (scratch.importons != nullptr && at.gathers())
            keep_queries(maps, at, branch.throughput, *scratch.importons);
        send_on(maps.scene, at, branch, random, stack);
    }
    return radiance;
}

Rgb trace_seen_lights(const RenderScene& scene, const Ray& ray, RandomSequence& random,
                      const GlossyRivals& rivals)
{
    Rgb radiance(0.0f);
    over_surfaces(scene, ray, random, radiance,
                  [&](GatherBranch& branch, const Interaction& at, float distance) {
                      radiance += met_emission(scene, at, distance, branch);
                      branch.photons = 0;
                      if (!at.follows())
                          return;
                      radiance += branch.throughput *
                                  light_sampled_light(scene, at, {.followed = 1}, random);
                      if (branch.behind == EyePathClass::specular)
                          branch.photons = photons_against_rays(rivals, at);
                  });
    return radiance;
}

LongPaths& LongPaths::operator+=(const LongPaths& more)
{
    mean += more.mean;
    variance += more.variance;
    surfaces += more.surfaces;
    return *this;
}

LongPaths& LongPaths::operator/=(float samples)
{
    mean /= samples;
    variance /= samples;
    surfaces /= samples;
    return *this;
}

LongPaths trace_long_paths(const RenderScene& scene, std::span<const FarLight> suns, const Ray& ray,
                           RandomSequence& random)
{
    LongPathVisitor visitor{suns};
    Rgb lights_on_way(0.0f);
    over_surfaces(scene, ray, random, lights_on_way, visitor);
    return visitor.found;
}

Rgb trace_emissive_difference(const RenderScene& scene, const Ray& ray, RandomSequence& random)
{
    Rgb difference(0.0f), lights_on_way(0.0f);
    over_surfaces(scene, ray, random, lights_on_way,
                  [&](const GatherBranch& branch, const Interaction& at, float) {
                      if (!at.gathers())
                          return;
                      const LobeRays rays{.gathered = 1};
                      const Rgb first = emissive_light(scene, at, rays, random);
                      difference +=
                          branch.throughput * (first - emissive_light(scene, at, rays, random));
                  });
    return difference;
}

} // namespace hipmap
