#pragma once

#include <array>
#include <cstdint>

namespace hipmap {

/// Light that pilots expect and that few samples find.  docs/error.md (28).
struct RareLight {
    double variance = 0; ///< relMSE that it makes in one pass
    double missing = 0;  ///< relMSE of an image without it
    double finds = 0;    ///< samples of a pass that find it, on average

    bool operator==(const RareLight&) const = default;
};

/// The rare light of an image, by the octave of how often a pass finds it in a pixel.
struct ExpectedLight {
    static constexpr int kOctaves = 24;
    std::array<RareLight, kOctaves> light{};

    bool operator==(const ExpectedLight&) const = default;
};

/// Adds the light of a pixel.  Where a pass finds it eight times or more, hardly an image misses
/// it: nothing is added.
void add_light(const RareLight& light, ExpectedLight& into);

/// Returns the relMSE, with 95 % confidence, by light that so many passes may not have found in
/// pixels that show it.
double missing_square(const ExpectedLight& expected, std::uint64_t passes);

/// Returns the relMSE that light which `passes` may not have found is expected to add after `later`
/// passes, if these find it twice.  docs/error.md (29).
double unmet_square(const ExpectedLight& expected, double passes, double later);

} // namespace hipmap
