#pragma once

#include "common/scene/mesh.h"
#include "render/media/matt_only.h"

#include <array>
#include <cstddef>
#include <vector>

namespace hipmap {

/// Which insides a point is in, by their materials: of those of the highest priority the last one
/// entered is what is there.  Insides nested deeper than kMost are passed over.
struct MediumStack {
    static constexpr std::size_t kMost = kMattOnly ? 1 : 8;
    std::array<MaterialId, kMost> entered; ///< [count] by priority, then as entered; no more is
                                           ///<     set, as most rays enter nothing
    std::size_t count = 0;

    /// priorities: [M].
    void enter(MaterialId material, const std::vector<float>& priorities);
    /// The last one of the material; nothing if there is none.
    void leave(MaterialId material);
    /// kNone: in none.
    MaterialId current() const { return count > 0 ? entered[count - 1] : kNone; }
};

} // namespace hipmap
