#pragma once

#include "common/scene/mesh.h"

#include <array>
#include <cstddef>
#include <vector>

namespace hipmap {

/// The media that a point is in, by their materials: of those with the highest priority, the last
/// one entered fills the point.  Media nested deeper than kMost are ignored.
struct MediumStack {
    static constexpr std::size_t kMost = 8;
    std::array<MaterialId, kMost> entered; ///< [count] by priority, then as entered; no more is
                                           ///<     set, as most rays enter nothing
    std::size_t count = 0;

    /// Enters a medium.  priorities: [M].
    void enter(MaterialId material, const std::vector<float>& priorities);
    /// Leaves the last medium of the material; does nothing if there is none.
    void leave(MaterialId material);
    /// Returns the material of the medium that fills the point; kNone: none.
    MaterialId current() const { return count > 0 ? entered[count - 1] : kNone; }
};

} // namespace hipmap
