#pragma once

#include <chrono>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

namespace hipmap {

/// "12.34 s", or "1:02:03" from 100 s on.
std::string format_seconds(double seconds);

/// The line that progress shows: "stage: 20 %, note, 4.00 s left".  done: 0 to 1; none: without
/// share and time left; a NaN counts as nothing done.  elapsed: since the stage began, s.
std::string progress_text(std::string_view stage, std::optional<double> done, std::string_view note,
                          double elapsed);

/// The only printing of both tools, all of it on standard error.  Thread-safe.
class Report {
  public:
    /// A plain line.
    void line(std::string_view text);
    /// "warning: ..."; counted.
    void warn(std::string_view text);
    std::size_t warnings() const { return warnings_; }

    /// Starts a stage of long work that `progress` then reports on.
    void begin(std::string_view stage);
    /// done: 0 to 1; none: not known, and neither is the time left.  note: how things stand, may be
    /// empty.  On a terminal one line that is rewritten, with the time left; elsewhere a plain line
    /// at intervals.  Cheap enough to call often.
    void progress(std::optional<double> done, std::string_view note = {});
    /// Ends the stage with a line that gives its time.  Returns the seconds it took.
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
