#pragma once

#include <cstdint>

namespace hipmap {

/// What lies between the eye and the ray of a path that starts there.
enum class EyePathClass : std::uint8_t {
    specular,  ///< nothing, or mirrors and clear glass alone
    highlight, ///< mirrors, clear glass and followed lobes
    indirect,  ///< a gathered lobe sent the ray: a final-gather ray
    caustic,   ///< a gathered lobe, and specular or followed ones since
};

/// Returns whether a gathered lobe lies behind the ray.
inline bool is_gathered(EyePathClass path)
{
    return path >= EyePathClass::indirect;
}

/// Returns the class after a specular lobe.
inline EyePathClass after_specular(EyePathClass path)
{
    return path == EyePathClass::indirect ? EyePathClass::caustic : path;
}

/// Returns the class after a followed lobe.
inline EyePathClass after_followed(EyePathClass path)
{
    return is_gathered(path) ? EyePathClass::caustic : EyePathClass::highlight;
}

/// What lies between a light and the ray of a path that starts there: the class of its photons.
enum class LightPathClass : std::uint8_t {
    direct,   ///< nothing
    caustic,  ///< a specular surface came first, no gathered lobe since
    volume,   ///< a medium scattered or emitted the light first, no gathered lobe since
    indirect, ///< a gathered lobe scattered the light
};

/// Returns whether photons of the class belong to the caustic map: light that came by specular
/// surfaces or media alone.
inline bool is_caustic(LightPathClass path)
{
    return path == LightPathClass::caustic || path == LightPathClass::volume;
}

} // namespace hipmap
