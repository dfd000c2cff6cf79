#pragma once

#include "render/integrator/importons.h"
#include "render/photons/seen_surfaces.h"

namespace hipmap {

/// Finds where photons count in an image, from the points where a pilot asked for them.  photons:
/// the options of a pass; light classes that it does not trace are ignored.  docs/error.md (21).
SeenSurfaces find_seen_surfaces(const MappedScene& mapped, const Importons& importons,
                                const PhotonOptions& photons);

} // namespace hipmap
