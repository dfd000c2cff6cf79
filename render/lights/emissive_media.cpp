#include "render/lights/emissive_media.h"

namespace hipmap {

EmittedPath sample_emission(const EmissiveMedia& light, const PathPlace&, RandomSequence& random)
{
    const MediaEmission path = sample_media_emission(*light.media, random);
    return {.ray = path.ray, .power = path.power, .from_medium = true};
}

glm::dvec3 power(const EmissiveMedia& light)
{
    return glm::dvec3(light.media->emission_power);
}

} // namespace hipmap
