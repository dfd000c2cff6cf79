#pragma once

#include "render/integrator/pilot_noise.h"
#include "render/integrator/render_options.h"

#include <functional>

namespace hipmap {

/// Returns options of the images that pilots of a team render: half the size, one sample a pixel,
/// few photons, and the rows of this process.
RenderOptions pilot_rows(const RenderOptions& options, const PilotTeam& team);

/// Renders the pixels that pilot_rows names, without the seen lights, [rows][width].  Called for
/// two numbers, and not at all where a process has no row.
using PilotImage = std::function<std::vector<Rgb>(const RenderOptions& rows, std::uint64_t number)>;

/// What is measured of the lights.
struct PilotLights {
    GlossyRivals rivals = {};
    bool emissive_points = false; ///< samples may have several, docs/error.md (26)
};

/// What pilots found, docs/error.md (14), (16).
struct PilotImages {
    Image first, second; ///< of half the size, without the seen lights
    LightNoise lights;
    Image emissive; ///< by measure_emissive_noise, or empty

    PilotNoise noise() const { return {first, second, lights, &emissive}; }
    double mean() const; ///< of the channels of the image
};

/// Renders the two images of a pilot, and measures the seen lights.  Same scene, same options, same
/// images, in a team of any size.  Cost: half a sample a pixel, and that of measure_light_noise.
PilotImages render_pilots(const RenderScene& scene, const RenderOptions& options,
                          const PilotTeam& team, const PilotLights& lights,
                          const PilotImage& render);

} // namespace hipmap
