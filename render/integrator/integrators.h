#pragma once

#include "render/integrator/coarse_image.h"
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
                       RenderStatistics& statistics, PhotonCache* cache,
                       const PilotControl& pilots);
};

/// Returns all integrators, the default first.
std::span<const IntegratorKind> integrator_kinds();

const IntegratorKind& kind_of(Integrator id);

/// Makes the integrator that the options name.  Adds what passes do to `statistics`.  cache: of
/// previous images of the scene, used and filled by integrator progressive; may be null.
/// Everything but `pilots` is borrowed, and must outlive the source.  Renders pilots, and a coarse
/// image if `pilots` ask for it.
PassSource make_pass_source(const RenderScene& scene, const RenderOptions& options,
                            RenderStatistics& statistics, PhotonCache* cache = nullptr,
                            const PilotControl& pilots = {});

} // namespace hipmap
