#pragma once

#include "common/image/legend.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace hipmap {

/// Describes an image as both tools list it in their JSON files.  A continuous scale is listed by
/// about 16 of its colours.
inline nlohmann::ordered_json picture_json(const LegendedPicture& picture)
{
    constexpr std::size_t kMostColours = 16;
    nlohmann::ordered_json legend = nlohmann::ordered_json::array();
    for (const LegendEntry& entry : picture.legend) {
        nlohmann::ordered_json colours = nlohmann::ordered_json::array();
        const std::size_t count = std::min(entry.colours.size(), kMostColours);
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t steps = std::max<std::size_t>(count - 1, 1);
            colours.push_back(hex_colour(entry.colours[i * (entry.colours.size() - 1) / steps]));
        }
        legend.push_back({{"colours", colours}, {"text", entry.text}});
    }
    return {{"file", picture.path.string()},
            {"width", picture.width},
            {"height", picture.height},
            {"legend", legend}};
}

} // namespace hipmap
