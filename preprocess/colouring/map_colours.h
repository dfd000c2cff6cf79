#pragma once

#include "common/partition/partition.h"
#include "preprocess/colouring/palette.h"

namespace hipmap {

/// Chooses a display-linear colour for every shared map.  Maps that meet at an edge are never
/// alike; a map that meets few others mostly has the colour of its id in palette_colour. Returns
/// [map_count].  The same partition gives the same colours.  Near linear. Greedy colouring in order
/// of falling degree (Welsh and Powell 1967).
std::vector<Rgb> map_colours(const Partition& partition);

/// Chooses a display-linear colour for every group-map candidate, as map_colours does for shared
/// maps.  Returns [group_count].
std::vector<Rgb> group_colours(const Partition& partition);

} // namespace hipmap
