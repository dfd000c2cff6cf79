#pragma once

#include <chrono>
#include <ctime>

namespace hipmap {

/// Measures the time since its construction.
class Stopwatch {
  public:
    /// Returns the wall-clock time, in seconds.
    double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
    /// Returns the processor time of all threads of this process together, in seconds.
    double processor_seconds() const
    {
        return static_cast<double>(std::clock() - processor_start_) / CLOCKS_PER_SEC;
    }
    /// Returns the processor time of all threads since this process began, in seconds.
    static double processor_seconds_of_process()
    {
        return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
    }

  private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point start_ = Clock::now();
    std::clock_t processor_start_ = std::clock();
};

/// What a stage took, in seconds.
struct Spent {
    double seconds = 0;   ///< wall-clock time
    double processor = 0; ///< of all threads of this process together

    /// Adds the time since the construction of `watch`.
    void add(const Stopwatch& watch)
    {
        seconds += watch.seconds();
        processor += watch.processor_seconds();
    }
};

} // namespace hipmap
