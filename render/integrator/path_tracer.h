#pragma once

#include "common/math/random.h"
#include "render/effects/light_classes.h"
#include "render/integrator/coarse_image.h"
#include "render/integrator/pass_source.h"
#include "render/shading/interaction.h"

namespace hipmap {

/// Returns the radiance that arrives along an eye ray, W/(m2 sr), by path tracing (Kajiya 1986):
/// one lobe is followed at each surface, lights are sampled at diffuse ones, and both ways to find
/// a light are combined by the power heuristic; docs/light_transport.md (14).  It shares scene,
/// materials and lights with the photon maps, but neither photons nor maps, and so serves as the
/// reference. Unbiased except for light that only a specular surface can bring from a point, spot
/// or sun, which no path finds.  May not be finite if the scene's numbers overflow; the film drops
/// such samples. Thread-safe. light: the classes of light to trace; others count zero.  seen:
/// left_out leaves out what trace_seen_lights returns.
Rgb trace_path(const RenderScene& scene, const Ray& ray, RandomSequence& random,
               const LightClasses& light = {}, SeenLights seen = SeenLights::added);

/// The radiance along two paths that are one up to the first final-gather ray, and go on from where
/// it ends each by random numbers of its own.
struct PathPair {
    Rgb first, second;  ///< W/(m2 sr); the same if there is no such ray
    int depth = 0;      ///< surfaces and scatterings that the first one met
    bool ends = false;  ///< there is such a ray, and it ends at a surface
    bool finds = false; ///< the first path found light by that ray or behind it
};

/// As trace_path, without the seen lights.  Thread-safe.
PathPair trace_path_pair(const RenderScene& scene, const Ray& ray, RandomSequence& random,
                         const LightClasses& light);

/// Makes the path tracer as an integrator.  Borrows and counts as make_pass_source does.
PassSource make_path_source(const RenderScene& scene, const RenderOptions& options,
                            RenderStatistics& statistics, const PilotControl& pilots);

} // namespace hipmap
