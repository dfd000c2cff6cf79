#pragma once

#include "common/image/pixel_rect.h"
#include "render/integrator/eye_path.h"
#include "render/integrator/pixel_filter.h"
#include "render/photons/trace_photons.h"
#include "render/photons/unseen_light.h"

namespace hipmap {

/// How the light along an eye ray is found.
enum class Integrator : std::uint8_t {
    direct,      ///< from the photon maps at the first diffuse surface
    path,        ///< by path tracing, without photons
    occlusion,   ///< not at all: ambient occlusion
    progressive, ///< from photon maps and a gather ray, by radii that shrink from pass to pass
};

/// Where light paths start.
enum class Emission : std::uint8_t {
    guided,   ///< as photon_guides.h says
    by_power, ///< by the power of the lights alone
};

/// How the directions of final-gather rays are drawn.
enum class GatherDirections : std::uint8_t {
    guided,   ///< as placed_guides.h says
    by_lobes, ///< by the lobes of the surface alone
};

/// Whether final-gather rays serve other pixels too.
enum class GatherSharing : std::uint8_t {
    none,
    neighbours, ///< as shared_gathers.h says
};

/// How light is found that several surfaces that gather have sent on.
enum class IndirectLight : std::uint8_t {
    automatic, ///< as indirect_choice.h says
    photons,   ///< final-gather rays end in photon maps
    paths,     ///< they go on as paths; only caustics are photons
};

/// The options of a pass, the same for all passes of an image.
struct RenderOptions {
    Integrator integrator = Integrator::progressive;
    int width = 0; ///< of the whole image
    int height = 0;
    PixelRect crop = {}; ///< the pixels of it to render; empty: all
    MapOptions maps;
    DissertationOptions dissertation;
    DirectLight direct = DirectLight::shadow_rays;
    Emission emission = Emission::guided;
    GatherDirections gather = GatherDirections::guided;
    GatherSharing sharing = GatherSharing::neighbours;
    IndirectLight indirect = IndirectLight::photons;
    std::uint64_t photons = 0; ///< light paths per pass
    std::uint32_t samples = 1; ///< eye paths per pixel and pass
    std::uint64_t seed = 0;
    LightClasses light;            ///< that is found at all
    double alpha = 2.0 / 3;        ///< decay of the radii, docs/error.md (1); progressive
    double occlusion_distance = 0; ///< m; 0: kOcclusionReach of the scene; occlusion
    PixelFilter filter = PixelFilter::b_spline;
    float clamp = 0; ///< largest channel of a sample, W/(m2 sr), but for directly visible lights;
                     ///< 0: not clamped
};

/// Returns the pixels of the whole image that are rendered.
inline PixelRect rendered_pixels(const RenderOptions& options)
{
    return options.crop.empty() ? PixelRect{0, 0, options.width, options.height} : options.crop;
}

/// Returns the place of these pixels in the whole image.
inline ImagePlace rendered_place(const RenderOptions& options)
{
    if (options.crop.empty())
        return {};
    return {options.crop.x0, options.crop.y0, options.width, options.height};
}

/// Statistics of one kind of photon, summed over the passes.
struct KindStatistics {
    std::uint64_t stored = 0;
    std::uint64_t shared_maps = 0; ///< shared maps that hold photons, of the last pass
    std::uint64_t largest_map = 0; ///< photons of the largest shared map, last pass
    SearchStatistics searches;
    LevelCounts levels; ///< of the last pass
    LevelStatistics level_searches;

    /// Adds what a thread's searches did.
    void add_searches(const ChosenScratch& scratch)
    {
        searches += scratch.estimate.search.statistics;
        level_searches += hipmap::level_searches(scratch);
    }
};

/// Statistics of the passes of one run.
struct RenderStatistics {
    std::uint64_t passes = 0;         ///< whole ones
    std::uint64_t emitted = 0;        ///< light paths
    std::uint64_t aimed = 0;          ///< light paths besides, aimed at specular surfaces
    double guided_variance = 1;       ///< of EmissionGuide, for the paths not aimed
    double guided_variance_aimed = 1; ///< for the others
    IndirectLight indirect_by = IndirectLight::photons; ///< integrator progressive
    std::uint64_t dropped_photons = 0;                  ///< not finite
    std::uint64_t dropped_samples = 0;                  ///< not finite
    std::uint64_t cut_paths = 0;
    KindStatistics caustic;
    KindStatistics global;
    KindStatistics indirect; ///< integrator progressive: the global ones that came by a bounce
    KindStatistics glossy;   ///< integrator progressive: caustic ones on glossy surfaces
    std::uint64_t volume_photons = 0; ///< in media, summed over the passes
    PowerBalance power;               ///< of the last pass
    SeenScale seen_scale;             ///< integrator progressive
    SeenClasses seen;                 ///< of the passes that traced photons of their own
    double seconds_photons = 0;
    double seconds_maps = 0;
    double seconds_image = 0;
    double processor_photons = 0; ///< seconds of the processor, of all threads together
    double processor_maps = 0;
    double processor_image = 0;
};

} // namespace hipmap
