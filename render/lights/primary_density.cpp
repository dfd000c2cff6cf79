#include "render/lights/primary_density.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hipmap {

namespace {

/// A cell this dense is not halved further.  Powers are stored as parts of the largest in 16 bits
/// (packed by photon_powers.h), so those of far denser paths would be rounded coarsely.
constexpr double kMostDensity = 256;

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

    void halve(std::uint32_t dimension, bool upper)
    {
        size[dimension] /= 2;
        if (upper)
            low[dimension] += size[dimension];
        volume /= 2;
        ++depth;
    }
};

struct Sums {
    double second = 0, square = 0;

    /// Points of equal worth that would be as even.
    double alike() const { return square > 0 ? second * second / square : 0; }
};

/// A point, and what it adds to the mean square of worth and of a power of worth.
struct Point {
    PrimarySample at;
    double second = 0, second_of_power = 0;
};

Sums sum_up(std::span<const Point> points)
{
    Sums out;
    for (const Point& point : points) {
        out.second += point.second_of_power;
        out.square += point.second_of_power * point.second_of_power;
    }
    return out;
}

double second_of(const PrimaryWorth& point, double power)
{
    return point.worth > 0 ? std::pow(point.worth, 2 * power) / point.density : 0;
}

std::vector<Point> by_power(std::span<const PrimaryWorth> points, double power)
{
    std::vector<Point> out;
    out.reserve(points.size());
    for (const PrimaryWorth& point : points)
        out.push_back({point.at, second_of(point, 1), second_of(point, power)});
    return out;
}

/// Exponents of worth, from the one that is learnt where enough points matter by it to the last
/// resort.
constexpr double kPowers[] = {1, 0.75, 0.5, 0.35, 0.25};

float rounded_share(double share)
{
    const double least = 16 * kShareUnit;
    return static_cast<float>(std::round(std::clamp(share, least, 1 - least) / kShareUnit) *
                              kShareUnit);
}

class Learner {
  public:
    LearntDensity learn(std::span<Point> points)
    {
        const Sums all = sum_up(points);
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
    void grow(std::uint32_t node, const Cell& cell, std::span<Point> points, double second)
    {
        out_.node_share[node] = std::sqrt(second * cell.volume);
        const Sums sums = sum_up(points);
        const bool enough = sums.alike() >= kFewestAlike && cell.depth < kMostDepth;
        const std::uint32_t dimension = enough ? most_uneven(cell, points, sums) : kDimensions;
        if (dimension == kDimensions) {
            double plain = 0;
            for (const Point& point : points)
                plain += point.second;
            out_.worth += std::sqrt(plain * cell.volume);
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
        const auto second_in = [&](std::span<const Point> part) {
            return prior + second * kept * (sum_up(part).second / shown);
        };
        const auto lower = static_cast<std::uint32_t>(out_.density.nodes.size());
        out_.density.nodes.resize(lower + 2);
        out_.node_share.resize(lower + 2);
        Cell half = cell;
        half.halve(dimension, false);
        grow(lower, half, below, second_in(below));
        half = cell;
        half.halve(dimension, true);
        grow(lower + 1, half, above, second_in(above));
        const double sum = out_.node_share[lower] + out_.node_share[lower + 1];
        out_.node_share[node] = sum;
        out_.density.nodes[node] = {lower, dimension, rounded_share(out_.node_share[lower] / sum),
                                    middle};
    }

    /// The dimension along which bins differ most; kDimensions: by no more than noise in any.
    static std::uint32_t most_uneven(const Cell& cell, std::span<const Point> points,
                                     const Sums& sums)
    {
        std::array<std::array<double, kBins>, kDimensions> bins{};
        for (const Point& point : points)
            for (std::uint32_t d = 0; d < kDimensions; ++d) {
                const float place = (coordinate(point.at, d) - cell.low[d]) / cell.size[d];
                const auto bin = static_cast<int>(place * static_cast<float>(kBins));
                bins[d][static_cast<std::size_t>(std::clamp(bin, 0, int{kBins} - 1))] +=
                    point.second_of_power;
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

    LearntDensity out_;
};

} // namespace

DrawnPrimary draw(const PrimaryDensity& density, const PrimarySample& even)
{
    DrawnPrimary out{even, 1.0f};
    if (density.nodes.empty())
        return out;
    Cell cell;
    const auto at = [&](std::uint32_t d) -> float& {
        return out.at[d / 2][static_cast<int>(d % 2)];
    };
    const PrimaryDensity::Node* node = &density.nodes.front();
    while (node->lower != 0) {
        const std::uint32_t d = node->dimension;
        float& u = at(d);
        const bool upper = !(u < node->lower_share);
        const float share = upper ? 1 - node->lower_share : node->lower_share;
        u = std::min((upper ? u - node->lower_share : u) / share, 0x1.fffffep-1f);
        cell.halve(d, upper);
        out.density *= 2 * share;
        node = &density.nodes[node->lower + (upper ? 1 : 0)];
    }
    for (std::uint32_t d = 0; d < kDimensions; ++d)
        at(d) = std::min(cell.low[d] + cell.size[d] * at(d), 0x1.fffffep-1f);
    return out;
}

double density_at(const PrimaryDensity& density, const PrimarySample& at)
{
    double out = 1;
    if (density.nodes.empty())
        return out;
    const PrimaryDensity::Node* node = &density.nodes.front();
    while (node->lower != 0) {
        const bool upper = !(coordinate(at, node->dimension) < node->middle);
        out *= 2 * double{upper ? 1 - node->lower_share : node->lower_share};
        node = &density.nodes[node->lower + (upper ? 1 : 0)];
    }
    return out;
}

LearntDensity learn_density(std::span<const PrimaryWorth> points, double alike)
{
    std::vector<Point> tried;
    for (const double power : kPowers) {
        tried = by_power(points, power);
        if (sum_up(tried).alike() >= alike)
            break;
    }
    return Learner().learn(tried);
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
        if (learnt.node_share[i] > kMostDensity * volume[i])
            node.lower = 0;
        if (node.lower == 0)
            continue;
        volume[node.lower] = volume[node.lower + 1] = volume[i] / 2;
        node.lower_share = rounded_share(mass(node.lower) / mass(i));
    }
    return out;
}

} // namespace hipmap
