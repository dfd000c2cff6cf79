#pragma once

#include "render/maps/volume_map.h"
#include "render/shading/render_scene.h"

namespace hipmap {

/// What eye rays see in media.  Borrows both.
struct MediaBeams {
    const MediaSet& media;
    const VolumeMap& photons;
    BeamScales scales;
};

/// What a ray carries through media and is changed by them.
struct SeenThrough {
    MediumStack& inside;          ///< what it starts in, and then what is before the surface
    Rgb& throughput;              ///< times what they leave of light
    std::array<Rgb, 3>& radiance; ///< plus what they emit and scatter along the ray, by each scale
};

/// The first surface that a ray meets.  emits: false: nothing is added to the radiance, as other
/// photons have that light.  docs/media.md (8).  Thread-safe.
std::optional<RayHit> see_media(const MediaBeams& beams, const Ray& ray, bool emits,
                                const SeenThrough& seen);

} // namespace hipmap
