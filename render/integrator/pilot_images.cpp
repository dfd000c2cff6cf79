#include "render/integrator/pilot_images.h"

#include "render/integrator/pass_source.h"

namespace hipmap {

RenderOptions pilot_rows(const RenderOptions& options, const PilotTeam& team)
{
    RenderOptions out = pilot_options(options);
    out.width = (options.width + 1) / 2;
    out.height = (options.height + 1) / 2;
    const Part rows = team.part(static_cast<std::size_t>(out.height));
    out.crop = {0, static_cast<int>(rows.begin), out.width, static_cast<int>(rows.end)};
    return out;
}

double PilotImages::mean() const
{
    return (mean_of(first) + mean_of(second)) / 2 + mean_of(lights);
}

PilotImages render_pilots(const RenderScene& scene, const RenderOptions& options,
                          const PilotTeam& team, const PilotLights& lights,
                          const PilotImage& render)
{
    const RenderOptions rows = pilot_rows(options, team);
    const auto image_of = [&](std::uint64_t number) {
        Image out(rows.width, rows.height);
        out.pixels = joined(team, rows.crop.empty() ? std::vector<Rgb>() : render(rows, number));
        return out;
    };
    PilotImages out;
    out.first = image_of(kPilotPass);
    out.second = image_of(kPilotPass - 1);
    out.lights = measure_light_noise(scene, options, team, lights.rivals);
    if (lights.emissive_points)
        out.emissive = measure_emissive_noise(scene, rows, team);
    return out;
}

} // namespace hipmap
