#pragma once

#include "common/image/image.h"
#include "render/integrator/eye_path.h"
#include "render/photons/trace_photons.h"

#include <atomic>
#include <functional>

namespace hipmap {

/// How the light along an eye ray is found.
enum class Integrator : std::uint8_t {
    direct, ///< from the photon maps at the first diffuse surface
    path,   ///< by path tracing, without photons
};

struct RenderOptions {
    Integrator integrator = Integrator::direct;
    int width = 0;
    int height = 0;
    MapOptions maps;
    DirectLight direct = DirectLight::shadow_rays;
    std::uint64_t photons = 0; ///< light paths per pass
    std::uint32_t passes = 1;
    std::uint32_t samples = 1; ///< eye paths per pixel and pass
    std::uint64_t seed = 0;
};

/// Of one kind of photon, summed over the passes.
struct KindStatistics {
    std::uint64_t stored = 0;
    std::uint64_t shared_maps = 0;   ///< maps of the first tier that hold photons, of the last pass
    std::uint64_t local_maps = 0;    ///< of the last pass
    std::uint64_t group_maps = 0;    ///< of the last pass
    TierPlan local_plan, group_plan; ///< of the last pass, mode hierarchical
    SearchStatistics searches;
};

struct RenderStatistics {
    std::uint32_t passes = 0;          ///< done
    std::uint64_t emitted = 0;         ///< light paths
    std::uint64_t aimed = 0;           ///< light paths besides, aimed at specular surfaces
    std::uint64_t dropped_photons = 0; ///< not finite
    std::uint64_t dropped_samples = 0; ///< not finite
    std::uint64_t cut_paths = 0;
    KindStatistics caustic;
    KindStatistics global;
    PowerBalance power; ///< of the last pass
    double seconds_photons = 0;
    double seconds_maps = 0;
    double seconds_image = 0;
};

struct RenderedImage {
    Image image; ///< radiance, W/(m2 sr)
    RenderStatistics statistics;
    bool stopped = false; ///< by the caller, before the last pass was done
};

/// What the caller hears and says while an image is made.
struct RenderControl {
    std::function<void(double)> progress;    ///< 0 to 1; from any thread
    const std::atomic<bool>* stop = nullptr; ///< true: finish the tiles under way and return
};

/// Renders from the scene's camera: the average of `passes` independent passes, each with photons
/// and maps of its own.  Same scene and options, same image at any thread count. When stopped, what
/// has been averaged are the whole passes so far; stopped in the first, the pixels done.  Cost:
/// passes * (photons + pixels * samples).
RenderedImage render_image(const RenderScene& scene, const RenderOptions& options,
                           const RenderControl& control);

} // namespace hipmap
