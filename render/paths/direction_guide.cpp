#include "render/paths/direction_guide.h"

#include <algorithm>
#include <cmath>

namespace hipmap {

namespace {

constexpr float kBelowOne = 0x1.fffffep-1f;

/// The place of a unit direction in the square of cosine and longitude, [0, 1)^2.
glm::vec2 on_square(const glm::vec3& direction)
{
    const float turn = std::atan2(direction.z, direction.x) / (2 * kPi);
    return glm::clamp(glm::vec2((1 - direction.y) / 2, turn < 0 ? turn + 1 : turn), 0.0f,
                      kBelowOne);
}

float share_of(const DirectionGuide& guide, std::size_t cell)
{
    return guide.up_to[cell] - (cell == 0 ? 0.0f : guide.up_to[cell - 1]);
}

} // namespace

std::size_t cell_of(const glm::vec3& direction)
{
    const glm::vec2 at = on_square(direction);
    return static_cast<std::size_t>(at.x * DirectionGuide::kRows) * DirectionGuide::kColumns +
           static_cast<std::size_t>(at.y * DirectionGuide::kColumns);
}

glm::vec3 direction_in(std::size_t cell, const glm::vec2& u)
{
    const auto row = static_cast<float>(cell / DirectionGuide::kColumns);
    const auto column = static_cast<float>(cell % DirectionGuide::kColumns);
    const float y = 1 - 2 * (row + u.x) / DirectionGuide::kRows;
    const glm::vec3 about_z = direction_from_cosine(y, (column + u.y) / DirectionGuide::kColumns);
    return {about_z.x, about_z.z, about_z.y};
}

glm::vec3 draw(const DirectionGuide& guide, const glm::vec2& u)
{
    const auto last = guide.up_to.end() - 1;
    const auto cell = static_cast<std::size_t>(std::upper_bound(guide.up_to.begin(), last, u.x) -
                                               guide.up_to.begin());
    const float share = share_of(guide, cell);
    const float left = u.x - (guide.up_to[cell] - share);
    return direction_in(cell, {share > 0 ? std::min(left / share, kBelowOne) : 0.0f, u.y});
}

float mixed_pdf(const DirectionGuide& guide, float lobes_pdf, const glm::vec3& direction)
{
    const float by_grid =
        share_of(guide, cell_of(direction)) * (DirectionGuide::kCells / (4 * kPi));
    return guide.by_lobes * lobes_pdf + (1 - guide.by_lobes) * by_grid;
}

} // namespace hipmap
