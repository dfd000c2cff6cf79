#pragma once

#include "common/math/random.h"
#include "render/shading/interaction.h"

namespace hipmap {

// Light scattered by the lobes of a surface below their layers, or by the phase function of a
// medium, which is a gathered lobe.  Each of the sets `gathered` and `followed` has a pdf of
// its own; with the specular lobes they are all that there is.

/// The value and the pdf of lobes for light from a direction.
struct Scattered {
    Rgb value{0.0f};  ///< f(wi, wo) |cos wi|, per steradian; of radiance, from wi to at.back
    float pdf = 0.0f; ///< probability per steradian that `sample_scatter` draws wi
};

/// Evaluates lobes.  in: unit, away from the surface, on either side.  Zero where the lobes send
/// nothing. Thread-safe. docs/light_transport.md (16), (17).
Scattered scattered(const Interaction& at, const glm::vec3& in, Lobes lobes);

/// A direction drawn from lobes.
struct ScatterSample : LobeSample {
    float pdf = 0.0f; ///< per steradian, as `scattered` has it

    // Radiance, followed backwards, is the weight over the square of eta.
};

/// Draws a lobe in proportion to its albedo, then a direction from it.  The mean of the weight is
/// the share of light that the lobes scatter; its expectation over a function of direction is
/// exact.  Thread-safe.
ScatterSample sample_scatter(const Interaction& at, Lobes lobes, RandomSequence& random);

/// Returns the pdf of the followed lobes, per steradian, for reflection straight back at
/// perpendicular incidence.  It is about their largest at any angle of incidence.
float followed_peak(const Interaction& at);

/// Draws a direction from one lobe of the surface for a particle.  Its weight stays bounded: by
/// what the facet drawn reflects and transmits, or by the albedo of a diffuse lobe.
LobeSample sample_lobe(const Interaction& at, const PlacedLobe& lobe, RandomSequence& random);

/// Returns about the share of light that the lobes scatter, for probabilities: zero only if they
/// scatter none.
Rgb scattered_share(const Interaction& at, Lobes lobes);

/// Returns the shares of light from (or to) `back` that smooth lobes reflect and transmit.  Zero
/// where all lobes are spread.
SpecularLobes specular_lobes(const Interaction& at);

/// Returns the ray along a drawn direction.
Ray scattered_ray(const Interaction& at, const LobeSample& sample);

} // namespace hipmap
