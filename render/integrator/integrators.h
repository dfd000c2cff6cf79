#pragma once

#include "render/integrator/pass_source.h"

#include <span>

namespace hipmap {

/// Everything that is known of an integrator; what depends on which one is chosen reads it here.
struct IntegratorKind {
    Integrator id;
    const char* name; ///< on the command line
    const char* help; ///< what it does, in a clause
    bool photons;     ///< it gathers from photon maps: what is said of photons applies
    bool bounces;     ///< it finds light that comes by several surfaces without photon maps
    /// As make_pass_source.
    PassSource (*make)(const RenderScene& scene, const RenderOptions& options,
                       RenderStatistics& statistics, PhotonCache* cache);
};

/// Returns all integrators, the default first.
std::span<const IntegratorKind> integrator_kinds();

const IntegratorKind& kind_of(Integrator id);

/// Makes the integrator that the options name.  Adds what passes do to `statistics`.  cache: of
/// previous images of the scene, used and filled by integrator progressive; may be null.
/// Everything is borrowed, and must outlive the source.  Renders the pilot.
PassSource make_pass_source(const RenderScene& scene, const RenderOptions& options,
                            RenderStatistics& statistics, PhotonCache* cache = nullptr);

} // namespace hipmap
