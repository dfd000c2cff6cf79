#pragma once

#include "common/math/random.h"
#include "common/math/rgb.h"

#include <glm/glm.hpp>

namespace hipmap {

/// A surface from the point of view of a lobe.  Directions are unit and point away from the
/// surface.
struct LobeView {
    glm::vec3 normal{0.0f};  ///< of the lobe, on the side of `out`
    glm::vec3 out{0.0f};     ///< where light goes to (or comes from: lobes are reciprocal)
    float cosine = 1.0f;     ///< dot(normal, out), above zero
    glm::vec3 tangent{0.0f}; ///< unit, at a right angle to the normal; zero: there is none
    float eta = 1.0f;   ///< index of refraction on the other side over that on the side of `out`
    bool solid = false; ///< the surface bounds a solid; false: it is a thin wall

    bool has_tangent() const { return tangent != glm::vec3(0); }
};

/// A direction drawn from a lobe.
struct LobeSample {
    glm::vec3 direction{0.0f}; ///< unit, away from the surface
    Rgb weight{0.0f};          ///< share of a particle's power that goes there; 0: none
    float eta = 1.0f;          ///< index of refraction there over that at `out`
    bool transmitted = false;
};

/// Shares of light that a smooth surface reflects and transmits, each in one direction.
struct SpecularLobes {
    Rgb mirror{0.0f};
    Rgb transmit{0.0f};
    float eta = 1.0f; ///< as in LobeView; 1 through a thin wall, which is crossed straight
};

} // namespace hipmap
