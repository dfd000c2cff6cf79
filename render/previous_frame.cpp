#include "render/previous_frame.h"

#include "common/partition/partition_file.h"
#include "common/scene/fingerprint.h"

namespace hipmap {

namespace {

std::string world_of(const Scene& scene, const Partition& partition, const EnvironmentMap& sky)
{
    const Fingerprint still = still_fingerprint(scene);
    std::string out;
    for (const std::uint64_t word : {still.words[0], still.words[1], partition_checksum(partition),
                                     sky.empty() ? std::uint64_t{0} : checksum(sky)})
        out += std::to_string(word) + " ";
    return out;
}

} // namespace

std::optional<double> FramePlace::seconds_left(double share) const
{
    const double frames = done - ready + share;
    if (!(frames > 0))
        return std::nullopt;
    return (watch.seconds() - ready_seconds) * (all - done - share) / frames;
}

void FramePlace::end_frame(bool took_passes)
{
    const double now = watch.seconds();
    if (!took_passes) {
        ++ready;
        ready_seconds += now - begun;
    }
    begun = now;
    ++done;
}

std::string FramePlace::text() const
{
    return "frame " + std::to_string(done + 1) + " of " + std::to_string(all);
}

FramePlace* place_of(PreviousFrame* previous)
{
    return previous != nullptr && previous->place.all > 1 ? &previous->place : nullptr;
}

PhotonCache& cache_for(PreviousFrame& previous, const Scene& scene, const Partition& partition,
                       const EnvironmentMap& sky, double most_mib)
{
    std::string world = world_of(scene, partition, sky);
    PhotonCache& cache = previous.photons;
    if (previous.world != world)
        change_scene(cache);
    previous.world = std::move(world);
    cache.most = static_cast<std::size_t>(most_mib * 0x1p20);
    cache.served = cache.taken_over = cache.built = 0;
    return cache;
}

} // namespace hipmap
