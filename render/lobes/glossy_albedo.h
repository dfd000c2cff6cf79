#pragma once

#include "common/math/rgb.h"

namespace hipmap {

/// The albedo of GGX facets with Schlick's reflectance, as factors of F0 and F90,
/// docs/light_transport.md (18).
struct GlossyAlbedo {
    float f0 = 0.0f;
    float f90 = 0.0f;

    Rgb of(const Rgb& at_normal, const Rgb& at_grazing) const
    {
        return at_normal * f0 + at_grazing * f90;
    }
    /// Returns the albedo of facets that absorb nothing: 1 minus the light that would be reflected
    /// again.
    float white() const { return f0 + f90; }
};

/// Returns the share of light from one direction that is reflected over the whole hemisphere.
/// cosine: to the normal, [0, 1].  alpha: [0, 1].  From a table that is made on the first call
/// (some 10 ms), within 0.003 of the integral.  Thread-safe.
GlossyAlbedo glossy_albedo(float cosine, float alpha);

/// The two rows of the table between which the albedos of one width lie, by sqrt(cosine).
struct GlossyAlbedoRows {
    const GlossyAlbedo* low;
    const GlossyAlbedo* high;
    float part;  ///< of the way from low to high
    int columns; ///< of a row
};

/// Returns the rows that glossy_albedo interpolates between, first along each, then across.
GlossyAlbedoRows glossy_albedo_rows(float alpha);

/// Returns the average of the albedo over the cosine-weighted hemisphere, exactly that of the
/// table.
GlossyAlbedo average_glossy_albedo(float alpha);

} // namespace hipmap
