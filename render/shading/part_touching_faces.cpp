#include "render/shading/part_touching_faces.h"

#include "common/rays/embree_scene.h"
#include "render/shading/opacity.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <tuple>

namespace hipmap {

namespace {

/// Position errors within which two planes are one, and by which faces are moved apart: rays start
/// within one of their face.
constexpr double kSame = 2, kApart = 8;

/// Which way a face that lies on another one moves.
enum class Way : std::uint8_t { none, forwards, inwards, off };

/// By material, of faces of open and of closed surfaces.
struct Ways {
    Way open = Way::none;
    Way closed = Way::none;
};

Ways ways_of(const Scene& scene, const Material& material)
{
    // Open faces that gather photons stay: the partition has joined their map to that of the face
    // behind, and an estimate would find the photons of both.
    if (material.transmission > 0 || !material.boundary)
        return {Way::off, Way::inwards};
    if (material.diffuse_transmission > 0 || may_let_light_pass(scene, material))
        return {Way::none, Way::inwards};
    if (!is_black(material.emission))
        return {Way::forwards, Way::forwards};
    return {};
}

struct Triangle {
    std::array<glm::dvec3, 3> corners;
    glm::dvec3 normal{0.0}; ///< unit; zero without area

    Triangle(const TriangleMesh& mesh, FaceId face)
    {
        const auto in_scene = mesh.triangle(face);
        for (std::size_t c = 0; c < 3; ++c)
            corners[c] = glm::dvec3(in_scene[c]);
        const glm::dvec3 n = scaled_normal(mesh, face);
        if (glm::length(n) > 0)
            normal = glm::normalize(n);
    }
};

/// How far the corners of `g` are from the plane of `f` at most.
double farthest(const Triangle& f, const Triangle& g)
{
    double out = 0;
    for (const glm::dvec3& corner : g.corners)
        out = std::max(out, std::abs(glm::dot(corner - f.corners[0], f.normal)));
    return out;
}

/// Whether some line along an edge of `f` in its plane has both triangles on different sides, but
/// for `margin`.
bool parted_by_edge(const Triangle& f, const Triangle& g, double margin)
{
    for (int c = 0; c < 3; ++c) {
        const glm::dvec3 edge = f.corners[(c + 1) % 3] - f.corners[c];
        const glm::dvec3 out = glm::normalize(glm::cross(edge, f.normal));
        bool beyond = true;
        for (const glm::dvec3& corner : g.corners)
            beyond = beyond && glm::dot(corner - f.corners[c], out) >= -margin;
        if (beyond)
            return true;
    }
    return false;
}

/// Whether both lie in one plane and cover a common area.
bool lie_on_each_other(const Triangle& f, const Triangle& g, double error)
{
    const double same = kSame * error;
    if (g.normal == glm::dvec3(0) || std::abs(glm::dot(f.normal, g.normal)) < 0.99)
        return false;
    if (std::min(farthest(f, g), farthest(g, f)) > same)
        return false;
    return !parted_by_edge(f, g, same) && !parted_by_edge(g, f, same);
}

/// Which way `face` moves; nothing if it lies on no other face.
std::optional<glm::dvec3> direction_of(const TriangleMesh& mesh, const EmbreeScene& faces,
                                       FaceId face, Way way, double error)
{
    const Triangle own(mesh, face);
    const glm::dvec3 middle = (own.corners[0] + own.corners[1] + own.corners[2]) / 3.0;
    double radius = 0;
    for (const glm::dvec3& corner : own.corners)
        radius = std::max(radius, glm::distance(middle, corner));
    FaceId found = kNone;
    faces.visit_near(glm::vec3(middle), static_cast<float>(radius + 4 * error), [&](FaceId other) {
        if (other < found && other != face && lie_on_each_other(own, Triangle(mesh, other), error))
            found = other;
    });
    if (found == kNone)
        return {};
    if (way == Way::off)
        return Triangle(mesh, found).normal;
    return way == Way::forwards ? own.normal : -own.normal;
}

/// A vertex of an object, wherever the file splits it.
using Place = std::tuple<ObjectId, float, float, float>;

Place place_of(const TriangleMesh& mesh, FaceId face, int corner)
{
    const glm::vec3 p = mesh.positions[mesh.corners[face][corner]] + 0.0f; // -0 is 0
    return {mesh.object_of(face), p.x, p.y, p.z};
}

/// Adds a direction that none of those before has.
void add_direction(std::vector<glm::dvec3>& directions, const glm::dvec3& direction)
{
    const bool known = std::ranges::any_of(
        directions, [&](const glm::dvec3& before) { return glm::dot(before, direction) > 0.99; });
    if (!known)
        directions.push_back(direction);
}

using Moves = std::map<Place, std::vector<glm::dvec3>>;

void move_vertices(TriangleMesh& mesh, const Moves& moves, double by)
{
    std::vector<std::uint8_t> moved(mesh.positions.size(), 0);
    for (FaceId face = 0; face < mesh.face_count(); ++face)
        for (int corner = 0; corner < 3; ++corner) {
            const std::uint32_t vertex = mesh.corners[face][corner];
            if (moved[vertex] != 0)
                continue;
            const auto move = moves.find(place_of(mesh, face, corner));
            if (move == moves.end())
                continue;
            glm::dvec3 sum(0.0);
            for (const glm::dvec3& direction : move->second)
                sum += direction;
            moved[vertex] = 1;
            mesh.positions[vertex] = glm::vec3(glm::dvec3(mesh.positions[vertex]) + by * sum);
        }
}

} // namespace

std::size_t part_touching_faces(Scene& scene, const Partition& partition)
{
    TriangleMesh& mesh = scene.mesh;
    std::vector<Ways> ways;
    for (const Material& material : scene.materials)
        ways.push_back(ways_of(scene, material));
    std::vector<FaceId> asked;
    const auto way_of = [&](FaceId face) {
        const Ways& both = ways[mesh.material_of(face)];
        return partition.is_closed(face) ? both.closed : both.open;
    };
    for (FaceId face = 0; face < mesh.face_count(); ++face)
        if (way_of(face) != Way::none && partition.map_of(face) != kNone)
            asked.push_back(face);
    if (asked.empty())
        return 0;
    const EmbreeScene faces(mesh);
    std::vector<std::optional<glm::dvec3>> found(asked.size());
    tbb::parallel_for(std::size_t{0}, asked.size(), [&](std::size_t i) {
        found[i] = direction_of(mesh, faces, asked[i], way_of(asked[i]), partition.position_error);
    });
    Moves moves;
    for (std::size_t i = 0; i < asked.size(); ++i)
        for (int corner = 0; corner < 3 && found[i]; ++corner)
            add_direction(moves[place_of(mesh, asked[i], corner)], *found[i]);
    move_vertices(mesh, moves, kApart * double{partition.position_error});
    return static_cast<std::size_t>(std::ranges::count_if(
        found, [](const std::optional<glm::dvec3>& direction) { return direction.has_value(); }));
}

} // namespace hipmap
