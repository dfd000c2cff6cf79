#pragma once

#include "render/photons/trace_photons.h"

namespace hipmap {

/// What is asked of a path: the classes of photon that are kept of it, and where it splits.
struct Wanted {
    bool direct = false;
    bool caustic = false;
    float caustic_part = 1; ///< of caustic photons: paths of another kind bring the rest
    bool indirect = false;
    bool bounces = false;
    bool after_specular = true;               ///< any, once a specular surface was the first
    bool after_media = false;                 ///< those that a medium scattered first, or sent out
    bool volume = false;                      ///< in media
    bool glossy = false;                      ///< TracedPhotons::glossy
    bool arrivals = false;                    ///< TracedPhotons::arrivals
    double paths = 1;                         ///< that there are in all
    const PathSplitting* splitting = nullptr; ///< null: paths do not split
    ClassCounter* counter = nullptr;          ///< of the photons kept at surfaces; null: none
};

/// Traces a light path through the scene to its end, and adds the wanted photons, and where its
/// power went, to `out`.  docs/light_transport.md (9), (10).
void trace_light_path(const RenderScene& scene, const Wanted& wanted, const EmittedPath& start,
                      RandomSequence& random, TracedPhotons& out);

} // namespace hipmap
