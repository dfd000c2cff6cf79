#include "common/scene/gltf_mesh.h"

#include "common/math/bounds.h"
#include "common/scene/gltf_accessor.h"
#include "common/scene/scene_names.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <optional>

namespace hipmap {

namespace {

/// Where coordinates exceed the mesh's size by more, float leaves fewer than 10 bits of it.
constexpr double kFarFromOrigin = 16384.0;

bool is_surface(int mode)
{
    return mode == TINYGLTF_MODE_TRIANGLES || mode == TINYGLTF_MODE_TRIANGLE_STRIP ||
           mode == TINYGLTF_MODE_TRIANGLE_FAN;
}

bool is_finite_point(const glm::dvec3& p)
{
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

void demand(bool good, const RawScene& scene, const std::string& place, const std::string& what)
{
    if (!good)
        throw scene_error(scene.path, place, what + "; the file is damaged, export it again");
}

std::size_t triangle_count(int mode, std::size_t vertices)
{
    if (mode == TINYGLTF_MODE_TRIANGLES)
        return vertices / 3;
    return vertices < 3 ? 0 : vertices - 2;
}

/// Positions in the list of vertices of triangle `t` (glTF 2.0, section 3.7.2.1).
glm::uvec3 triangle_slots(int mode, std::uint32_t t)
{
    if (mode == TINYGLTF_MODE_TRIANGLES)
        return {3 * t, 3 * t + 1, 3 * t + 2};
    if (mode == TINYGLTF_MODE_TRIANGLE_FAN)
        return {t + 1, t + 2, 0};
    return {t, t + 1 + t % 2, t + 2 - t % 2};
}

/// The vectors of some vertices, read in parallel.
std::vector<glm::dvec3> vectors_of(const GltfAccessor& accessor,
                                   const std::vector<std::uint32_t>& vertices)
{
    std::vector<glm::dvec3> out(vertices.size());
    tbb::parallel_for(std::size_t{0}, vertices.size(),
                      [&](std::size_t i) { out[i] = accessor.vec3(vertices[i]); });
    return out;
}

/// The first face that names a vertex beyond those there are; the number of faces if none does.
std::size_t first_wrong(const std::vector<glm::uvec3>& corners, std::size_t vertex_count)
{
    return tbb::parallel_reduce(
        tbb::blocked_range<std::size_t>(0, corners.size()), corners.size(),
        [&](const auto& faces, std::size_t first) {
            for (std::size_t t = faces.begin(); t < std::min(faces.end(), first); ++t)
                if (std::max({corners[t].x, corners[t].y, corners[t].z}) >= vertex_count)
                    return t;
            return first;
        },
        [](std::size_t a, std::size_t b) { return std::min(a, b); });
}

void warn_if_baked_far_away(const GltfPrimitive& primitive, const std::string& mesh,
                            SceneAudit& audit)
{
    Bounds<glm::dvec3> bounds;
    for (const glm::dvec3& p : primitive.positions)
        bounds.add(p);
    const glm::dvec3 size = bounds.extent();
    const glm::dvec3 away = glm::max(glm::abs(bounds.low), glm::abs(bounds.high));
    const double extent = std::max(size.x, std::max(size.y, size.z));
    const double distance = std::max(away.x, std::max(away.y, away.z));
    if (extent > 0 && distance > kFarFromOrigin * extent)
        audit.warnings.push_back(mesh + " lies " + short_number(distance) +
                                 " m from its origin but is " + short_number(extent) +
                                 " m in size: its positions have lost detail; in Blender set the "
                                 "origin to its geometry before exporting");
}

} // namespace

std::vector<GltfPrimitive> GltfMeshReader::read(std::size_t index)
{
    std::vector<GltfPrimitive> primitives;
    const tinygltf::Mesh& mesh = model_.meshes[index];
    for (std::size_t i = 0; i < mesh.primitives.size(); ++i) {
        const tinygltf::Primitive& primitive = mesh.primitives[i];
        const std::string place =
            "meshes[" + std::to_string(index) + "].primitives[" + std::to_string(i) + "]";
        if (!is_surface(primitive.mode))
            continue;
        if (!primitive.attributes.contains("POSITION")) {
            scene_.audit.warnings.push_back(place + " has no positions and is skipped");
            continue;
        }
        primitives.push_back(read_primitive(primitive, place));
        warn_if_baked_far_away(primitives.back(),
                               mesh.name.empty() ? place : "mesh " + quote_name(mesh.name),
                               scene_.audit);
    }
    return primitives;
}

GltfPrimitive GltfMeshReader::read_primitive(const tinygltf::Primitive& primitive,
                                             const std::string& place)
{
    const GltfAccessor positions(model_, primitive.attributes.at("POSITION"), scene_.path);
    demand(positions.type() == TINYGLTF_TYPE_VEC3 &&
               positions.component_type() != TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT,
           scene_, place, "POSITION must be vectors of three");
    std::optional<GltfAccessor> normals;
    if (primitive.attributes.contains("NORMAL")) {
        normals.emplace(model_, primitive.attributes.at("NORMAL"), scene_.path);
        demand(normals->type() == TINYGLTF_TYPE_VEC3 && normals->size() == positions.size(), scene_,
               place, "NORMAL must be as many vectors of three as POSITION");
    }

    GltfPrimitive out;
    out.material = primitive.material;
    out.corners = read_corners(primitive, positions.size(), place);
    const std::vector<std::uint32_t> used = number_used(out.corners, positions.size());
    out.positions = vectors_of(positions, used);
    if (normals)
        out.normals = vectors_of(*normals, used);
    for (std::size_t i = 0; i < used.size(); ++i)
        if (!is_finite_point(out.positions[i]) || (normals && !is_finite_point(out.normals[i])))
            throw scene_error(scene_.path, place + ", vertex " + std::to_string(used[i]),
                              "a position or normal is not finite; repair the mesh and export it "
                              "again");
    const PrimitivePlace at{model_, primitive, scene_.path, place};
    out.attributes = read_attributes(at, wanted_, {positions.size(), used});
    out.deformation = read_deformation(at, {positions.size(), used});
    return out;
}

/// Numbers the vertices of the corners in the order of their first use; returns which of the file's
/// they are.
std::vector<std::uint32_t> GltfMeshReader::number_used(std::vector<glm::uvec3>& corners,
                                                       std::size_t vertex_count)
{
    if (local_.size() < vertex_count)
        local_.resize(vertex_count, kNone);
    std::vector<std::uint32_t> used;
    for (glm::uvec3& face : corners)
        for (int c = 0; c < 3; ++c) {
            std::uint32_t& local = local_[face[c]];
            if (local == kNone) {
                local = static_cast<std::uint32_t>(used.size());
                used.push_back(face[c]);
            }
            face[c] = local;
        }
    for (const std::uint32_t vertex : used)
        local_[vertex] = kNone;
    return used;
}

std::vector<glm::uvec3> GltfMeshReader::read_corners(const tinygltf::Primitive& primitive,
                                                     std::size_t vertex_count,
                                                     const std::string& place)
{
    std::optional<GltfAccessor> indices;
    if (primitive.indices >= 0) {
        indices.emplace(model_, primitive.indices, scene_.path);
        const int type = indices->component_type();
        demand(indices->type() == TINYGLTF_TYPE_SCALAR && !indices->normalized() &&
                   (type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
                    type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
                    type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT),
               scene_, place, "indices must be unsigned integers");
    }
    const std::size_t listed = indices ? indices->size() : vertex_count;
    const std::size_t faces = triangle_count(primitive.mode, listed);
    demand(listed < kNone && vertex_count < kNone, scene_, place, "more than 2^32 - 2 vertices");
    if (listed < 3 || (primitive.mode == TINYGLTF_MODE_TRIANGLES && listed % 3 != 0))
        scene_.audit.warnings.push_back(place + " lists " + std::to_string(listed) +
                                        " corners; the incomplete last face is left out");

    std::vector<glm::uvec3> corners(faces);
    tbb::parallel_for(std::size_t{0}, faces, [&](std::size_t t) {
        glm::uvec3 face = triangle_slots(primitive.mode, static_cast<std::uint32_t>(t));
        for (int c = 0; c < 3 && indices; ++c)
            face[c] = indices->index(face[c]);
        corners[t] = face;
    });
    if (const std::size_t wrong = first_wrong(corners, vertex_count); wrong < faces) {
        const glm::uvec3& face = corners[wrong];
        throw scene_error(scene_.path, place + ", face " + std::to_string(wrong),
                          "names vertex " + std::to_string(std::max({face.x, face.y, face.z})) +
                              " of " + std::to_string(vertex_count) +
                              "; the file is damaged, export it again");
    }
    return corners;
}

} // namespace hipmap
