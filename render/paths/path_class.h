#pragma once

#include <cstdint>

namespace hipmap {

/// What lies between the eye and the ray of a path that starts there.
enum class EyePathClass : std::uint8_t {
    specular,  ///< nothing, or mirrors and clear glass alone
    highlight, ///< mirrors and clear glass, then followed lobes alone
    glossy,    ///< specular surfaces also behind followed lobes, but no gathered lobe
    indirect,  ///< a gathered lobe sent the ray: a final-gather ray
    caustic,   ///< a gathered lobe, and specular or followed ones since
};

/// Returns whether a gathered lobe lies behind the ray.
inline bool is_gathered(EyePathClass path)
{
    return path >= EyePathClass::indirect;
}

/// Returns whether light met by the ray is seen: straight, over specular surfaces, or by followed
/// lobes behind these.  It may have samples of its own, docs/error.md (16).
inline bool sees_lights(EyePathClass path)
{
    return path <= EyePathClass::highlight;
}

/// Returns the class after a specular lobe.
inline EyePathClass after_specular(EyePathClass path)
{
    switch (path) {
    case EyePathClass::highlight:
        return EyePathClass::glossy;
    case EyePathClass::indirect:
        return EyePathClass::caustic;
    default:
        return path;
    }
}

/// Returns the class after a followed lobe.
inline EyePathClass after_followed(EyePathClass path)
{
    if (is_gathered(path))
        return EyePathClass::caustic;
    return path <= EyePathClass::highlight ? EyePathClass::highlight : EyePathClass::glossy;
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
