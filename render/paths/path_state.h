#pragma once

#include "render/paths/direct_light.h"
#include "render/paths/path_class.h"
#include "render/paths/path_ray.h"

namespace hipmap {

/// The state of a path from the eye, or of a branch of one.  Integrators add what their policy
/// needs.
struct PathState : PathRay {
    Rgb throughput{1.0f}; ///< share of the light along the ray that it brings back
    float index2 = 1.0f;  ///< square of the index of refraction around the ray
    RaySource source;
    int depth = 0;                                ///< surfaces and scatterings behind it
    EyePathClass behind = EyePathClass::specular; ///< kept by `go_by_...` and `go_through`
};

PathState path_from_eye(const RenderScene& scene, const Ray& ray);

/// Returns the importance by which one path of several is picked, or ended at random: the largest
/// channel of its throughput times the square of the index of refraction, with which radiance
/// scales, docs/light_transport.md (4).
inline float importance(const PathState& path)
{
    return path.index2 * max_channel(path.throughput);
}

/// Plays Russian roulette; returns false if it has ended the path.
bool survives(PathState& path, RandomSequence& random);

/// Follows a ray in a scene without media: adds the lights on the way to a hit to `light`, if the
/// path sees lights, and multiplies the throughput by what glass leaves.
void cross_air(const RenderScene& scene, const std::optional<RayHit>& hit, bool sees_lights,
               PathState& path, Rgb& light);

/// Multiplies by a / b, channel by channel; b: where not above zero, so is a.
inline void multiply_by_quotient(const Rgb& a, const Rgb& b, Rgb& value)
{
    for (int channel = 0; channel < 3; ++channel)
        value[channel] *= b[channel] > 0 ? a[channel] / b[channel] : 0;
}

/// Adds the environment along a ray that has left the scene, times the throughput and weighted by
/// `hit_weight`.
inline void add_environment(const RenderScene& scene, const PathState& path, Rgb& light)
{
    light += path.throughput * met_environment(scene, path.ray.direction, path.source);
}

/// `reach` where the scene has media.  A function of its own, to spare scenes without them.
template <typename Through>
[[gnu::noinline]] MediaFlight reach_in_media(const RenderScene& scene, PathState& path,
                                             bool sees_lights, Rgb& light,
                                             const Through& through_media)
{
    if (sees_lights)
        light += path.throughput * met_lights_in_media(scene, path.ray, path.inside, path.source);
    const Rgb before = path.throughput;
    const MediaFlight out = through_media();
    if (!is_black(path.source.photons))
        multiply_by_quotient(path.throughput, before, path.source.photons);
    if (sees_lights && !out.hit && !out.scattered)
        add_environment(scene, path, light);
    return out;
}

/// Brings the path to the next surface.  Adds to `light` the lights on the way and the environment,
/// times the throughput and weighted by `hit_weight`, if the path sees lights. through_media: () ->
/// MediaFlight, called where the scene has media: multiplies the throughput by their transmittance,
/// and keeps `inside`.  Thread-safe.
template <typename Through>
inline MediaFlight reach(const RenderScene& scene, PathState& path, bool sees_lights, Rgb& light,
                         const Through& through_media)
{
    if (scene.has_media()) [[unlikely]]
        return reach_in_media(scene, path, sees_lights, light, through_media);
    const MediaFlight out{scene.rays.nearest(path.ray)};
    if (!scene.clear)
        cross_air(scene, out.hit, sees_lights, path, light);
    if (sees_lights && !out.hit)
        add_environment(scene, path, light);
    return out;
}

/// Returns the surface reached.  The interaction borrows path.inside.  Thread-safe.
inline Interaction meet(const RenderScene& scene, const RayHit& hit, RandomSequence& random,
                        PathState& path)
{
    Interaction at = meet_face(scene, hit, path);
    find_index(scene, at, path.nanometres, path.throughput, random);
    return at;
}

/// Returns the emission of a surface that the path has met `distance` away, times the throughput
/// and weighted by `hit_weight`.
inline Rgb met_emission(const RenderScene& scene, const Interaction& at, float distance,
                        const PathState& path)
{
    const Rgb emitted = emitted_radiance(at.bsdf(), at.point, at.back);
    if (is_black(emitted)) [[likely]]
        return Rgb(0);
    return path.throughput * emitted * weight_against_photons(emitted, path.source) *
           hit_weight(scene, at.point, path.ray.direction, distance, path.source);
}

/// Sends the path on by the mirror of a surface, or through its clear glass.  probability: with
/// which this way was picked among others.
void go_by_mirror(const RenderScene& scene, const Interaction& at, const SpecularLobes& lobes,
                  float probability, PathState& path);
void go_through(const RenderScene& scene, const Interaction& at, const SpecularLobes& lobes,
                float probability, PathState& path);

struct PickedLobes {
    Lobes lobes;
    float probability = 1.0f;
    const DirectionGuide* guide = nullptr; ///< of gathered lobes; null: their directions alone
};

/// Sends the path on in a direction drawn from lobes.  The throughput becomes zero where they send
/// nothing. Returns whether the path goes through the surface.
bool go_by_lobes(const RenderScene& scene, const Interaction& at, const PickedLobes& picked,
                 RandomSequence& random, PathState& path);

} // namespace hipmap
