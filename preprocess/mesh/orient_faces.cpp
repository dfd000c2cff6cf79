#include "preprocess/mesh/orient_faces.h"

#include <array>
#include <span>
#include <utility>

namespace hipmap {
namespace {

/// Whether two faces are wound against each other on an edge that both have.
bool same_direction(const WeldedFaces& faces, std::uint32_t edge, std::uint32_t twin)
{
    return faces.start(edge) == faces.start(twin);
}

/// Walks one component; `flipped` becomes whether a face is wound against the first one.
/// Edges that the winding as authored suits are crossed first, so that a surface with one side is
/// cut where its author let the winding change.
class ComponentWalk {
  public:
    ComponentWalk(const WeldedFaces& faces, Orientation& out)
        : faces_(faces), out_(out), seen_(faces.degenerate)
    {
    }

    /// The faces connected with `seed`, in the order of the walk; empty if it was seen before.
    std::span<const FaceId> walk(FaceId seed)
    {
        order_.clear();
        against_.clear();
        if (seen_[seed])
            return {};
        seen_[seed] = 1;
        order_.push_back(seed);
        std::size_t next_face = 0;
        std::size_t next_edge = 0;
        for (;;) {
            while (next_face < order_.size())
                leave(order_[next_face++]);
            if (next_edge == against_.size())
                return order_;
            cross(against_[next_edge++]);
        }
    }

  private:
    void leave(FaceId face)
    {
        for (std::uint32_t edge = 3 * face; edge < 3 * face + 3; ++edge) {
            const std::uint32_t twin = out_.partner[edge];
            if (twin == kNone)
                continue;
            if (same_direction(faces_, edge, twin))
                against_.push_back(edge);
            else
                cross(edge);
        }
    }

    void cross(std::uint32_t edge)
    {
        const std::uint32_t twin = out_.partner[edge];
        if (twin == kNone) // cut from its other side
            return;
        const std::uint8_t wanted =
            out_.flipped[edge / 3] ^ std::uint8_t{same_direction(faces_, edge, twin)};
        if (!seen_[twin / 3]) {
            seen_[twin / 3] = 1;
            out_.flipped[twin / 3] = wanted;
            order_.push_back(twin / 3);
        } else if (out_.flipped[twin / 3] != wanted) {
            out_.partner[edge] = out_.partner[twin] = kNone;
            ++out_.cut_edges;
        }
    }

    const WeldedFaces& faces_;
    Orientation& out_;
    std::vector<std::uint8_t> seen_;
    std::vector<FaceId> order_;
    std::vector<std::uint32_t> against_; ///< edges met on the way that the winding does not suit
};

} // namespace

Orientation orient_faces(const TriangleMesh& mesh, const WeldedFaces& faces, EdgePairs&& pairs)
{
    Orientation out;
    out.flipped.assign(mesh.face_count(), 0);
    out.partner = std::move(pairs.partner);
    if (pairs.wound_alike) // as most meshes are: a walk would turn nothing
        return out;
    ComponentWalk component(faces, out);
    for (FaceId seed = 0; seed < mesh.face_count(); ++seed) {
        const std::span<const FaceId> members = component.walk(seed);
        std::array<double, 2> area{0.0, 0.0};
        for (const FaceId face : members)
            area[out.flipped[face]] += face_area(mesh, face);
        if (area[1] > area[0])
            for (const FaceId face : members)
                out.flipped[face] ^= 1;
    }
    return out;
}

} // namespace hipmap
