#pragma once

#include "render/paths/direct_light.h"
#include "render/paths/path_class.h"
#include "render/shading/interface_index.h"
#include "render/shading/scatter.h"

namespace hipmap {

/// A path from the eye, or a branch of one, on its way.  Integrators add what their policy needs.
struct PathState {
    Ray ray;
    Rgb throughput{1.0f}; ///< what it brings back of light that arrives along the ray
    Rgb absorption{0.0f}; ///< of what the ray travels in, where there are no media
    float index2 = 1.0f;  ///< square of the index of refraction around the ray
    RaySource source;
    float nanometres = 0;                         ///< of the light followed; 0: all
    int depth = 0;                                ///< surfaces and scatterings behind it
    EyePathClass behind = EyePathClass::specular; ///< kept by `go_by_...` and `go_through`
    MediumStack inside; ///< what the ray travels in, where there are media
};

PathState path_from_eye(const RenderScene& scene, const Ray& ray);

/// By which one path of several is picked, or ended by chance: the largest channel of its
/// throughput; radiance scales with the square of the index, docs/light_transport.md (4).
inline float importance(const PathState& path)
{
    return path.index2 * max_channel(path.throughput);
}

/// False: Russian roulette has ended it.
bool survives(PathState& path, RandomSequence& random);

/// Where a ray has come.
struct Reached {
    std::optional<RayHit> hit; ///< none: it has left the scene, or a medium has scattered it
    bool scattered = false;    ///< by a medium
};

/// Where there are no media: adds the lights on the way to a hit to `light`, if the path sees
/// lights, and takes what glass absorbs from the throughput.
void cross_air(const RenderScene& scene, const std::optional<RayHit>& hit, bool sees_lights,
               PathState& path, Rgb& light);

/// Brings the path to the next surface.  Adds to `light` what its throughput leaves of the lights
/// on the way and of the environment behind, if it sees lights: each counts as `hit_weight` has it.
/// through_media: () -> Reached, asked where the scene has media: takes from the throughput
/// what they hold back, and keeps `inside`.  Thread-safe.
template <typename Through>
inline Reached reach(const RenderScene& scene, PathState& path, bool sees_lights, Rgb& light,
                     const Through& through_media)
{
    Reached out;
    if (scene.has_media()) {
        if (sees_lights)
            light +=
                path.throughput * met_lights_in_media(scene, path.ray, path.inside, path.source);
        out = through_media();
    } else {
        out.hit = scene.rays.nearest(path.ray);
        if (!scene.is_clear())
            cross_air(scene, out.hit, sees_lights, path, light);
    }
    if (sees_lights && !out.hit && !out.scattered)
        light += path.throughput * met_environment(scene, path.ray.direction, path.source);
    return out;
}

/// The surface reached.  The interaction borrows path.inside.  Thread-safe.
inline Interaction meet(const RenderScene& scene, const RayHit& hit, RandomSequence& random,
                        PathState& path)
{
    Interaction at = interact(scene, path.ray, hit);
    at.inside = scene.has_media() ? &path.inside : nullptr;
    find_index(scene, at, path.nanometres, path.throughput, random);
    return at;
}

/// What the throughput leaves of the emission of a surface that the path has met `distance` away,
/// counted as `hit_weight` has it.
inline Rgb met_emission(const RenderScene& scene, const Interaction& at, float distance,
                        const PathState& path)
{
    return path.throughput * emitted_radiance(at.bsdf(), at.point, at.back) *
           hit_weight(scene, at.point, path.ray.direction, distance, path.source);
}

/// Sends the path on by the mirror of a surface, or through its clear glass, which was picked among
/// others with `probability`.
void go_by_mirror(const RenderScene& scene, const Interaction& at, const SpecularLobes& lobes,
                  float probability, PathState& path);
void go_through(const RenderScene& scene, const Interaction& at, const SpecularLobes& lobes,
                float probability, PathState& path);

struct PickedLobes {
    Lobes lobes;
    float probability = 1.0f;
};

/// The same in a direction drawn from lobes.  Where they send nothing the throughput becomes zero.
/// True: it goes through the surface.
bool go_by_lobes(const RenderScene& scene, const Interaction& at, const PickedLobes& picked,
                 RandomSequence& random, PathState& path);

} // namespace hipmap
