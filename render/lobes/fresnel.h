#pragma once

#include "common/math/fresnel.h"
#include "common/math/rgb.h"

namespace hipmap {

/// The average of (1 - cosine)^5 over the cosine-weighted hemisphere.
inline constexpr float kAverageGrazingWeight = 1.0f / 21;

/// Returns the cosine-weighted average over the hemisphere of a Reflectance's weight of F90, for a
/// dielectric's Fresnel curve, docs/light_transport.md (38).  index: of refraction, above 1.
float average_dielectric_weight(float index);

/// Reflectance of a metal or of the surface of a dielectric, from F0 at normal to F90 at grazing
/// incidence, docs/light_transport.md (2), (38).  cosine: of incidence, [0, 1].
struct Reflectance {
    Rgb f0{0.0f}, f90{0.0f};
    float index = 0.0f; ///< above 1: along the curve of a dielectric of this index of refraction;
                        ///<   0: along Schlick's (1 - cosine)^5

    Rgb operator()(float cosine) const { return f0 + (f90 - f0) * weight(cosine); }
    /// Returns the average over the cosine-weighted hemisphere, docs/light_transport.md (3).
    Rgb average() const { return f0 + (f90 - f0) * average_weight(); }
    float average_weight() const
    {
        return index > 0 ? average_dielectric_weight(index) : kAverageGrazingWeight;
    }
    bool is_zero() const { return is_black(f0) && is_black(f90); }

  private:
    float weight(float cosine) const
    {
        if (!(index > 0)) [[likely]]
            return grazing_weight(cosine);
        const float least = reflectance_of_index(index);
        return (fresnel_dielectric(cosine, index) - least) / (1 - least);
    }
};

/// Returns fresnel_dielectric scaled by KHR_materials_specular's `scale`; still 1 at total
/// reflection.
Rgb scaled_fresnel(float cosine, float eta, const Rgb& scale);

} // namespace hipmap
