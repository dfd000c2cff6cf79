#include "render/integrator/missed_light.h"

#include <algorithm>
#include <cmath>

namespace hipmap {

namespace {

/// The share of the image's light from which on unseen light always counts as much.
constexpr double kMuchUnseen = 0.25;

/// The error that missed light is compared with.
double known(const std::optional<ImageError>& error)
{
    if (!error)
        return 1;
    return std::isfinite(error->high) ? error->high : error->error;
}

} // namespace

MissedLight find_missed_light(const RenderStatistics& statistics)
{
    return {find_unseen_light(statistics.seen, statistics.seen_scale)};
}

bool is_much(const UnseenLight& unseen, const std::optional<ImageError>& error)
{
    return unseen.most > std::min(kMuchUnseen, known(error));
}

} // namespace hipmap
