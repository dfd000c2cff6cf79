#pragma once

#include "render/lights/light_kind.h"
#include "render/media/media_set.h"

namespace hipmap {

/// All emissive media of a scene, docs/media.md (10).
struct EmissiveMedia {
    static constexpr LightRole kRole = LightRole::medium;

    const MediaSet* media = nullptr; ///< borrowed
};

/// Returns nothing: rays gather what media emit on their way.
inline std::optional<LightSample> sample_li(const EmissiveMedia&, const LightReceiver&,
                                            RandomSequence&)
{
    return std::nullopt;
}

/// Returns nothing: a medium has no place where a ray would run into it.
inline std::optional<LightHit> intersect(const EmissiveMedia&, const Ray&)
{
    return std::nullopt;
}
inline bool can_be_met(const EmissiveMedia&)
{
    return false;
}

/// Starts a light path in an emissive medium.  Its power is black where the line drawn meets no
/// such medium.
EmittedPath sample_emission(const EmissiveMedia& light, const PathPlace& path,
                            RandomSequence& random);

/// Returns a path of no power: light of media is not aimed.
inline EmittedPath sample_aimed_emission(const EmissiveMedia&, const PathPlace&,
                                         const std::vector<TargetSphere>&, RandomSequence&)
{
    return {};
}

/// Estimates the power of all emissive media, by some lines through them.
glm::dvec3 power(const EmissiveMedia& light);

/// Returns nothing: no light tree chooses emissive media.
inline std::optional<LightBounds> bounds(const EmissiveMedia&)
{
    return std::nullopt;
}

} // namespace hipmap
