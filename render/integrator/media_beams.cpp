#include "render/integrator/media_beams.h"

namespace hipmap {

std::optional<RayHit> see_media(const MediaBeams& beams, const Ray& ray, bool glows,
                                const SeenThrough& seen)
{
    return walk(beams.media, ray, seen.inside,
                [&](const Stretch& stretch) {
                    if (glows) {
                        const Medium& medium = beams.media.medium(stretch.inside);
                        const Column column =
                            column_along(beams.media.density(stretch.inside), stretch.ray);
                        const Rgb glow = emitted_along(medium, column.whole);
                        const std::array<Rgb, 3> scattered = beam_radiance(
                            beams.photons, {medium, stretch.inside, column}, beams.scales);
                        for (std::size_t i = 0; i < scattered.size(); ++i)
                            seen.radiance[i] += seen.weight * (glow + scattered[i]);
                    }
                    seen.weight *= left_along(beams.media, stretch);
                    return true;
                })
        .hit;
}

} // namespace hipmap
