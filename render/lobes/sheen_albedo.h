#pragma once

namespace hipmap {

// Fibres that stand on a surface (KHR_materials_sheen), docs/light_transport.md (28).  Cosines are
// those to the shading normal, of directions above the surface; alpha is from kLeastSheenAlpha
// to 1.

/// The least alpha: narrower lobes would scatter more light at grazing angles than arrives.
inline constexpr float kLeastSheenAlpha = 0.07f;

/// Returns the light that white fibres scatter from one direction to another, per steradian;
/// reciprocal. sin2_half: square of the sine between the normal and the half vector.
float sheen_lobe(float cos_in, float cos_out, float sin2_half, float alpha);

/// Returns the share of light along one direction that white fibres scatter, below 1: the integral
/// of the lobe times the cosine.  From a table that is made on the first call (some 0.1 s), within
/// 0.007 of the integral.  Thread-safe.
float sheen_albedo(float cosine, float alpha);

} // namespace hipmap
