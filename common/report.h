#pragma once

#include <chrono>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

namespace hipmap {

/// Formats a time: "12.34 s", or "1:02:03" from 100 s on.
std::string format_seconds(double seconds);

/// Returns the progress line: "stage: 20 %, note, 4.00 s left".  done: 0 to 1; none: without share
/// and time left; NaN counts as 0.  elapsed: seconds since the stage began.
std::string progress_text(std::string_view stage, std::optional<double> done, std::string_view note,
                          double elapsed);

/// Prints all text of both tools, on standard error.  Thread-safe.
class Report {
  public:
    /// Prints a plain line.
    void line(std::string_view text);
    /// Prints "warning: ..." and counts it.
    void warn(std::string_view text);
    std::size_t warnings() const { return warnings_; }

    /// Starts a stage of long work that `progress` reports on.
    void begin(std::string_view stage);
    /// Updates the progress of the current stage.  done: 0 to 1; none: unknown, and so is the time
    /// left.  note: the current state, may be empty.  On a terminal one line is rewritten;
    /// elsewhere plain lines are printed at intervals.  Cheap enough to call often.
    void progress(std::optional<double> done, std::string_view note = {});
    /// Ends the stage and prints its time.  Returns the seconds it took.
    double end();

  private:
    using Clock = std::chrono::steady_clock;
    std::mutex mutex_;
    std::string stage_;
    Clock::time_point begun_;
    Clock::time_point shown_;
    std::size_t warnings_ = 0;
    bool line_open_ = false;
};

} // namespace hipmap
