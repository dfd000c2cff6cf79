#include "render/lights/primary_density.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hipmap {

namespace {

constexpr std::uint32_t kDimensions = 2 * kPrimarySteps;
constexpr std::size_t kBins = 8; ///< that a cell is looked at in, along each dimension
constexpr int kMostDepth = 48;

/// Points that matter, alike to so many of equal worth, before a cell is halved: few are enough
/// where they lie close together, as in the beam through a window.
constexpr double kFewestAlike = 4;

/// Noise alone makes a cell of n such points look uneven by some 1 / n.
constexpr double kNoise = 2;
constexpr double kLeastGain = 0.01;

/// Shares of halves are multiples of this and none is below 16 of it: random numbers have 24 bits.
constexpr double kShareUnit = 0x1p-16;

float coordinate(const PrimarySample& at, std::uint32_t dimension)
{
    return at[dimension / 2][static_cast<int>(dimension % 2)];
}

/// A box of the cube.
struct Cell {
    std::array<float, kDimensions> low{}, size{};
    double volume = 1;
    int depth = 0;

    Cell() { size.fill(1.0f); }

    float middle(std::uint32_t dimension) const { return low[dimension] + size[dimension] / 2; }

    Cell half(std::uint32_t dimension, bool upper) const
    {
        Cell out = *this;
        out.size[dimension] /= 2;
        if (upper)
            out.low[dimension] += out.size[dimension];
        out.volume /= 2;
        ++out.depth;
        return out;
    }
};

struct Sums {
    double second = 0, square = 0;

    /// Points of equal worth that would be as even.
    double alike() const { return square > 0 ? second * second / square : 0; }
};

/// What a point adds to the mean square of a power of worth.
double second_of(const PrimaryWorth& point, double power)
{
    return point.worth > 0 ? std::pow(point.worth, 2 * power) / point.density : 0;
}

Sums sum_up(std::span<const PrimaryWorth> points, double power)
{
    Sums out;
    for (const PrimaryWorth& point : points) {
        const double second = second_of(point, power);
        out.second += second;
        out.square += second * second;
    }
    return out;
}

/// Of worth, of which the first that leaves enough points that matter is learnt.
constexpr double kPowers[] = {1, 0.75, 0.5, 0.35, 0.25};

float rounded_share(double share)
{
    const double least = 16 * kShareUnit;
    return static_cast<float>(std::round(std::clamp(share, least, 1 - least) / kShareUnit) *
                              kShareUnit);
}

class Learner {
  public:
    explicit Learner(double power) : power_(power) {}

    LearntDensity learn(std::span<PrimaryWorth> points)
    {
        const Sums all = sum_up(points, power_);
        if (!(all.second > 0))
            return {};
        out_.density.nodes.emplace_back();
        out_.node_share.push_back(0);
        grow(0, Cell(), points, all.second);
        for (const double whole = out_.node_share.front(); double& share : out_.node_share)
            share /= whole;
        return std::move(out_);
    }

  private:
    /// Grows the tree below a node; second: of its points, and a prior for what they did not show.
    void grow(std::uint32_t node, const Cell& cell, std::span<PrimaryWorth> points, double second)
    {
        out_.node_share[node] = std::sqrt(second * cell.volume);
        const Sums sums = sum_up(points, power_);
        const bool enough = sums.alike() >= kFewestAlike && cell.depth < kMostDepth;
        const std::uint32_t dimension = enough ? most_uneven(cell, points, sums) : kDimensions;
        if (dimension == kDimensions) {
            out_.worth += std::sqrt(sum_up(points, 1).second * cell.volume);
            return;
        }
        const float middle = cell.middle(dimension);
        const auto upper = std::partition(points.begin(), points.end(), [&](const auto& point) {
            return coordinate(point.at, dimension) < middle;
        });
        const auto lower_count = static_cast<std::size_t>(upper - points.begin());
        const auto below = points.first(lower_count), above = points.subspan(lower_count);
        // As if one more point had shown each half.
        const double prior = second / (2 * sums.alike() + 2);
        const double kept = 1 - 2 * prior / second, shown = sums.second;
        const auto second_in = [&](std::span<PrimaryWorth> part) {
            return prior + second * kept * (sum_up(part, power_).second / shown);
        };
        const auto lower = static_cast<std::uint32_t>(out_.density.nodes.size());
        out_.density.nodes.resize(lower + 2);
        out_.node_share.resize(lower + 2);
        grow(lower, cell.half(dimension, false), below, second_in(below));
        grow(lower + 1, cell.half(dimension, true), above, second_in(above));
        const double sum = out_.node_share[lower] + out_.node_share[lower + 1];
        out_.node_share[node] = sum;
        out_.density.nodes[node] = {lower, dimension, rounded_share(out_.node_share[lower] / sum)};
    }

    /// The dimension along which bins differ most; kDimensions: by no more than noise in any.
    std::uint32_t most_uneven(const Cell& cell, std::span<const PrimaryWorth> points,
                              const Sums& sums) const
    {
        std::array<std::array<double, kBins>, kDimensions> bins{};
        for (const PrimaryWorth& point : points) {
            const double second = second_of(point, power_);
            for (std::uint32_t d = 0; d < kDimensions; ++d) {
                const float place = (coordinate(point.at, d) - cell.low[d]) / cell.size[d];
                const auto bin = static_cast<int>(place * static_cast<float>(kBins));
                bins[d][static_cast<std::size_t>(std::clamp(bin, 0, int{kBins} - 1))] += second;
            }
        }
        double least = 1 - kLeastGain - kNoise / sums.alike();
        std::uint32_t out = kDimensions;
        for (std::uint32_t d = 0; d < kDimensions; ++d) {
            double worth = 0;
            for (const double in_bin : bins[d])
                worth += std::sqrt(in_bin / (kBins * sums.second));
            if (worth < least) {
                least = worth;
                out = d;
            }
        }
        return out;
    }

    const double power_;
    LearntDensity out_;
};

} // namespace

DrawnPrimary draw(const PrimaryDensity& density, const PrimarySample& even)
{
    DrawnPrimary out{even, 1.0f};
    if (density.nodes.empty())
        return out;
    std::array<float, kDimensions> low{}, size;
    size.fill(1.0f);
    const auto at = [&](std::uint32_t d) -> float& {
        return out.at[d / 2][static_cast<int>(d % 2)];
    };
    const PrimaryDensity::Node* node = &density.nodes.front();
    while (node->lower != 0) {
        const std::uint32_t d = node->dimension;
        float& u = at(d);
        size[d] /= 2;
        const bool upper = !(u < node->lower_share);
        const float share = upper ? 1 - node->lower_share : node->lower_share;
        u = std::min((upper ? u - node->lower_share : u) / share, 0x1.fffffep-1f);
        low[d] += upper ? size[d] : 0;
        out.density *= 2 * share;
        node = &density.nodes[node->lower + (upper ? 1 : 0)];
    }
    for (std::uint32_t d = 0; d < kDimensions; ++d)
        at(d) = std::min(low[d] + size[d] * at(d), 0x1.fffffep-1f);
    return out;
}

double density_at(const PrimaryDensity& density, const PrimarySample& at)
{
    double out = 1;
    if (density.nodes.empty())
        return out;
    Cell cell;
    const PrimaryDensity::Node* node = &density.nodes.front();
    while (node->lower != 0) {
        const bool upper = !(coordinate(at, node->dimension) < cell.middle(node->dimension));
        out *= 2 * double{upper ? 1 - node->lower_share : node->lower_share};
        cell = cell.half(node->dimension, upper);
        node = &density.nodes[node->lower + (upper ? 1 : 0)];
    }
    return out;
}

LearntDensity learn_density(std::span<PrimaryWorth> points, double alike)
{
    const auto power = std::ranges::find_if(
        kPowers, [&](double each) { return sum_up(points, each).alike() >= alike; });
    return Learner(power == std::end(kPowers) ? *std::rbegin(kPowers) : *power).learn(points);
}

PrimaryDensity mixed_with_even(const LearntDensity& learnt, double even)
{
    PrimaryDensity out = learnt.density;
    std::vector<double> volume(out.nodes.size(), 1.0);
    const auto mass = [&](std::size_t node) {
        return even * volume[node] + (1 - even) * learnt.node_share[node];
    };
    for (std::size_t i = 0; i < out.nodes.size(); ++i) { // a node comes before its halves
        PrimaryDensity::Node& node = out.nodes[i];
        if (node.lower == 0)
            continue;
        volume[node.lower] = volume[node.lower + 1] = volume[i] / 2;
        node.lower_share = rounded_share(mass(node.lower) / mass(i));
    }
    return out;
}

} // namespace hipmap
