#include "render/photons/cross_media.h"

#include "render/media/phase.h"

#include <algorithm>

namespace hipmap {

namespace {

constexpr int kMostScatterings = 1 << 14;

/// From this scattering of a path on, one of as many more leaves a photon: a path in milk would
/// leave thousands.
constexpr int kFullScatterings = 16;

/// For a path that a medium has scattered.
void stop_in_medium(LightPath& path)
{
    ++path.scatterings;
    if (path.behind == LightPathClass::direct)
        path.behind = LightPathClass::volume;
    path.last.photon = kNoPhoton;
    path.last.media = true;
    path.radiance = Rgb(0);
    path.nanometres = 0;
}

/// Keeps a photon where a medium scatters the path: at the origin of its ray.
void store_in_medium(const LightPath& path, const Wanted& wanted, RandomSequence& random,
                     TracedPhotons& out)
{
    const glm::vec3& position = path.ray.origin;
    const float probability = static_cast<float>(kFullScatterings) /
                              static_cast<float>(std::max(path.scatterings, kFullScatterings));
    if (!wants_class(path.behind, wanted) || !wanted.volume || !(random.next() < probability))
        return;
    const Rgb power = path.power * part_brought(path.behind, wanted) / probability;
    if (is_finite(power) && is_finite(position))
        out.volume.push_back({position, power, path.ray.direction, path.inside.current()});
    else
        ++out.dropped;
}

/// Whether a path that a medium scatters goes on: by Russian roulette against what it carried
/// before.
bool survives_in_medium(float before, const Wanted& wanted, RandomSequence& random, LightPath& path,
                        TracedPhotons& out)
{
    const float probability = std::min(1.0f, max_channel(path.power) / before);
    const bool goes_on = random.next() < probability && !is_done(path, wanted);
    const Rgb incoming = path.power;
    path.power = goes_on ? incoming / probability : Rgb(0);
    out.power.absorbed += glm::dvec3(incoming - path.power);
    return goes_on;
}

/// Sends the path on in a direction drawn from the phase function of its medium.
void scatter_in_medium(const MediaSet& media, RandomSequence& random, LightPath& path)
{
    const Medium& medium = media.medium(path.inside.current());
    path.ray.direction = sample_phase(medium.phase, path.ray.direction, random.next2());
    path.ray.far = std::numeric_limits<float>::infinity();
}

} // namespace

std::optional<RayHit> cross_media(const MediaSet& media, const Wanted& wanted,
                                  RandomSequence& random, LightPath& path, TracedPhotons& out)
{
    while (path.scatterings < kMostScatterings) {
        const Rgb before = path.power;
        const MediaFlight flight = fly_through_media<true>(
            media, path, path.power, random, [&](const Medium& medium, float optical_depth) {
                path.radiance *= transmitted(medium.extinction(), optical_depth);
            });
        out.power.absorbed += glm::dvec3(before - path.power);
        if (!flight.scattered) {
            if (!flight.hit)
                out.power.escaped += glm::dvec3(path.power);
            return flight.hit;
        }
        stop_in_medium(path);
        store_in_medium(path, wanted, random, out);
        if (!survives_in_medium(max_channel(before), wanted, random, path, out))
            return std::nullopt;
        scatter_in_medium(media, random, path);
    }
    ++out.cut;
    return std::nullopt;
}

} // namespace hipmap
