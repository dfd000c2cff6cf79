#include "render/lights/glowing_media.h"

namespace hipmap {

EmittedPath sample_emission(const GlowingMedia& light, const PathPlace&, RandomSequence& random)
{
    const GlowPath path = sample_glow(*light.media, random);
    return {path.ray, path.power, true};
}

glm::dvec3 power(const GlowingMedia& light)
{
    return glm::dvec3(light.media->glow_power);
}

} // namespace hipmap
