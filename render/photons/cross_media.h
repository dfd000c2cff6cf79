#pragma once

#include "common/math/random.h"
#include "render/paths/path_class.h"
#include "render/paths/path_ray.h"
#include "render/photons/light_path.h"

namespace hipmap {

/// The state of a light path.
struct LightPath : PathRay {
    Rgb power{0.0f};
    Rgb radiance{0.0f}; ///< along it, as EmittedPath has it; black: more than specular surfaces
                        ///<   are behind it
    LightPathClass behind = LightPathClass::direct;
    bool media_last = false; ///< a medium scattered it since the last gathered lobe
    int scatterings = 0;
    int diffuse = 0;                ///< bounces off gathered lobes
    std::uint64_t last = kNoPhoton; ///< photon of the chunk left at the last diffuse surface
    bool last_caustic = false;
    FaceId first_specular = kNone; ///< the face where it first left a specular lobe, before any
                                   ///<   gathered lobe
};

/// Returns whether photons of a path's class are wanted.
inline bool wants_class(LightPathClass path, const Wanted& wanted)
{
    switch (path) {
    case LightPathClass::direct:
        return wanted.direct;
    case LightPathClass::caustic:
        return wanted.caustic;
    case LightPathClass::volume:
        return wanted.after_media;
    case LightPathClass::indirect:
        return wanted.indirect;
    }
    return false;
}

/// Returns whether no further photon of a path is wanted.
inline bool is_done(const LightPath& path, const Wanted& wanted)
{
    if (!wanted.after_specular && path.behind == LightPathClass::caustic)
        return true;
    if (is_caustic(path.behind) && !wanted.indirect && !wants_class(path.behind, wanted))
        return true;
    const bool bounces = wanted.bounces && path.last != kNoPhoton;
    return !wanted.indirect && path.diffuse > (bounces ? 1 : 0);
}

/// Brings the path through the media of a scene to the next surface, even one that lets it pass,
/// and keeps the wanted photons on the way.  Returns nothing if the path has ended, or left the
/// scene. docs/media.md (7).
std::optional<RayHit> cross_media(const MediaSet& media, const Wanted& wanted,
                                  RandomSequence& random, LightPath& path, TracedPhotons& out);

} // namespace hipmap
