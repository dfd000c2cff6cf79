#include "render/lights/aim.h"

#include "common/math/frame.h"
#include "common/math/sampling.h"
#include "common/math/sphere_cone.h"
#include "render/lights/cone.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hipmap {

namespace {

bool in_cone(const TargetSphere& target, float height, const glm::vec3& origin,
             const glm::vec3& direction)
{
    if (height >= 2)
        return true;
    const glm::vec3 axis = glm::normalize(target.centre - origin);
    const glm::vec3 sine = glm::cross(axis, direction); // steadier than the cosine in thin cones
    return glm::dot(axis, direction) > 0 && glm::dot(sine, sine) < height * (2 - height);
}

bool in_cylinder(const TargetSphere& target, const glm::vec3& point, const glm::vec3& direction)
{
    const glm::vec3 across = glm::cross(point - target.centre, direction);
    return glm::dot(across, across) < target.radius * target.radius;
}

/// Roulette where `count` cones or cylinders overlap: all that is aimed has the same weight then,
/// and no photon stands out.
bool survives(int count, RandomSequence& random)
{
    return random.next() * static_cast<float>(count) < 1;
}

} // namespace

AimedRay aim_from_point(const std::vector<TargetSphere>& targets, const glm::vec3& origin,
                        const LightCone& light, RandomSequence& random)
{
    std::array<float, kMostTargets> heights;
    float sum = 0;
    for (std::size_t i = 0; i < targets.size(); ++i)
        sum += heights[i] = cone_height(targets[i].centre - origin, targets[i].radius, light.axis,
                                        light.half_angle);
    if (!(sum > 0))
        return {};
    float drawn = random.next() * sum;
    std::size_t chosen = 0;
    while (chosen + 1 < targets.size() && drawn >= heights[chosen])
        drawn -= heights[chosen++];
    const glm::vec2 u = random.next2();
    const glm::vec3 way = targets[chosen].centre - origin;
    // From inside a sphere any direction will do, and the centre may be the origin itself.
    const glm::vec3 axis = heights[chosen] >= 2 ? glm::vec3(0, 0, 1) : glm::normalize(way);
    AimedRay out;
    out.direction = Frame(axis).to_world(direction_below_pole(heights[chosen] * u.x, u.y));
    int cones = 1; // the chosen one, whatever rounding says
    for (std::size_t i = 0; i < targets.size(); ++i)
        cones += i != chosen && in_cone(targets[i], heights[i], origin, out.direction) ? 1 : 0;
    out.weight = survives(cones, random) ? 2 * kPi * sum : 0;
    return out;
}

AimedPoint aim_parallel(const std::vector<TargetSphere>& targets, const glm::vec3& direction,
                        RandomSequence& random)
{
    float sum = 0;
    for (const TargetSphere& target : targets)
        sum += target.radius * target.radius;
    float drawn = random.next() * sum;
    std::size_t chosen = 0;
    while (chosen + 1 < targets.size() && drawn >= targets[chosen].radius * targets[chosen].radius)
        drawn -= targets[chosen].radius * targets[chosen].radius, ++chosen;
    const glm::vec2 disc = targets[chosen].radius * sample_disc(random.next2());
    const Frame frame(direction);
    AimedPoint out;
    out.position = targets[chosen].centre + frame.x * disc.x + frame.y * disc.y;
    int cylinders = 1;
    for (std::size_t i = 0; i < targets.size(); ++i)
        cylinders += i != chosen && in_cylinder(targets[i], out.position, direction) ? 1 : 0;
    out.weight = survives(cylinders, random) ? kPi * sum : 0;
    return out;
}

} // namespace hipmap
