#include "render/lights/flat_shape.h"

#include "common/math/sampling.h"

#include <cmath>

namespace hipmap {

double area(const FlatShape& shape)
{
    const double rectangle =
        4 * glm::length(glm::cross(glm::dvec3(shape.half_right), glm::dvec3(shape.half_up)));
    return shape.outline == FlatShape::Outline::ellipse ? rectangle * (kPi / 4) : rectangle;
}

glm::vec3 point_on(const FlatShape& shape, const glm::vec2& u)
{
    const glm::vec2 at =
        shape.outline == FlatShape::Outline::ellipse ? sample_disc(u) : 2.0f * u - 1.0f;
    return shape.centre + at.x * shape.half_right + at.y * shape.half_up;
}

bool holds(const FlatShape& shape, const glm::vec3& point)
{
    // The point in units of the sides, which need not be at right angles.
    const glm::dvec3 from(point - shape.centre), right(shape.half_right), up(shape.half_up);
    const double rr = glm::dot(right, right), uu = glm::dot(up, up), ru = glm::dot(right, up);
    const double fr = glm::dot(from, right), fu = glm::dot(from, up), whole = rr * uu - ru * ru;
    const double x = (fr * uu - fu * ru) / whole, y = (fu * rr - fr * ru) / whole;
    return shape.outline == FlatShape::Outline::ellipse ? x * x + y * y < 1
                                                        : std::abs(x) < 1 && std::abs(y) < 1;
}

Bounds<glm::vec3> bounds(const FlatShape& shape)
{
    Bounds<glm::vec3> out;
    for (const float right : {-1.0f, 1.0f})
        for (const float up : {-1.0f, 1.0f})
            out.add(shape.centre + right * shape.half_right + up * shape.half_up);
    return out;
}

} // namespace hipmap
