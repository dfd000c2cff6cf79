#pragma once

#include "common/stopwatch.h"
#include "render/film/render_state.h"
#include "render/integrator/coarse_image.h"
#include "render/layers/layer.h"
#include "render/options.h"

#include <functional>

namespace hipmap {

/// Decides when files are rewritten, so that writing takes a small share of the time.
class WritingPace {
  public:
    /// Calls `write` unless that would take more than its share of the time.  Returns whether it
    /// did.
    bool write(const std::function<void()>& write);

  private:
    const Stopwatch watch_{};
    double written_ = 0; ///< s, when the files were written
    double writing_ = 0; ///< s that writing them took
};

/// Writes the images of a render before it is done: a coarse one first, then after passes, so that
/// whole images are there if the render is killed.  The images of --output, the pictures and the
/// layers are each written at a pace of their own: large layers do not delay the image.
class LiveImages {
  public:
    /// Returns the layers of first surfaces that were requested.
    using Surfaces = std::function<const std::vector<LayerImage>&()>;

    /// arguments: borrowed, of one frame.  surfaces: called if layers are requested.
    LiveImages(const RenderArguments& arguments, Surfaces surfaces)
        : arguments_(arguments), surfaces_(std::move(surfaces))
    {
    }

    /// Writes the images by the passes so far, each whole or not at all, unless writing takes more
    /// than a small share of the time.  Pictures follow once what they show is known.  An
    /// automatic exposure stays while the new one is near, so that viewers do not flicker.
    /// Returns what was written; the state stays as it is.  Throws InputError if a file cannot be
    /// written.
    std::vector<std::filesystem::path> rewrite(RenderState& state);

    /// Writes the images by the coarse one, unless the first pass will be there soon.  Returns what
    /// was written.  Throws as rewrite.
    std::vector<std::filesystem::path> show(const CoarseImage& coarse);

  private:
    void write_images(const Image& image, const RenderState& state);
    float exposure_of(const Image& image);

    const RenderArguments& arguments_;
    const Surfaces surfaces_;
    WritingPace images_, pictures_, layers_;
    std::optional<float> exposure_ev_; ///< last used; none: not written yet
};

} // namespace hipmap
