#pragma once

#include "common/math/random.h"
#include "render/shading/bsdf.h"

namespace hipmap {

// Reflection by the models that a material may name instead of glTF's own, Phong's and Schlick's:
// all but the diffuse lobe, which is Lambert's.  docs/light_transport.md (35), (36).  Directions
// are unit, away from the surface; cosines are those to the shading normal.

/// Makes all that has to do with reflection; the material names a model.
void make_modelled(const Material& material, const MaterialPoint& at, Bsdf& out);

/// What is spread: f(wi, wo), per steradian, the same both ways.  Both above the surface; the
/// reflection is no mirror.
Rgb modelled_lobe(const Bsdf& bsdf, const glm::vec3& normal, const glm::vec3& in,
                  const glm::vec3& out);

/// Chance per steradian that `draw_modelled` draws `in`.
float modelled_density(const Bsdf& bsdf, const glm::vec3& normal, const glm::vec3& in,
                       const glm::vec3& out);

/// A direction about as what is spread is distributed; it may lie below the surface.
glm::vec3 draw_modelled(const Bsdf& bsdf, const glm::vec3& normal, const glm::vec3& out,
                        RandomSequence& random);

/// About the share of light along one direction that is spread, for chances.
Rgb modelled_albedo(const Bsdf& bsdf, float cosine);

/// The share of it that is reflected as by a mirror.
Rgb modelled_mirror(const Bsdf& bsdf, float cosine);

} // namespace hipmap
