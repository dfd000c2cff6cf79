#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

namespace hipmap {

/// Formats a time: "12.34 s", or "1:02:03" from 100 s on.
std::string format_seconds(double seconds);

/// Formats a time with two digits or so: "3.4 s", "63 s", "6 min", "2.5 h", "3 days".
std::string brief_time(double seconds);

/// Formats a whole number with commas: "1,234,567".
std::string grouped(std::uint64_t number);

/// Returns the progress line: "stage: 20 %, note, 4 s left".  done: 0 to 1; none: unknown; NaN
/// counts as 0.  left: s; none: unknown.
std::string progress_text(std::string_view stage, std::optional<double> done, std::string_view note,
                          std::optional<double> left);

/// Prints all text of both tools, on standard error.  Thread-safe.
class Report {
  public:
    /// verbose: print details too.
    explicit Report(bool verbose = false) : verbose_(verbose) {}
    bool verbose() const { return verbose_; }

    /// Prints a plain line.
    void line(std::string_view text);
    /// Prints a plain line if this report is verbose.
    void detail(std::string_view text);
    /// Remembers a file that was written, for one line of all of them; note: said in brackets.
    void wrote(const std::filesystem::path& file, const std::string& note = {});
    /// Returns the files written since the last call: "a.png (exposure +1 EV), a.exr"; empty: none.
    std::string take_files();
    /// Prints one line of the files written, if there are any.
    void list_files();
    /// Prints "warning: ..." and counts it.
    void warn(std::string_view text);
    std::size_t warnings() const { return warnings_; }

    /// Starts a stage of long work that `progress` reports on.
    void begin(std::string_view stage);
    /// Updates the progress of the current stage.  done: 0 to 1; none: unknown.  note: the current
    /// state, may be empty.  left: s; none: as follows from `done` and the time so far.  On a
    /// terminal one line is rewritten; elsewhere plain lines are printed at intervals.  Cheap
    /// enough to call often.
    void progress(std::optional<double> done, std::string_view note = {},
                  std::optional<double> left = {});
    /// Ends the stage and prints its time.  Returns the seconds it took.
    double end();
    /// Ends the stage; prints its time if this report is verbose.
    void end_quietly();

  private:
    using Clock = std::chrono::steady_clock;
    std::mutex mutex_;
    std::string stage_;
    Clock::time_point begun_;
    Clock::time_point shown_;
    const bool verbose_;
    std::string files_;
    std::size_t warnings_ = 0;
    bool line_open_ = false;
};

} // namespace hipmap
