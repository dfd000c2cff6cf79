#include "render/integrator/media_beams.h"

namespace hipmap {

std::optional<RayHit> see_media(const MediaBeams& beams, const Ray& ray, bool emits,
                                const SeenThrough& seen)
{
    return walk(beams.media, ray, seen.inside,
                [&](const MediumSegment& segment) {
                    if (emits) {
                        const Medium& medium = beams.media.medium(segment.inside);
                        const OpticalDepth optical_depth =
                            optical_depth_along(beams.media.density(segment.inside), segment.ray);
                        const Rgb emitted = emitted_along(medium, optical_depth.total);
                        const std::array<Rgb, 3> scattered = beam_radiance(
                            beams.photons, {medium, segment.inside, optical_depth}, beams.scales);
                        for (std::size_t i = 0; i < scattered.size(); ++i)
                            seen.radiance[i] += seen.throughput * (emitted + scattered[i]);
                    }
                    seen.throughput *= left_along(beams.media, segment);
                    return true;
                })
        .hit;
}

} // namespace hipmap
