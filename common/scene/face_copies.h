#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace hipmap {

/// Index of a face (a world-space triangle); the same in both tools.  Faces that are stored come
/// first, in load order, then those of copies, copy by copy.
using FaceId = std::uint32_t;
using MaterialId = std::uint32_t;
using ObjectId = std::uint32_t;

/// Marks the absence of a face, map or object.
inline constexpr std::uint32_t kNone = 0xffffffffu;

/// Turns, then scales, then moves.
struct Similarity {
    glm::dmat3 turn{1.0}; ///< a rotation
    double scale = 1.0;   ///< above 0
    glm::dvec3 move{0.0};

    glm::dvec3 point(const glm::dvec3& p) const { return scale * (turn * p) + move; }
    glm::dvec3 direction(const glm::dvec3& d) const { return turn * d; }
    /// The inverses of both.
    glm::dvec3 point_back(const glm::dvec3& p) const { return (p - move) * turn / scale; }
    glm::dvec3 direction_back(const glm::dvec3& d) const { return d * turn; }

    bool operator==(const Similarity&) const = default;
};

/// Returns what does `first` and then `second`.
Similarity compose(const Similarity& second, const Similarity& first);

/// Returns what undoes a similarity.
Similarity inverse(const Similarity& place);

/// Returns a transform as a similarity, if it is one up to the rounding of its numbers and does not
/// mirror.
std::optional<Similarity> to_similarity(const glm::dmat4& transform);

/// Stored faces that stand in the scene several times: once where they are stored, and once for
/// each copy.  No other faces have their vertices.
struct SharedFaces {
    FaceId first = 0;
    std::uint32_t count = 0;
    std::uint32_t first_vertex = 0, vertex_count = 0;

    bool operator==(const SharedFaces&) const = default;
};

/// A copy of shared faces elsewhere in the scene.
struct FaceCopy {
    std::uint32_t shared = 0; ///< index of the faces
    ObjectId object = 0;      ///< that has the copy
    Similarity place;         ///< from where the faces are stored to where the copy lies

    bool operator==(const FaceCopy&) const = default;
};

/// Drops shared faces without copies.
void drop_unshared(std::vector<SharedFaces>& shared, std::vector<FaceCopy>& copies);

/// Finds the copy that a face belongs to, by the number of the first face of each copy.
class CopyFinder {
  public:
    CopyFinder() = default; ///< of no copies

    /// first: [copies] ascending, the first being the number of stored faces.  end: one past the
    /// last face of the last copy.
    CopyFinder(std::vector<FaceId> first, FaceId end);

    /// Returns the copy of a face that no copy comes before.  Cost: few steps.
    std::uint32_t copy_of(FaceId face) const
    {
        std::uint32_t copy = copy_at_block_[(face - first_.front()) >> block_bits_];
        while (copy + 1 < first_.size() && first_[copy + 1] <= face)
            ++copy;
        return copy;
    }
    FaceId first_face(std::uint32_t copy) const { return first_[copy]; }
    std::size_t count() const { return first_.size(); }
    /// Returns one past the last face; 0 without copies.
    FaceId end() const { return end_; }

  private:
    std::vector<FaceId> first_;
    FaceId end_ = 0;
    std::uint32_t block_bits_ = 0;
    std::vector<std::uint32_t> copy_at_block_; ///< the copy of the first face of each block
};

/// Returns the finder of copies that follow `stored` faces.  The sum of their faces must be below
/// kNone.
CopyFinder find_copies(FaceId stored, std::span<const SharedFaces> shared,
                       std::span<const FaceCopy> copies);

} // namespace hipmap
