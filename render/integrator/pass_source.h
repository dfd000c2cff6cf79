#pragma once

#include "render/film/film.h"
#include "render/integrator/render_options.h"

#include <atomic>
#include <functional>

namespace hipmap {

/// What the caller hears and says while a pass is made.
struct PassControl {
    std::function<void(double)> progress;    ///< 0 to 1 of the pass; from any thread; may be empty
    const std::atomic<bool>* stop = nullptr; ///< true: finish the tiles under way and return
};

struct RenderedPass {
    PassImages images;
    bool whole = false; ///< false: stopped; pixels not come to are not kept
};

/// An integrator, as the loop over passes sees it.
struct PassSource {
    int width = 0;
    int height = 0;
    /// Mean of the channels of an image by the pilot: the unit of the film.  A function of scene
    /// and settings alone, or states of several runs could not be merged.
    double pilot_mean = 0;
    std::uint64_t allocation = 0; ///< checksum of the samples of each pixel; 0: the same of all
    BiasKnowledge bias = BiasKnowledge::unknown;
    double alpha = 2.0 / 3;    ///< how slowly radii shrink, docs/error.md (1)
    std::uint64_t photons = 0; ///< light paths of a pass
    /// Makes pass `pass`: the same images whenever it is asked for, at any thread count.  Runs on
    /// all threads by itself and is called for one pass at a time.
    std::function<RenderedPass(std::uint64_t pass, const PassControl& control)> render;
    /// The same of the same faces at another place; what pilots have found stays.
    std::function<RenderedPass(const RenderScene& scene, std::uint64_t pass,
                               const PassControl& control)>
        render_in;
};

/// The number of the pass that pilots are made with; none of an image.
inline constexpr std::uint64_t kPilotPass = ~std::uint64_t{0};

/// For an image from which only its mean is taken: small, by few photons.
RenderOptions pilot_options(RenderOptions options);

/// The control of what is left of a pass; borrows `control`.
PassControl after(const PassControl& control, double begun);

/// Mean of the channels; zero of no pixel.
double mean_of(const Image& image);

struct PhotonCache;

/// The integrator that the options name.  Adds what passes do to `statistics`.  cache: of previous
/// images of the scene, used and filled by integrator progressive; may be null.  Everything is
/// borrowed, and must outlive the source.  Renders the pilot.
PassSource make_pass_source(const RenderScene& scene, const RenderOptions& options,
                            RenderStatistics& statistics, PhotonCache* cache = nullptr);

} // namespace hipmap
