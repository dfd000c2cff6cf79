#pragma once

#include "common/math/random.h"
#include "render/photons/light_path.h"

namespace hipmap {

/// A light path under way.
struct LightPath {
    Ray ray;
    Rgb power{0.0f};
    Rgb absorption{0.0f}; ///< of what the ray travels in
    Interiors inside;     ///< where there are media
    float nanometres = 0; ///< of its light; 0: all
    bool specular = false;
    bool first_specular = false; ///< before media and diffuse surfaces
    bool from_media = false;     ///< a medium scattered it, or sent it out
    bool media_last = false;     ///< scattered it since the last diffuse surface
    int scatterings = 0;
    int diffuse = 0;                ///< diffuse bounces
    std::uint64_t last = kNoPhoton; ///< photon of the chunk left at the last diffuse surface
    bool last_caustic = false;
};

/// Whether light is wanted that has met media or specular surfaces alone.
inline bool wants_undiffused(const LightPath& path, const Wanted& wanted)
{
    return path.first_specular ? wanted.caustic : wanted.after_media;
}

/// Whether nothing more of a path is wanted.
inline bool is_done(const LightPath& path, const Wanted& wanted)
{
    if (!wanted.after_specular && path.first_specular && path.diffuse == 0)
        return true;
    if (path.from_media && path.diffuse == 0 && !wanted.indirect && !wants_undiffused(path, wanted))
        return true;
    const bool bounces = wanted.bounces && path.last != kNoPhoton;
    return !wanted.indirect && path.diffuse > (bounces ? 1 : 0);
}

/// Brings the path to the next surface, whatever that lets pass, through the media of a scene, and
/// keeps the photons that are wanted of it on the way; none: it has ended, or left the scene.
/// docs/media.md (7).
std::optional<RayHit> fly_through_media(const MediaSet& media, const Wanted& wanted,
                                        RandomSequence& random, LightPath& path,
                                        TracedPhotons& out);

} // namespace hipmap
