#pragma once

#include "common/stopwatch.h"
#include "render/integrator/run_passes.h"
#include "render/options.h"

#include <nlohmann/json.hpp>

#include <mutex>
#include <ostream>

namespace hipmap {

/// Prints the progress of a render as lines of JSON for a program that shows it
/// (docs/progress.md).  Thread-safe.
class ProgressLines {
  public:
    /// to: borrowed; each line is flushed.  arguments: of one frame.
    ProgressLines(std::ostream& to, const RenderArguments& arguments);

    /// Prints how far the pass is, ten times a second at most.
    void progress(const RunProgress& progress);
    /// Prints that a coarse image was written before the first pass.
    void coarse(const std::vector<std::filesystem::path>& written);
    /// Prints the end of a pass.  rewritten: images that it rewrote.
    void pass(const RenderState& state, const std::vector<std::filesystem::path>& rewritten);
    /// Prints the end, when all files are written.
    void end(const RunResult& result, const RenderState& state);

  private:
    void print(nlohmann::json line);

    std::ostream& to_;
    const RenderArguments& arguments_;
    std::mutex mutex_;
    const Stopwatch watch_;
    double shown_ = 0; ///< s, when progress was printed
};

} // namespace hipmap
