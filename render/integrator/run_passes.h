#pragma once

#include "common/stopwatch.h"
#include "render/film/render_state.h"
#include "render/integrator/pass_source.h"

#include <limits>

namespace hipmap {

/// The rules that end a render; the first one reached applies.
struct StopRules {
    std::uint64_t first_pass = 0;       ///< passes are taken from here on
    std::uint64_t passes = kMostPasses; ///< in the film, over all runs
    double seconds =
        std::numeric_limits<double>::infinity(); ///< of this run; a pass is done anyhow
    double error = 0;                            ///< 0.05: 5 %; looked at after next_check() passes
    FireflyChoice fireflies = FireflyChoice::remove; ///< in the image whose error that is
    double quoted_error = 0; ///< stop once the time to this error is known well enough; 0: do not
};

/// The share of the predicted time to an error that passes may take which only make the prediction
/// better.
inline constexpr double kQuotePassShare = 0.02;

/// Returns whether the passes of a state are enough to predict the time to `error`, for what more
/// of them would cost: never fewer than two, nor more than kBatches.
bool predicts_enough(const RenderState& state, double error);

enum class StopReason : std::uint8_t { passes, time, error, caller };

/// How far a render is.
struct RunProgress {
    /// The share of this run's work that is done, 0 to 1, by the rule that ends it first; none:
    /// unknown until the error was estimated twice.
    std::optional<double> done;
    std::optional<double> left; ///< s until then; none: unknown
    std::uint64_t passes = 0;
    std::optional<ImageError> error; ///< when last looked at
};

/// The callbacks of a caller while an image is rendered.
struct RunControl {
    std::function<void(const RunProgress&)> progress; ///< from any thread; may be empty
    const std::atomic<bool>* stop = nullptr; ///< true: finish the tiles under way and return
    /// Saves the state.  Called between passes, often enough that little is lost and rarely enough
    /// to cost little time; not at the end.  May be empty.
    std::function<void(const RenderState&)> save;
    /// Called after each pass that was added, with the state, which it leaves as it was.  May be
    /// empty.
    std::function<void(RenderState&)> pass;
};

/// What a run took besides rendering passes.
struct RunCosts {
    Spent film;               ///< adding passes to the film, and estimating the error
    Spent previews;           ///< RunControl::pass: rewriting images during the run
    Spent state;              ///< writing states
    Spent wait;               ///< for the slowest process, at the ends of rounds
    Spent add;                ///< adding up the films of processes, at the ends of rounds
    std::uint64_t rounds = 0; ///< of several processes
};

struct RunResult {
    StopReason reason = StopReason::passes;
    /// Mean of the whole passes, radiance, W/(m2 sr); stopped in the first, the pixels done.
    Image image;
    std::vector<std::uint8_t> kept; ///< [pixels] stopped in the first pass, those done; else empty
    RunCosts costs;                 ///< without those of `save` and `pass`
};

/// Sets the image to the mean of the passes; without a pass to the pixels of the one that was
/// stopped, if one was begun.
void set_image(const RenderState& state, PassImages unfinished, RunResult& result);

/// Makes a state without passes, for a new render.
RenderState begin_state(const PassSource& source, std::vector<Setting> settings);

/// Resumes a state read from `path`, whose settings and pixels are those of the render.  Takes over
/// its film, so that memory holds one.  Throws InputError, naming `path`, if begin_state would make
/// another kind of film.
RenderState resume_state(const PassSource& source, RenderState found,
                         const std::filesystem::path& path);

/// Adds passes to the state in order of their number, skipping those it holds, until a rule or the
/// caller stops it.  One run or many reach the same state.  The last estimate of the error, at
/// whatever number of passes, is at the end of `checks`; the others are at the passes of next_look.
RunResult run_passes(const PassSource& source, const StopRules& rules, const RunControl& control,
                     RenderState& state);

} // namespace hipmap
