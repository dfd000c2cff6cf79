#pragma once

#include "render/maps/volume_map.h"
#include "render/shading/render_scene.h"

namespace hipmap {

/// The media and photons that eye rays see.  Borrows both.
struct MediaBeams {
    const MediaSet& media;
    const VolumeMap& photons;
    BeamScales scales;
};

/// The parts of a path that a ray through media changes.
struct SeenThrough {
    MediumStack& inside;          ///< the media at the start, then those before the surface
    Rgb& throughput;              ///< multiplied by the transmittance of the media
    std::array<Rgb, 3>& radiance; ///< plus what they emit and scatter along the ray, by each scale
};

/// Returns the first surface that a ray meets, and adds the light of the media on the way.  emits:
/// false adds nothing to the radiance, as other photons carry that light.  docs/media.md (8).
/// Thread-safe.
std::optional<RayHit> see_media(const MediaBeams& beams, const Ray& ray, bool emits,
                                const SeenThrough& seen);

} // namespace hipmap
