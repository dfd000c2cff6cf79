#pragma once

#include "common/stopwatch.h"
#include "render/options.h"

namespace hipmap {

/// Rewrites the images of a render after passes, so that a whole picture is there if the render is
/// killed.
class LiveImages {
  public:
    /// files: borrowed; only its images are rewritten, those in .exr files without layers.
    explicit LiveImages(const OutputFiles& files) : files_(files) {}

    /// Writes all images by the passes so far, each whole or not at all, unless writing takes more
    /// than a small share of the time.  An automatic exposure stays while the new one is near, so
    /// that viewers do not flicker.  Returns what was written.  Throws InputError if a file cannot
    /// be written.
    std::vector<std::filesystem::path> rewrite(const Film& film);

  private:
    float exposure_of(const Image& image);

    const OutputFiles& files_;
    const Stopwatch watch_;
    double written_ = 0;               ///< s, when the images were written
    double writing_ = 0;               ///< s that writing them took
    std::optional<float> exposure_ev_; ///< last used; none: not written yet
};

} // namespace hipmap
