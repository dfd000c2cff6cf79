#pragma once

#include "common/math/random.h"
#include "render/shading/interaction.h"

namespace hipmap {

/// The lobes of a surface that are not specular (a medium's phase function is a gathered lobe), by
/// what becomes of their light: gathered from photons (diffuse, and reflections rougher than
/// kFollowedRoughness), or followed along a direction drawn (smoother reflections, rough glass).
/// The two together are all; each has its own density.
enum class Lobes : std::uint8_t { gathered, followed };

/// What the lobes do with light from a direction.
struct Scattered {
    Rgb value{0.0f};      ///< f(wi, wo) |cos wi|, per steradian; of radiance, from wi to at.back
    float density = 0.0f; ///< chance per steradian that `sample_scatter` draws wi
};

/// in: unit, away from the surface, on either side.  Zero where the lobes send nothing.
/// Thread-safe. docs/light_transport.md (16), (17).
Scattered scattered(const Interaction& at, const glm::vec3& in, Lobes lobes);

/// A direction drawn from the lobes.
struct ScatterSample {
    glm::vec3 direction{0.0f}; ///< unit, away from the surface
    Rgb weight{0.0f};          ///< share of a particle's power that goes there; 0: the path ends
    float density = 0.0f;      ///< per steradian, as `scattered` has it
    float eta = 1.0f; ///< index there over index at at.back; radiance, followed backwards, is
                      ///<   the weight over its square
    bool transmitted = false;
};

/// Draws by visible normals and by the cosine, each lobe in proportion to its albedo.  The mean of
/// the weight is the share of light that the lobes scatter; its expectation over a function of
/// direction is exact.  Thread-safe.
ScatterSample sample_scatter(const Interaction& at, Lobes lobes, RandomSequence& random);

/// The same from the facets of the lobes alone, without diffuse lobe and sheen: no weight exceeds
/// the sum of what the facet drawn reflects and transmits.
ScatterSample sample_facets(const Interaction& at, Lobes lobes, RandomSequence& random);

/// The same from the fibres of a sheen, which there must be.
ScatterSample sample_sheen(const Interaction& at, RandomSequence& random);

/// About the share of light that the lobes scatter, for chances: zero only if they scatter none.
Rgb scattered_share(const Interaction& at, Lobes lobes);

/// The ray along a direction drawn.
Ray scattered_ray(const Interaction& at, const ScatterSample& sample);

} // namespace hipmap
