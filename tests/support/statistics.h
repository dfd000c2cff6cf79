#pragma once

#include <cmath>
#include <cstddef>

namespace hipmap {

/// Mean and standard error of independent estimates, one at a time (Welford 1962).
class RunningMean {
  public:
    void add(double value)
    {
        ++count_;
        const double off = value - mean_;
        mean_ += off / static_cast<double>(count_);
        squares_ += off * (value - mean_);
    }
    std::size_t count() const { return count_; }
    double mean() const { return mean_; }
    double standard_error() const
    {
        const auto n = static_cast<double>(count_);
        return std::sqrt(squares_ / (n * (n - 1)));
    }
    /// Standard errors between the mean and the truth.
    double z_score(double truth) const { return (mean_ - truth) / standard_error(); }

  private:
    std::size_t count_ = 0;
    double mean_ = 0;
    double squares_ = 0;
};

/// |z| beyond this has a probability below 1e-5 for a right estimator: with fixed seeds it never
/// fails by itself, and a bias of a few standard errors shows.
inline constexpr double kMostZ = 4.5;

} // namespace hipmap
