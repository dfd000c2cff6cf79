#pragma once

#include "common/scene/scene.h"

#include <cstdint>
#include <string>
#include <vector>

namespace hipmap {

/// The photons from which an integrator that looks at the maps takes what it is to find.
enum class PhotonsRead : std::uint8_t {
    none,
    direct, ///< straight from a light, unless shadow rays find that
    others, ///< from specular surfaces, or after a bounce
    media,  ///< in media, along rays: never the k nearest
};

/// A scene of whose picture the mean is known exactly.
struct ClosedForm {
    std::string name;
    std::string formula; ///< of what is expected, in a few signs
    Scene scene;         ///< its camera sees what is expected
    double expected = 0; ///< mean of all pixels and channels, W/(m2 sr)
    PhotonsRead read = PhotonsRead::none;
    std::uint64_t photons = 1000;  ///< light paths a pass, where they are read
    std::string why_not_path{};    ///< integrator path cannot see it: why; empty: it can
    std::string why_not_photons{}; ///< the others cannot: why
};

/// Light straight from lights, and by one and by all bounces.
std::vector<ClosedForm> lit_forms();

/// Mirrors and glass, as the eye sees them.
std::vector<ClosedForm> seen_forms();

/// Light that mirrors and glass cast.
std::vector<ClosedForm> cast_forms();

/// Light that crosses media.
std::vector<ClosedForm> media_forms();

/// All of these.
std::vector<ClosedForm> closed_forms();

} // namespace hipmap
