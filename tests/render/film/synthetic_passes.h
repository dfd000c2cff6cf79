#pragma once

#include "common/math/random.h"
#include "render/film/film.h"

namespace hipmap {

/// Passes whose truth, noise and bias are known.  Blocks of pixels share photons; the narrower the
/// radius, the fewer of them count.
struct SyntheticPasses {
    int side = 24;
    int block = 4; ///< pixels a side that share photons
    double photon_noise =
        0.3; ///< of pass 0, relative, within the block; grows as the radius shrinks
    double pixel_noise = 0.3; ///< relative, of each pixel alone
    double rare = 0; ///< probability of the bright samples that make all of that; 0: not rare
    double bias = 0; ///< of pass 0, relative, order by order of `order`
    double order = 2;
    std::uint64_t seed = 0;
    bool radii = true;

    /// Bright and dark, with colours.
    Rgb truth(int x, int y) const
    {
        const float base =
            1.2f + std::sin(0.7f * static_cast<float>(x)) + std::cos(0.4f * static_cast<float>(y));
        return Rgb(base, 0.5f * base + 0.05f, x % 7 == 3 ? 0.02f : 0.8f);
    }

    Image truth() const
    {
        Image out(side, side);
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x)
                out.at(x, y) = truth(x, y);
        return out;
    }

    /// Sign and size change from block to block.
    double bias_at(int x, int y) const
    {
        return bias * std::sin(1.0 + x / block + 2.0 * (y / block));
    }

    PassImages pass(std::uint64_t number) const
    {
        const double radius = radius_of_pass(number, 2.0 / 3);
        PassImages out{Image(side, side), {}, {}, {}};
        out.kept.assign(out.radiance.pixels.size(), 1);
        if (radii)
            out.narrow = out.narrower = out.radiance;
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                RandomSequence photons(seed, RandomStream::photons, number,
                                       static_cast<std::uint64_t>(y / block) * side + x / block);
                RandomSequence paths(seed, RandomStream::eye_paths, number,
                                     static_cast<std::uint64_t>(y) * side + x);
                const double own = pixel_noise * (rare > 0 ? bright(paths) : skew(paths));
                // Each disc is halved into an inner disc and a ring, of as many photons each.
                const double noise = photon_noise / radius;
                const double narrower = 2 * noise * skew(photons);
                const double narrow = (narrower + 2 * noise * skew(photons)) / 2;
                const double wide = (narrow + std::sqrt(2.0) * noise * skew(photons)) / 2;
                const auto put = [&](Image& image, double off, double share) {
                    const double biased = bias_at(x, y) * std::pow(radius * share, order);
                    image.at(x, y) = truth(x, y) * static_cast<float>(1 + own + off + biased);
                };
                put(out.radiance, wide, 1);
                if (radii) {
                    put(out.narrow, narrow, kNarrowing);
                    put(out.narrower, narrower, kNarrowing * kNarrowing);
                }
            }
        return out;
    }

  private:
    /// Mean 0, variance 1, skewed as light is.
    static double skew(RandomSequence& random) { return -std::log(1.0 - random.next()) - 1; }

    /// The same by rare samples.
    double bright(RandomSequence& random) const
    {
        const double value = random.next() < rare ? 1 / rare : 0;
        return (value - 1) / std::sqrt((1 - rare) / rare);
    }
};

/// The root of relMSE, docs/error.md (3).
inline double true_error(const Image& image, const Image& truth)
{
    double mean = 0, sum = 0;
    for (const Rgb& pixel : truth.pixels)
        mean += double{pixel.x} + double{pixel.y} + double{pixel.z};
    const auto channels = 3 * static_cast<double>(truth.pixels.size());
    const double dark = 0.1 * mean / channels;
    for (std::size_t i = 0; i < truth.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            const double r = truth.pixels[i][c], off = image.pixels[i][c] - r;
            sum += off * off / (r * r + dark * dark);
        }
    return std::sqrt(sum / channels);
}

} // namespace hipmap
