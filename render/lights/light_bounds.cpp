#include "render/lights/light_bounds.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hipmap {

namespace {

using std::numbers::pi;

/// An angle from 0 to pi.
struct Angle {
    double cosine = 1, sine = 0;
};

Angle with_cosine(double cosine)
{
    const double c = std::clamp(cosine, -1.0, 1.0);
    return {c, std::sqrt(1 - c * c)};
}

/// a - b, or 0 where that is below zero.
Angle less(const Angle& a, const Angle& b)
{
    if (a.cosine >= b.cosine)
        return {};
    return {a.cosine * b.cosine + a.sine * b.sine, a.sine * b.cosine - a.cosine * b.sine};
}

struct Cone {
    glm::dvec3 axis;
    double half_angle;
};

/// The narrowest cone around both.
Cone around(const Cone& a, const Cone& b)
{
    const Cone& wide = a.half_angle >= b.half_angle ? a : b;
    const Cone& thin = a.half_angle >= b.half_angle ? b : a;
    const double between = std::acos(std::clamp(glm::dot(wide.axis, thin.axis), -1.0, 1.0));
    if (between + thin.half_angle <= wide.half_angle)
        return wide;
    const double half_angle = 0.5 * (wide.half_angle + between + thin.half_angle);
    const glm::dvec3 across = glm::cross(wide.axis, thin.axis);
    const double sine = glm::length(across);
    if (half_angle >= pi || !(sine > 0))
        return {wide.axis, pi};
    // Turned from the wide axis towards the thin one.
    const double turn = half_angle - wide.half_angle;
    const glm::dvec3 towards = glm::cross(across / sine, wide.axis);
    return {glm::normalize(std::cos(turn) * wide.axis + std::sin(turn) * towards), half_angle};
}

Cone cone_of(const LightBounds& lights)
{
    return {glm::dvec3(lights.axis), std::acos(std::clamp(double{lights.cos_spread}, -1.0, 1.0))};
}

} // namespace

LightBounds together(const LightBounds& a, const LightBounds& b)
{
    LightBounds out = a;
    out.box.add(b.box.low);
    out.box.add(b.box.high);
    out.power = a.power + b.power;
    out.both_sides = a.both_sides || b.both_sides;
    out.cos_reach = std::min(a.cos_reach, b.cos_reach);
    Cone other = cone_of(b);
    if (b.both_sides && glm::dot(a.axis, b.axis) < 0)
        other.axis = -other.axis;
    const Cone cone = around(cone_of(a), other);
    out.axis = glm::vec3(cone.axis);
    // Rounded outward.
    out.cos_spread = static_cast<float>(std::max(-1.0, std::cos(cone.half_angle) - 1e-6));
    return out;
}

double importance(const LightBounds& lights, const LightReceiver& at)
{
    const glm::dvec3 low(lights.box.low), high(lights.box.high);
    const glm::dvec3 way = glm::dvec3(at.position) - 0.5 * (low + high); // from the lights
    const glm::dvec3 half = 0.5 * (high - low);
    const double distance2 = glm::dot(way, way), radius2 = glm::dot(half, half);
    const double bounded2 = std::max(distance2, radius2);
    if (!(bounded2 > 0))
        return 0;
    // Inside the sphere around the box light may come from anywhere.
    if (distance2 <= radius2)
        return lights.power / bounded2;
    const glm::dvec3 direction = way / std::sqrt(distance2);
    const Angle box{std::sqrt(1 - radius2 / distance2), std::sqrt(radius2 / distance2)};
    Angle beyond;
    if (lights.cos_spread > -1) { // else no direction is off the cone
        const double off_axis = glm::dot(glm::dvec3(lights.axis), direction);
        const Angle from_axis = with_cosine(lights.both_sides ? std::abs(off_axis) : off_axis);
        beyond = less(less(from_axis, with_cosine(lights.cos_spread)), box);
    }
    if (beyond.cosine <= lights.cos_reach)
        return 0;
    double arriving = 1;
    if (at.normal != glm::vec3(0))
        arriving = less(with_cosine(-glm::dot(glm::dvec3(at.normal), direction)), box).cosine;
    return lights.power * std::max(beyond.cosine, 0.0) * std::max(arriving, 0.0) / bounded2;
}

bool may_meet(const Bounds<glm::vec3>& box, const glm::vec3& origin, const glm::vec3& direction)
{
    constexpr double kMargin = 1 + 1e-5; // for the rounding of a unit vector
    const glm::dvec3 low(box.low), high(box.high), half = 0.5 * (high - low);
    const glm::dvec3 way = 0.5 * (low + high) - glm::dvec3(origin);
    const double along = glm::dot(way, glm::dvec3(direction));
    const double radius2 = kMargin * glm::dot(half, half), distance2 = glm::dot(way, way);
    return distance2 <= radius2 ||
           (along > 0 && distance2 - along * along <= radius2 + 1e-6 * distance2);
}

double spread_cost(const LightBounds& lights)
{
    const double spread = std::acos(std::clamp(double{lights.cos_spread}, -1.0, 1.0));
    const double reach = std::acos(std::clamp(double{lights.cos_reach}, -1.0, 1.0));
    const double whole = std::min(spread + reach, pi);
    const double solid_angle = 2 * pi * (1 - std::cos(spread)) +
                               pi / 2 *
                                   (2 * whole * std::sin(spread) - std::cos(spread - 2 * whole) -
                                    2 * spread * std::sin(spread) + std::cos(spread));
    const glm::dvec3 extent(lights.box.extent());
    return lights.power * glm::dot(extent, extent) * (lights.both_sides ? 2 : 1) * solid_angle;
}

} // namespace hipmap
