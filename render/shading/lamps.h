#pragma once

#include "render/shading/lights.h"

#include <optional>

namespace hipmap {

// Lamps are numbered: first LightSet::punctual, then LightSet::area.  docs/light_transport.md (26).

std::size_t lamp_count(const LightSet& lights);

/// It is a sphere, a disc in the sky, a rectangle or an ellipse, which rays can run into.
bool has_size(const LightSet& lights, std::size_t lamp);

/// Power of a lamp that can reach the scene.
Rgb lamp_power(const LightSet& lights, std::size_t lamp);

/// Of a lamp that is no sun.
LightBounds bounds_of_lamp(const LightSet& lights, std::size_t lamp);

/// Light of a lamp, found from a point by a direction drawn.
struct LampSample {
    glm::vec3 direction{0.0f}; ///< unit, towards the lamp
    bool is_far = false;       ///< it comes from beyond the scene
    glm::vec3 point{0.0f};     ///< else from here
    Rgb light{0.0f};           ///< W/m2 across the direction, divided by `density` unless that is 0
    float density = 0.0f;      ///< of the direction, per solid angle; 0: the lamp has no size
};

/// u: for the direction, of a lamp with a size.  Nothing: the lamp does not shine there.
std::optional<LampSample> sample_lamp(const LightSet& lights, std::size_t lamp,
                                      const glm::vec3& position, const glm::vec2& u);

/// A lamp with a size that a ray runs into.
struct LampHit {
    float distance = 0.0f; ///< infinite for a sun
    Rgb radiance{0.0f};
    float density = 0.0f; ///< per solid angle, that `sample_lamp` at the ray's origin draws this
};

std::optional<LampHit> meet_lamp(const LightSet& lights, std::size_t lamp, const Ray& ray);

/// Where on the sphere of a lamp, no sun, light along `direction` starts that was drawn by
/// intensity: evenly over what is seen of it from there.
glm::vec3 leave_ball(const PunctualLight& light, const glm::vec3& direction, const glm::vec2& u);

/// A direction along which light of a sun with a size travels, evenly over its disc.
glm::vec3 leave_sun(const PunctualLight& light, const glm::vec2& u);

/// A point of an area light, evenly.
glm::vec3 point_on(const AreaLight& light, const glm::vec2& u);

double lamp_area(const AreaLight& light);

/// Unit vector whose height over the xy plane is `below` less than 1.
glm::vec3 direction_below_pole(float below, float u);

} // namespace hipmap
