#include "render/integrator/render_image.h"

namespace hipmap {

RenderedImage render_image(const RenderScene& scene, const RenderOptions& options,
                           const RenderControl& control)
{
    RenderedImage out;
    std::uint32_t& passes = out.statistics.passes;
    const PassSource source = make_pass_source(scene, options, out.statistics);
    Film film = make_film(source.width, source.height, source.pilot_mean, source.bias);
    while (passes < options.passes && !out.stopped) {
        PassControl pass;
        pass.stop = control.stop;
        pass.progress = [&](double part) {
            if (control.progress)
                control.progress((passes + part) / options.passes);
        };
        const RenderedPass rendered = source.render(passes, pass);
        out.stopped = !rendered.whole;
        if (out.stopped && passes == 0)
            out.image = rendered.images.radiance;
        if (!out.stopped)
            add_pass(film, passes++, rendered.images);
    }
    if (passes > 0)
        out.image = film_image(film);
    return out;
}

} // namespace hipmap
