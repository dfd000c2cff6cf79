#include "render/integrator/missed_light.h"

#include "render/paths/roulette.h"

#include <algorithm>
#include <cmath>

namespace hipmap {

namespace {

/// The part of the error from which on lost light counts as much.
constexpr double kMuch = 0.1;

/// The most photons that a path leaves on average after it was cut: until roulette ends it.
constexpr double kPhotonsOfCutPath = 1 / (1 - double{kEndlessProbability});

/// The share of the image's light from which on unseen light always counts as much.
constexpr double kMuchUnseen = 0.25;

/// The error that missed light is compared with.
double known(const std::optional<ImageError>& error)
{
    if (!error)
        return 1;
    return std::isfinite(error->high) ? error->high : error->error;
}

/// Returns the share of the image's light that photons carried which did not count.
double lost_share(const RenderStatistics& statistics)
{
    const double lost = static_cast<double>(statistics.dropped_photons) +
                        kPhotonsOfCutPath * static_cast<double>(statistics.cut_paths);
    if (!(lost > 0))
        return 0;
    if (const double each = share_of_path(statistics.seen, statistics.seen_scale); each > 0)
        return lost * each;
    return lost / static_cast<double>(std::max<std::uint64_t>(1, statistics.emitted));
}

} // namespace

MissedLight find_missed_light(const RenderStatistics& statistics, PixelFilter filter,
                              std::size_t pixels)
{
    const double reached = filter == PixelFilter::box ? 1 : 9;
    MissedLight out;
    out.unseen = find_unseen_light(statistics.seen, statistics.seen_scale);
    out.lost.photons = lost_share(statistics);
    out.lost.samples2 = std::min(1.0, reached * static_cast<double>(statistics.dropped_samples) /
                                          static_cast<double>(std::max<std::size_t>(1, pixels)));
    return out;
}

ImageError with_lost_light(const ImageError& error, const LostLight& lost)
{
    ImageError out = error;
    if (lost.error2() > 0)
        out.high = std::sqrt(error.high * error.high + lost.error2());
    return out;
}

bool is_much(const UnseenLight& unseen, const std::optional<ImageError>& error)
{
    return unseen.most > std::min(kMuchUnseen, known(error));
}

bool is_much(const LostLight& lost, const std::optional<ImageError>& error)
{
    return std::sqrt(lost.error2()) > kMuch * known(error);
}

} // namespace hipmap
