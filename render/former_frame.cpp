#include "render/former_frame.h"

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

PhotonCache& cache_for(FormerFrame& former, const Scene& scene, const Partition& partition,
                       const EnvironmentMap& sky, double most_mib)
{
    std::string world = world_of(scene, partition, sky);
    const bool first = former.world.empty(), same = former.world == world;
    if (!same)
        former.photons = {};
    former.world = std::move(world);
    former.photons.most = first || same ? static_cast<std::size_t>(most_mib * 0x1p20) : 0;
    former.photons.served = 0;
    return former.photons;
}

} // namespace hipmap
