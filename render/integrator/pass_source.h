#pragma once

#include "render/film/film.h"
#include "render/integrator/render_options.h"

#include <atomic>
#include <functional>

namespace hipmap {

/// The callbacks of a caller while a pass is rendered.
struct PassControl {
    std::function<void(double)> progress;    ///< 0 to 1 of the pass; from any thread; may be empty
    const std::atomic<bool>* stop = nullptr; ///< true: finish the tiles under way and return
};

struct RenderedPass {
    PassImages images;
    bool whole = false; ///< false: stopped; pixels not come to are not kept
};

struct PhotonCache;

/// An integrator, as the loop over passes sees it.
struct PassSource {
    int width = 0; ///< of the images of its passes
    int height = 0;
    ImagePlace place; ///< of these images
    /// The mean of the channels of a pilot image, which is the unit of the film.  It depends on
    /// scene and settings alone, so that states of several runs can be merged.
    double pilot_mean = 0;
    std::uint64_t allocation = 0; ///< checksum of the samples of each pixel; 0: the same of all
    ExpectedLight expected;
    BiasKnowledge bias = BiasKnowledge::unknown;
    bool clamped = false;      ///< passes say what clamping took
    double alpha = 2.0 / 3;    ///< decay of the radii, docs/error.md (1)
    std::uint64_t photons = 0; ///< light paths of a pass, without the aimed ones
    /// Renders pass `pass`: the same images whenever it is called, at any thread count.  Runs on
    /// all threads and is called for one pass at a time.
    std::function<RenderedPass(std::uint64_t pass, const PassControl& control)> render;
    /// Renders pass `pass` of the same faces at other positions; the results of pilots stay.
    std::function<RenderedPass(const RenderScene& scene, std::uint64_t pass,
                               const PassControl& control)>
        render_in;
};

/// The pass number of pilots, which no pass of an image has.
inline constexpr std::uint64_t kPilotPass = ~std::uint64_t{0};

/// Sets the size and the place of the images of a source to the pixels that are rendered.
void set_window(PassSource& source, const RenderOptions& options);

/// Returns options for an image of which only the mean is needed: small, with few photons.
RenderOptions pilot_options(RenderOptions options);

/// Returns the control of the remaining part of a pass; borrows `control`.
PassControl after(const PassControl& control, double begun);

/// Returns the mean of the channels; zero for no pixel.
double mean_of(const Image& image);

} // namespace hipmap
