#pragma once

#include "common/math/sampling.h"
#include "render/shading/scatter.h"

namespace hipmap::tiny {

/// A point of a flat surface of the material, seen from `back`: in front of it if back.z > 0.
inline Interaction lit_surface(const Material& material, const glm::vec3& back, bool solid = true,
                               DiffuseModel model = DiffuseModel::lambert)
{
    Interaction at;
    at.bsdf = make_bsdf(material, material_factors(material), model);
    at.point.geometric_normal = at.point.shading_normal = {0, 0, 1};
    at.back = glm::normalize(back);
    at.front = back.z > 0;
    at.normal = at.shading_normal = {0, 0, at.front ? 1 : -1};
    at.cosine = glm::dot(at.back, at.normal);
    at.solid = solid;
    return at;
}

/// The same with its shading normal tilted, so that much of what it reflects lies behind the face.
inline Interaction tilted_surface(const Material& material, const glm::vec3& back)
{
    Interaction at = lit_surface(material, back);
    at.shading_normal = glm::normalize(at.normal + 0.5f * at.back * glm::vec3(-1, -1, 0));
    at.cosine = glm::dot(at.back, at.shading_normal);
    return at;
}

/// Midpoints of a grid of polar angle and azimuth over the whole sphere: `each(direction, solid
/// angle)`.
template <typename Each>
void over_sphere(int rows, Each&& each)
{
    const int columns = 2 * rows;
    const double step = std::numbers::pi / rows;
    for (int i = 0; i < rows; ++i) {
        const double solid_angle = (std::cos(i * step) - std::cos((i + 1) * step)) * step;
        const auto cosine = static_cast<float>(std::cos((i + 0.5) * step));
        for (int j = 0; j < columns; ++j)
            each(direction_from_cosine(cosine, (j + 0.5f) / columns), solid_angle);
    }
}

} // namespace hipmap::tiny
