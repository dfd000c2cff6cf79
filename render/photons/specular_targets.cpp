#include "render/photons/specular_targets.h"

#include "common/math/bounds.h"
#include "common/math/frame.h"
#include "common/math/sampling.h"

#include <algorithm>
#include <array>

namespace hipmap {

namespace {

constexpr std::size_t kMostTargets = 32;

/// Room for rounding, so that no face reaches out of its sphere.
constexpr float kMargin = 1 + 1e-5f;

struct Cluster {
    std::vector<FaceId> faces;
    Bounds<glm::vec3> box; ///< of the faces
};

/// Whether any point of the material can have a specular lobe.
bool may_be_specular(const Material& material, const Bsdf& bsdf)
{
    return bsdf.coated || bsdf.metal > 0 || bsdf.glass > 0 ||
           find_texture(material.textures, TextureUse::metallic_roughness) != nullptr ||
           find_texture(material.textures, TextureUse::transmission) != nullptr;
}

glm::vec3 centroid(const TriangleMesh& mesh, FaceId face)
{
    const glm::uvec3 c = mesh.corners[face];
    return (mesh.positions[c.x] + mesh.positions[c.y] + mesh.positions[c.z]) / 3.0f;
}

void add_face(const TriangleMesh& mesh, FaceId face, Cluster& to)
{
    to.faces.push_back(face);
    const glm::uvec3 corners = mesh.corners[face];
    for (int c = 0; c < 3; ++c)
        to.box.add(mesh.positions[corners[c]]);
}

float radius(const Cluster& cluster)
{
    return 0.5f * glm::length(cluster.box.extent());
}

/// The faces on either side of the middle of the longest side; one of them may be empty.
std::array<Cluster, 2> halve(const TriangleMesh& mesh, const Cluster& whole)
{
    const glm::vec3 extent = whole.box.extent();
    const int axis =
        extent.x >= extent.y ? (extent.x >= extent.z ? 0 : 2) : (extent.y >= extent.z ? 1 : 2);
    const float middle = whole.box.centre()[axis];
    std::array<Cluster, 2> out;
    for (const FaceId face : whole.faces)
        add_face(mesh, face, out[centroid(mesh, face)[axis] < middle ? 0 : 1]);
    return out;
}

/// Halves the largest cluster again and again, while that makes its parts smaller.
std::vector<Cluster> split(const TriangleMesh& mesh, Cluster all)
{
    std::vector<Cluster> open{std::move(all)}, done;
    while (!open.empty() && open.size() + done.size() < kMostTargets) {
        const auto largest =
            std::max_element(open.begin(), open.end(), [](const Cluster& a, const Cluster& b) {
                return radius(a) < radius(b);
            });
        const Cluster whole = std::move(*largest);
        open.erase(largest);
        std::array<Cluster, 2> halves = halve(mesh, whole);
        const bool smaller = !halves[0].faces.empty() && !halves[1].faces.empty() &&
                             std::max(radius(halves[0]), radius(halves[1])) < 0.9f * radius(whole);
        if (!smaller) {
            done.push_back(whole);
            continue;
        }
        open.push_back(std::move(halves[0]));
        open.push_back(std::move(halves[1]));
    }
    done.insert(done.end(), std::make_move_iterator(open.begin()),
                std::make_move_iterator(open.end()));
    return done;
}

/// Solid angle of the cone around a sphere over 2 pi; 2 from inside.
float cone_height(const TargetSphere& target, const glm::vec3& origin)
{
    const glm::vec3 way = target.centre - origin;
    const float distance2 = glm::dot(way, way), radius2 = target.radius * target.radius;
    if (distance2 <= radius2)
        return 2;
    const float sin2 = radius2 / distance2;
    return sin2 / (1 + std::sqrt(1 - sin2)); // 1 - cos without cancellation
}

bool in_cone(const TargetSphere& target, float height, const glm::vec3& origin,
             const glm::vec3& direction)
{
    if (height >= 2)
        return true;
    const glm::vec3 axis = glm::normalize(target.centre - origin);
    const glm::vec3 sine = glm::cross(axis, direction); // steadier than the cosine in thin cones
    return glm::dot(axis, direction) > 0 && glm::dot(sine, sine) < height * (2 - height);
}

/// Unit vector whose height over the xy plane is `below` less than 1.
glm::vec3 direction_below_pole(float below, float u)
{
    const float sine = std::sqrt(below * (2 - below)), phi = 2 * kPi * u;
    return {sine * std::cos(phi), sine * std::sin(phi), 1 - below};
}

bool in_cylinder(const TargetSphere& target, const glm::vec3& point, const glm::vec3& direction)
{
    const glm::vec3 across = glm::cross(point - target.centre, direction);
    return glm::dot(across, across) < target.radius * target.radius;
}

} // namespace

std::vector<TargetSphere> find_specular_targets(const RenderScene& scene)
{
    const TriangleMesh& mesh = scene.mesh();
    Cluster all;
    for (FaceId face = 0; face < mesh.face_count(); ++face) {
        const MaterialId material = mesh.material_of_face[face];
        if (may_be_specular(scene.scene.materials[material], scene.bsdfs[material]))
            add_face(mesh, face, all);
    }
    std::vector<TargetSphere> out;
    if (all.faces.empty())
        return out;
    for (const Cluster& cluster : split(mesh, std::move(all)))
        if (radius(cluster) > 0)
            out.push_back({cluster.box.centre(), kMargin * radius(cluster)});
    return out;
}

AimedRay aim_from_point(const std::vector<TargetSphere>& targets, const glm::vec3& origin,
                        RandomSequence& random)
{
    std::array<float, kMostTargets> heights;
    float sum = 0;
    for (std::size_t i = 0; i < targets.size(); ++i)
        sum += heights[i] = cone_height(targets[i], origin);
    float drawn = random.next() * sum;
    std::size_t chosen = 0;
    while (chosen + 1 < targets.size() && drawn >= heights[chosen])
        drawn -= heights[chosen++];
    const glm::vec2 u = random.next2();
    const glm::vec3 way = targets[chosen].centre - origin;
    // From inside a sphere any direction will do, and the centre may be the origin itself.
    const glm::vec3 axis = heights[chosen] >= 2 ? glm::vec3(0, 0, 1) : glm::normalize(way);
    AimedRay out;
    out.direction = Frame(axis).to_world(direction_below_pole(heights[chosen] * u.x, u.y));
    int cones = 1; // the chosen one, whatever rounding says
    for (std::size_t i = 0; i < targets.size(); ++i)
        cones += i != chosen && in_cone(targets[i], heights[i], origin, out.direction) ? 1 : 0;
    out.weight = 2 * kPi * sum / static_cast<float>(cones);
    return out;
}

AimedPoint aim_parallel(const std::vector<TargetSphere>& targets, const glm::vec3& direction,
                        RandomSequence& random)
{
    float sum = 0;
    for (const TargetSphere& target : targets)
        sum += target.radius * target.radius;
    float drawn = random.next() * sum;
    std::size_t chosen = 0;
    while (chosen + 1 < targets.size() && drawn >= targets[chosen].radius * targets[chosen].radius)
        drawn -= targets[chosen].radius * targets[chosen].radius, ++chosen;
    const glm::vec2 disc = targets[chosen].radius * sample_disc(random.next2());
    const Frame frame(direction);
    AimedPoint out;
    out.position = targets[chosen].centre + frame.x * disc.x + frame.y * disc.y;
    int cylinders = 1;
    for (std::size_t i = 0; i < targets.size(); ++i)
        cylinders += i != chosen && in_cylinder(targets[i], out.position, direction) ? 1 : 0;
    out.weight = kPi * sum / static_cast<float>(cylinders);
    return out;
}

} // namespace hipmap
