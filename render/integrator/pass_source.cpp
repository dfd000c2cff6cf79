#include "render/integrator/pass_source.h"

#include <algorithm>

namespace hipmap {

void set_window(PassSource& source, const RenderOptions& options)
{
    const PixelRect pixels = rendered_pixels(options);
    source.width = pixels.width();
    source.height = pixels.height();
    source.place = rendered_place(options);
}

RenderOptions pilot_options(RenderOptions options)
{
    constexpr int kPilotSide = 32;
    constexpr std::uint64_t kPilotShare = 16;
    options.width = std::min(options.width, kPilotSide);
    options.height = std::min(options.height, kPilotSide);
    options.crop = {};
    options.samples = 1;
    options.photons /= kPilotShare;
    options.filter = PixelFilter::box;
    return options;
}

double mean_of(const Image& image)
{
    double sum = 0;
    for (const Rgb& pixel : image.pixels)
        sum += double{pixel.x} + double{pixel.y} + double{pixel.z};
    return sum / (3 * static_cast<double>(std::max<std::size_t>(1, image.pixels.size())));
}

PassControl after(const PassControl& control, double begun)
{
    PassControl rest = control;
    if (control.progress)
        rest.progress = [&control, begun](double part) {
            control.progress(begun + (1 - begun) * part);
        };
    return rest;
}

} // namespace hipmap
