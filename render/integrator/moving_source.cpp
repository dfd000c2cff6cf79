#include "render/integrator/moving_source.h"

#include "common/math/random.h"
#include "common/partition/partition_in_motion.h"
#include "render/integrator/integrators.h"

namespace hipmap {

namespace {

constexpr std::uint64_t kNoPixel = ~std::uint64_t{0};

} // namespace

double shutter_share(std::uint64_t seed, std::uint64_t pass)
{
    RandomSequence random(seed, RandomStream::pictures, pass % kBatches, kNoPixel, pass / kBatches);
    return random.next();
}

PassSource make_moving_source(const MovingScene& moving, const RenderOptions& options,
                              RenderStatistics& statistics, const PilotControl& pilots)
{
    PassSource source = make_pass_source(moving.still, options, statistics, nullptr, pilots);
    source.render = [moving, seed = options.seed,
                     render_in = source.render_in](std::uint64_t pass, const PassControl& control) {
        const Scene scene = moving.at(shutter_share(seed, pass));
        const Partition partition =
            partition_in_motion(moving.still.partition, moving.still.mesh(), scene.mesh);
        const RenderScene now(scene, partition, moving.still.environment_map);
        return render_in(now, pass, control);
    };
    return source;
}

} // namespace hipmap
