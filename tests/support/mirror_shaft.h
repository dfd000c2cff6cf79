#pragma once

#include "tests/support/tiny_scenes.h"

#include <cmath>

namespace hipmap::tiny {

/// Two mirrors that face each other across x from 0 to `width`: light that enters from above at 45
/// degrees, to the right, leaves below after exactly `bounces` of them.  Depth along z: 0.4.
struct MirrorShaft {
    int bounces = 0;
    float width = 0;
    Rgb base_color{1.0f}; ///< reflectance of a mirror at normal incidence

    float height() const { return static_cast<float>(bounces) * width; }
    glm::vec3 entering() const { return glm::normalize(glm::vec3(1, -1, 0)); }

    Scene scene() const
    {
        const glm::vec3 down(0, -height(), 0), along(0, 0, 0.4f), corner(0, 0, -0.2f);
        Scene scene = make_scene(parallelogram(corner, down, along));
        scene.materials[0] = mirror(base_color);
        add(scene, parallelogram(corner + glm::vec3(width, 0, 0), along, down), mirror(base_color));
        return scene;
    }

    /// What one channel keeps of light on its way through: Schlick's reflectance at 45 degrees.
    double passed(int channel) const
    {
        const double at_normal = base_color[channel];
        return std::pow(at_normal + (1 - at_normal) * std::pow(1 - std::sqrt(0.5), 5), bounces);
    }
    double passed() const { return (passed(0) + passed(1) + passed(2)) / 3; }
};

} // namespace hipmap::tiny
