#pragma once

#include "render/film/film.h"

#include <array>

namespace hipmap {

/// The ratio of a whole bias of order 2 to the part that one narrowing of the radius removes,
/// docs/error.md (9); also the ratio of that part to the next narrowing's.
inline constexpr double kSmoothRest = 1 / (1 - kNarrowing * kNarrowing);

/// Inner products of the fields of up to kBatches batches with each other.
class Products {
  public:
    explicit Products(std::size_t size = 0) : size_(size), values_(size * size) {}

    std::size_t size() const { return size_; }
    double& at(std::size_t i, std::size_t j) { return values_[i * size_ + j]; }
    double at(std::size_t i, std::size_t j) const { return values_[i * size_ + j]; }
    /// other: of the same size.
    Products& operator+=(const Products& other)
    {
        for (std::size_t i = 0; i < values_.size(); ++i)
            values_[i] += other.values_[i];
        return *this;
    }

  private:
    std::size_t size_;
    std::vector<double> values_;
};

/// The batches of a film that hold passes, and their number.
struct Batches {
    std::vector<std::uint64_t> batch; ///< [K] ascending
    std::vector<double> passes;       ///< [K]
    double all = 0;                   ///< sum of `passes`
};

/// Statistics of one channel of one pixel.
struct ChannelStatistics {
    double passes = 0;  ///< that kept a sample
    double batches = 0; ///< with such passes
    double mean = 0;
    double variance = 0;    ///< of the mean, docs/error.md (4)
    double weight = 0;      ///< docs/error.md (5)
    double unbiased = 0;    ///< the mean less what bias is plain, docs/error.md (9), and with what
                            ///< clamping took
    double bias_weight = 0; ///< `weight` with `unbiased` in place of the mean
    double steady = 0;      ///< the weight by the pixels around, docs/error.md (5)
    double noise = 0;       ///< sum of squares of `deviation`, weighed by `steady`
    double most_noise = 0;  ///< the same, each weighed by the other batches alone
    /// [K] The difference of a batch's mean from the mean of all, times sqrt(passes).
    std::array<double, kBatches> deviation{};
    /// By narrow batch: mean of radiance minus that of `narrow`; `narrow` minus `narrower`.
    std::array<double, kNarrowBatches> first{}, second{};
    std::array<double, kNarrowBatches> cut{};    ///< by narrow batch: mean of what clamping took
    std::array<double, kNarrowBatches> narrow{}; ///< passes of narrow batches that kept a sample
};

/// Weighted sums over channels and pixels from which the error of an image is estimated.
struct BatchProducts {
    Batches wide;                 ///< of the image
    Batches narrow;               ///< of the images by narrower radii
    double channels = 0;          ///< 3 * pixels; only of those in two batches if a film has parts
    double noise = 0;             ///< sum of ChannelStatistics::noise
    double most_noise = 0;        ///< sum of ChannelStatistics::most_noise
    double fourth = 0;            ///< sum over pixels of fourth cumulants, docs/error.md (7)
    Products deviations;          ///< of ChannelStatistics::deviation
    Products first, both, second; ///< first x first, first x second, second x second
    Products cut;                 ///< cut x cut
};

/// Reads the statistics of the channels of a film.  Borrows it.  Thread-safe.
class ChannelReader {
  public:
    explicit ChannelReader(const Film& film);

    const Batches& wide() const { return wide_; }
    const Batches& narrow() const { return narrow_; }
    /// Returns the statistics of one channel, in W/(m2 sr).  channel: 0 to 2.
    ChannelStatistics read(std::size_t pixel, std::size_t channel) const;

  private:
    double sum(const std::vector<std::int64_t>& sums, std::uint64_t batch, std::size_t pixel,
               std::size_t channel) const;
    double kept_of(std::size_t pixel, std::size_t i) const;
    double without_bias(const ChannelStatistics& biased) const;
    double weight_by_neighbours(const ChannelStatistics& own, std::size_t pixel,
                                std::size_t channel) const;
    double weight_without(const ChannelStatistics& all, double squares, std::size_t i, double sum,
                          double kept) const;
    void add_by_narrow_batch(const std::array<double, kBatches>& kept,
                             std::array<double, kNarrowBatches>& into) const;
    void read_narrow(std::size_t pixel, std::size_t channel, ChannelStatistics& out) const;
    void read_cut(std::size_t pixel, std::size_t channel, ChannelStatistics& out) const;

    const Film& film_;
    KeptPasses kept_;
    Batches wide_, narrow_;
    Image mean_;
    double unit_;
    double dark_ = 0; ///< c of docs/error.md (3)
};

/// Computes the products of all batches in one walk over the film.  Cost: some 100 operations a
/// channel.
BatchProducts batch_products(const Film& film);

} // namespace hipmap
