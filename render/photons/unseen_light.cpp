#include "render/photons/unseen_light.h"

#include "common/math/poisson.h"

#include <algorithm>
#include <cmath>

namespace hipmap {

namespace {

/// Returns the most that a photon of a light is worth.
double worth_of_path(const SeenClasses::OfLight& light, const SeenScale& scale)
{
    return std::max(double{light.caustic} * scale.caustic_worth,
                    double{light.global} * scale.global_worth);
}

/// Returns the light of the images of all passes together.
double light_of(const SeenClasses& classes, const SeenScale& scale)
{
    return std::max(scale.light * static_cast<double>(classes.passes),
                    static_cast<double>(classes.worth) * scale.unit);
}

bool is_counted(const SeenClasses& classes, const SeenScale& scale)
{
    return scale.unit > 0 && classes.passes > 0;
}

bool reached(const SeenClasses& classes, const SeenScale& scale, std::size_t light)
{
    return classes.lights[light].paths > 0 ||
           (light < scale.reached.size() && scale.reached[light] != 0);
}

/// Worth of the paths that were missed.
struct Missed {
    double sum = 0, largest = 0;
    std::size_t light = 0; ///< of the largest

    void add(double worth, std::size_t from)
    {
        sum += worth;
        if (worth > largest) {
            largest = worth;
            light = from;
        }
    }
};

} // namespace

SeenScale scale_of(const SeenSurfaces& seen)
{
    return {seen.unit, seen.light, seen.caustic.mean_worth, seen.global.mean_worth, seen.reached};
}

std::optional<UnseenLight> find_unseen_light(const SeenClasses& classes, const SeenScale& scale)
{
    if (!is_counted(classes, scale))
        return std::nullopt;
    UnseenLight out{.passes = classes.passes, .paths = count_paths(classes)};
    Missed once, never;
    for (const SeenClasses::Class& of : classes.classes)
        if (of.paths == 1) {
            ++out.classes_once;
            once.add(static_cast<double>(of.worth) * scale.unit, of.light);
        }
    for (std::size_t i = 0; i < classes.lights.size(); ++i)
        if (const double worth = worth_of_path(classes.lights[i], scale);
            worth > 0 && !reached(classes, scale, i)) {
            ++out.lights_never;
            never.add(worth, i);
        }
    const auto count = static_cast<double>(out.classes_once);
    const double by_once = count > 0 ? once.sum * most_expected(count) / count : 0;
    const double by_never = never.largest * most_expected(0);
    const double light = light_of(classes, scale);
    out.never = by_never > by_once;
    out.light = out.never ? never.light : once.light;
    out.share = once.sum > 0 ? once.sum / light : 0;
    out.most = by_once + by_never > 0 ? (by_once + by_never) / light : 0;
    return out;
}

double share_of_path(const SeenClasses& classes, const SeenScale& scale)
{
    if (!is_counted(classes, scale))
        return 0;
    double most = 0;
    for (const SeenClasses::OfLight& light : classes.lights)
        most = std::max(most, worth_of_path(light, scale));
    return most > 0 ? most / light_of(classes, scale) : 0;
}

} // namespace hipmap
