#pragma once

#include "render/lights/light_kind.h"

namespace hipmap {

/// A sphere around all faces of a scene, into which light from outside the scene is sent.
struct SceneSphere {
    glm::vec3 centre{0.0f};
    float radius = 0.0f; ///< scene units; 0: there are no faces

    /// Returns the area of the disc through the centre, in square scene units.
    float disc_area() const;
};

/// Returns a ray along `direction` (unit) through a point drawn evenly from the disc of the sphere
/// across it. The ray starts outside the sphere.
Ray ray_into(const SceneSphere& scene, const glm::vec3& direction, const glm::vec2& u);

/// Returns the u from which `ray_into` makes a ray along the same line.  direction: unit.
glm::vec2 disc_sample_of(const SceneSphere& scene, const Ray& ray);

/// Light from one direction.
struct ParallelLight {
    glm::vec3 direction; ///< unit, along which it travels
    Rgb irradiance;      ///< W/m2 across the direction, divided by its pdf if it was drawn
    Rgb radiance;        ///< W/(m2 sr); infinite: of a light without a size
};

/// Returns a path of the light into the scene, drawn as by `ray_into`.
EmittedPath path_along(const SceneSphere& scene, const ParallelLight& light,
                       RandomSequence& random);

/// Returns a path of the light that is aimed at the targets.
EmittedPath aimed_path_along(const SceneSphere& scene, const ParallelLight& light,
                             const std::vector<TargetSphere>& targets, RandomSequence& random);

} // namespace hipmap
