#pragma once

#include "common/partition/partition.h"

namespace hipmap::tiny {

/// A partition of one face.
inline Partition one_map()
{
    Partition out;
    out.map_of_face = {0};
    return out;
}

} // namespace hipmap::tiny
