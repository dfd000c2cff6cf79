#include "bench/brute_force_partition.h"

#include "bench/plain_triangle.h"

#include <algorithm>
#include <cmath>

namespace hipmap {
namespace {

std::string at_edge(std::uint32_t edge)
{
    return "edge " + std::to_string(edge % 3) + " of face " + std::to_string(edge / 3) + ": ";
}

/// The partition that the rules give, in the order in which the page has them.
class BruteForce {
  public:
    BruteForce(const TriangleMesh& mesh, const Partition& partition);

    std::string difference() const;

  private:
    bool runs_along(std::uint32_t edge, std::uint32_t other) const;
    bool same_direction(std::uint32_t edge, std::uint32_t other) const
    {
        return faces_[edge / 3].start(edge % 3) == faces_[other / 3].start(other % 3);
    }
    bool is_cut(std::uint32_t edge) const;
    void find_mates();
    void find_windings();
    EdgeClass class_of(std::uint32_t edge) const;
    std::vector<MapId> relabelled() const;
    bool may_go_on(std::uint32_t edge) const;
    bool is_seam(FaceId f, FaceId g) const;
    std::string edge_difference(std::uint32_t edge) const;

    const Partition& partition_;
    std::vector<PlainTriangle> faces_;
    std::vector<std::vector<std::uint32_t>> mates_; ///< [3F] other edges with the same ends
    std::vector<EdgeClass> classes_;                ///< [3F]
    std::vector<FaceId> surface_;                   ///< [F] of faces whose windings are related
    std::vector<std::uint8_t> turned_;              ///< [F] against the rest of its surface
    std::string contradiction_;                     ///< in these
    long double position_error_ = 0;
};

BruteForce::BruteForce(const TriangleMesh& mesh, const Partition& partition) : partition_(partition)
{
    for (FaceId face = 0; face < mesh.face_count(); ++face)
        faces_.emplace_back(mesh, face);
    for (const glm::vec3& p : mesh.positions)
        for (int axis = 0; axis < 3; ++axis)
            position_error_ = std::max(position_error_, 0x1p-20L * std::abs(p[axis]));
    find_mates();
    find_windings();
    for (std::uint32_t edge = 0; edge < mates_.size(); ++edge)
        classes_.push_back(class_of(edge));
}

bool BruteForce::runs_along(std::uint32_t edge, std::uint32_t other) const
{
    const PlainTriangle& f = faces_[edge / 3];
    const PlainTriangle& g = faces_[other / 3];
    const std::uint32_t a = f.start(edge % 3), b = f.end(edge % 3);
    const std::uint32_t c = g.start(other % 3), d = g.end(other % 3);
    return (a == c && b == d) || (a == d && b == c);
}

void BruteForce::find_mates()
{
    mates_.resize(3 * faces_.size());
    for (std::uint32_t edge = 0; edge < mates_.size(); ++edge)
        for (std::uint32_t other = 0; other < mates_.size(); ++other)
            if (edge != other && !faces_[edge / 3].degenerate && !faces_[other / 3].degenerate &&
                runs_along(edge, other))
                mates_[edge].push_back(other);
}

bool BruteForce::is_cut(std::uint32_t edge) const
{
    return mates_[edge].size() == 1 && partition_.edge_class[edge] == EdgeClass::non_manifold;
}

/// Relates the windings of faces across edges of two faces that are not cut, by relabelling.
void BruteForce::find_windings()
{
    turned_.assign(faces_.size(), 0);
    for (FaceId face = 0; face < faces_.size(); ++face)
        surface_.push_back(face);
    const auto visit_pairs = [&](bool cut, const auto& visit) {
        for (std::uint32_t edge = 0; edge < mates_.size(); ++edge)
            if (mates_[edge].size() == 1 && is_cut(edge) == cut) {
                const FaceId f = edge / 3, g = mates_[edge][0] / 3;
                const bool turn =
                    (turned_[f] != turned_[g]) != same_direction(edge, mates_[edge][0]);
                visit(edge, f, g, turn);
            }
    };
    visit_pairs(false, [&](std::uint32_t edge, FaceId f, FaceId g, bool turn) {
        const FaceId old = surface_[g];
        if (old == surface_[f]) {
            if (turn)
                contradiction_ = at_edge(edge) + "no winding suits it, but it is not cut";
            return;
        }
        for (FaceId face = 0; face < faces_.size(); ++face)
            if (surface_[face] == old) {
                surface_[face] = surface_[f];
                turned_[face] ^= std::uint8_t{turn};
            }
    });
    visit_pairs(true, [&](std::uint32_t edge, FaceId f, FaceId g, bool turn) {
        if (surface_[f] != surface_[g] || !turn || !same_direction(edge, mates_[edge][0]))
            contradiction_ = at_edge(edge) + "cut without need";
    });
}

/// The table of docs/partition_file.md, with (1) by an angle.
EdgeClass BruteForce::class_of(std::uint32_t edge) const
{
    const PlainTriangle& face = faces_[edge / 3];
    if (face.degenerate)
        return EdgeClass::degenerate;
    if (mates_[edge].empty())
        return EdgeClass::border;
    if (mates_[edge].size() > 1 || is_cut(edge))
        return EdgeClass::non_manifold;
    const FaceId other = mates_[edge][0] / 3;
    const PlainTriangle::Vector& n1 = face.normal;
    const PlainTriangle::Vector n2 =
        turned_[edge / 3] == turned_[other] ? faces_[other].normal : -faces_[other].normal;
    const long double angle = std::atan2(glm::length(glm::cross(n1, n2)), glm::dot(n1, n2));
    return angle < partition_.angle_threshold - 1e-4L ? EdgeClass::connected
                                                      : EdgeClass::unconnected;
}

/// Whether the surface may go on beyond an edge without a neighbour there.
bool BruteForce::may_go_on(std::uint32_t edge) const
{
    const auto in_plane = [&](std::uint32_t mate) {
        return in_parallel_planes(faces_[edge / 3], faces_[mate / 3], position_error_);
    };
    switch (classes_[edge]) {
    case EdgeClass::border:
        return true;
    case EdgeClass::non_manifold:
        return std::ranges::all_of(mates_[edge], in_plane);
    case EdgeClass::unconnected:
        return same_direction(edge, mates_[edge][0]);
    default:
        return false;
    }
}

bool BruteForce::is_seam(FaceId f, FaceId g) const
{
    if (faces_[f].degenerate || faces_[g].degenerate ||
        !(glm::dot(faces_[f].normal, faces_[g].normal) > 0) ||
        !in_parallel_planes(faces_[f], faces_[g], position_error_))
        return false;
    for (std::uint32_t c = 0; c < 3; ++c)
        if ((may_go_on(3 * f + c) && lies_on(faces_[f], c, faces_[g], position_error_)) ||
            (may_go_on(3 * g + c) && lies_on(faces_[g], c, faces_[f], position_error_)))
            return true;
    return false;
}

/// The dissertation's Algorithm 2: all faces of the one map are renamed wherever two maps meet.
std::vector<MapId> BruteForce::relabelled() const
{
    const auto face_count = static_cast<FaceId>(faces_.size());
    std::vector<MapId> map;
    for (FaceId face = 0; face < face_count; ++face)
        map.push_back(faces_[face].degenerate ? kNone : face);
    const auto join = [&](FaceId f, FaceId g) {
        const auto [low, high] = std::minmax(map[f], map[g]);
        if (low != high)
            std::ranges::replace(map, MapId{high}, MapId{low});
    };
    for (std::uint32_t edge = 0; edge < classes_.size(); ++edge)
        if (classes_[edge] == EdgeClass::connected)
            join(edge / 3, mates_[edge][0] / 3);
    if (partition_.angle_threshold > 1e-4)
        for (FaceId f = 0; f < face_count; ++f)
            for (FaceId g = f + 1; g < face_count; ++g)
                if (map[f] != map[g] && is_seam(f, g))
                    join(f, g);
    // The lowest face names a map; these names in order are its number.
    MapId count = 0;
    for (FaceId face = 0; face < face_count; ++face)
        if (map[face] == face)
            std::ranges::replace(map.begin() + face, map.end(), MapId{face}, count++);
    return map;
}

std::string BruteForce::edge_difference(std::uint32_t edge) const
{
    const auto number = [](EdgeClass c) { return std::to_string(static_cast<int>(c)); };
    if (partition_.edge_class[edge] != classes_[edge])
        return at_edge(edge) + "class " + number(partition_.edge_class[edge]) + ", not " +
               number(classes_[edge]);
    const bool paired =
        classes_[edge] == EdgeClass::connected || classes_[edge] == EdgeClass::unconnected;
    if (partition_.opposite[edge] != (paired ? mates_[edge][0] : kNone))
        return at_edge(edge) + "opposite " + std::to_string(partition_.opposite[edge]);
    if (classes_[edge] == EdgeClass::connected) {
        const FaceId f = edge / 3, g = mates_[edge][0] / 3;
        if ((partition_.flipped[f] != partition_.flipped[g]) != (turned_[f] != turned_[g]))
            return at_edge(edge) + "connected faces with different fronts";
    }
    return {};
}

std::string BruteForce::difference() const
{
    if (!contradiction_.empty())
        return contradiction_;
    for (std::uint32_t edge = 0; edge < classes_.size(); ++edge)
        if (std::string found = edge_difference(edge); !found.empty())
            return found;
    const std::vector<MapId> map = relabelled();
    for (FaceId face = 0; face < map.size(); ++face)
        if (partition_.map_of_face[face] != map[face])
            return "face " + std::to_string(face) + ": map " +
                   std::to_string(static_cast<int>(partition_.map_of_face[face])) + ", not " +
                   std::to_string(static_cast<int>(map[face]));
    return {};
}

} // namespace

std::string difference_from_brute_force(const TriangleMesh& mesh, const Partition& partition)
{
    return BruteForce(mesh, partition).difference();
}

} // namespace hipmap
