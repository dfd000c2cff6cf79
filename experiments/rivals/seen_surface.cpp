#include "experiments/rivals/seen_surface.h"

#include "render/paths/roulette.h"

namespace hipmap {

void leave_unless_gathered(const RenderScene& scene, const Interaction& at, RandomSequence& random,
                           PathState& path, Rgb& radiance)
{
    if (at.is_diffuse()) {
        path.throughput = Rgb(0);
        return;
    }
    const SpecularLobes lobes = specular_lobes(at);
    const float followed =
        at.follows() ? max_channel(path.throughput * scattered_share(at, Lobes::followed)) : 0;
    const float mirror = max_channel(path.throughput * lobes.mirror);
    const float transmit = max_channel(path.throughput * lobes.transmit);
    const float sum = followed + mirror + transmit;
    const float drawn = random.next() * sum;
    if (followed > 0)
        radiance +=
            path.throughput * light_sampled_light(scene, at, {.followed = followed / sum}, random);
    if (!(sum > 0))
        path.throughput = Rgb(0);
    else if (drawn < followed)
        go_by_lobes(scene, at, {Lobes::followed, followed / sum}, random, path);
    else if (drawn < followed + mirror)
        go_by_mirror(scene, at, lobes, mirror / sum, path);
    else
        go_through(scene, at, lobes, transmit / sum, path);
}

} // namespace hipmap
