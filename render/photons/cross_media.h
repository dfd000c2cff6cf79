#pragma once

#include "common/math/random.h"
#include "render/paths/path_class.h"
#include "render/paths/path_ray.h"
#include "render/photons/light_path.h"

namespace hipmap {

/// Where a light path last left a gathered lobe: there a gather ray that comes the other way ends.
struct LeftGathered {
    std::uint64_t photon = kNoPhoton; ///< of the chunk; none was kept, or a medium came after it
    bool caustic = false;             ///< it is one of the caustic photons
    float part = 1;                   ///< of the light there that its path brought
    bool media = false;               ///< a medium has scattered the path since
    bool specular = false;            ///< specular or followed lobes have sent it on since
};

/// The state of a light path.
struct LightPath : PathRay {
    Rgb power{0.0f};
    Rgb radiance{0.0f}; ///< along it, as EmittedPath has it; black: more than specular surfaces
                        ///<   are behind it
    LightPathClass behind = LightPathClass::direct;
    int scatterings = 0;
    int diffuse = 0; ///< bounces off gathered lobes
    int of = 1;      ///< paths like it go on from the start of one, docs/light_transport.md (52)
    LeftGathered last;
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

/// Returns the part of the light of a path's class that the path brings to a photon.
inline float part_brought(LightPathClass path, const Wanted& wanted)
{
    return path == LightPathClass::caustic ? wanted.caustic_part : 1.0f;
}

/// Returns whether no further photon of a path is wanted.
inline bool is_done(const LightPath& path, const Wanted& wanted)
{
    if (!wanted.after_specular && path.behind == LightPathClass::caustic)
        return true;
    if (is_caustic(path.behind) && !wanted.indirect && !wants_class(path.behind, wanted))
        return true;
    const bool bounces = wanted.bounces && path.last.photon != kNoPhoton;
    return !wanted.indirect && path.diffuse > (bounces ? 1 : 0);
}

/// Brings the path through the media of a scene to the next surface, even one that lets it pass,
/// and keeps the wanted photons on the way.  Returns nothing if the path has ended, or left the
/// scene. docs/media.md (7).
std::optional<RayHit> cross_media(const MediaSet& media, const Wanted& wanted,
                                  RandomSequence& random, LightPath& path, TracedPhotons& out);

} // namespace hipmap
