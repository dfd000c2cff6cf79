#pragma once

#include "common/math/bounds.h"
#include "common/partition/limiting_radius.h"

#include <array>

namespace hipmap {

/// Faces stored side by side, to be sorted by planes in float.
class NearbyFaces {
  public:
    static constexpr std::size_t kMost = 256;
    using Places = std::array<std::array<float, kMost>, 9>; ///< [3 corner + axis][i]

    void clear() { count_ = 0; }
    std::size_t count() const { return count_; }
    FaceId face(std::size_t i) const { return faces_[i]; }

    /// Adds a face if its box meets `box`.  Returns false if there is no room.
    bool add(const TriangleMesh& mesh, FaceId face, const Bounds<glm::vec3>& box);

    /// Finds which planes each face may have a corner in front of by more than `error`, at least
    /// position_error_of(mesh): bit c of front(i) is 0 only if face i has no corner in front of
    /// plane c.
    void sort_out(const std::array<EdgePlane, 3>& planes, double error);
    unsigned front(std::size_t i) const { return front_[i]; }

  private:
    std::size_t count_ = 0;
    std::array<FaceId, kMost> faces_;
    Places places_;
    std::array<std::uint32_t, kMost> front_;
};

} // namespace hipmap
