#include "render/photons/media_flight.h"

#include "render/media/phase.h"

#include <algorithm>

namespace hipmap {

namespace {

constexpr int kMostScatterings = 1 << 14;

/// From this scattering of a path on, one of as many more leaves a photon: a path in milk would
/// leave thousands.
constexpr int kFullScatterings = 16;

/// Keeps a photon where a medium scatters the path.
void store_in_medium(const glm::vec3& position, MaterialId inside, const LightPath& path,
                     const Wanted& wanted, RandomSequence& random, TracedPhotons& out)
{
    const float chance = static_cast<float>(kFullScatterings) /
                         static_cast<float>(std::max(path.scatterings, kFullScatterings));
    if (!wants_class(path.behind, wanted) || !wanted.volume || !(random.next() < chance))
        return;
    const Rgb power = path.power / chance;
    if (is_finite(power) && is_finite(position))
        out.volume.push_back({position, power, path.ray.direction, inside});
    else
        ++out.dropped;
}

/// Scatters the path at a point of a medium, or ends it by Russian roulette against what it carried
/// before.
bool scatter_in_medium(const MediaSet& media, const glm::vec3& position, float before,
                       const Wanted& wanted, RandomSequence& random, LightPath& path,
                       TracedPhotons& out)
{
    const MaterialId inside = path.inside.current();
    ++path.scatterings;
    path.media_last = true;
    if (path.behind == LightPathClass::direct)
        path.behind = LightPathClass::volume;
    path.last = kNoPhoton;
    path.nanometres = 0;
    store_in_medium(position, inside, path, wanted, random, out);
    const float chance = std::min(1.0f, max_channel(path.power) / before);
    const bool goes_on = random.next() < chance && !is_done(path, wanted);
    const Rgb incoming = path.power;
    path.power = goes_on ? incoming / chance : Rgb(0);
    out.power.absorbed += glm::dvec3(incoming - path.power);
    path.ray.origin = position;
    path.ray.direction =
        sample_phase(media.medium(inside).phase, path.ray.direction, random.next2());
    path.ray.far = std::numeric_limits<float>::infinity();
    return goes_on;
}

} // namespace

std::optional<RayHit> fly_through_media(const MediaSet& media, const Wanted& wanted,
                                        RandomSequence& random, LightPath& path, TracedPhotons& out)
{
    while (path.scatterings < kMostScatterings) {
        const Rgb before = path.power;
        glm::vec3 position(0.0f);
        const WalkEnd end = walk<true>(media, path.ray, path.inside, [&](const Stretch& stretch) {
            const Column column = column_along(media.density(stretch.inside), stretch.ray);
            const Flight flight =
                sample_flight(media.medium(stretch.inside), column.whole, path.power, random);
            path.power *= flight.weight;
            position =
                stretch.ray.origin + distance_at(column, flight.column) * stretch.ray.direction;
            return !flight.scattered;
        });
        out.power.absorbed += glm::dvec3(before - path.power);
        if (!end.stopped) {
            if (!end.hit)
                out.power.escaped += glm::dvec3(path.power);
            return end.hit;
        }
        if (!scatter_in_medium(media, position, max_channel(before), wanted, random, path, out))
            return std::nullopt;
    }
    ++out.cut;
    return std::nullopt;
}

} // namespace hipmap
