#pragma once

#include "preprocess/partition/build_partition.h"
#include "render/shading/render_scene.h"
#include "tests/support/tiny_meshes.h"

#include <memory>
#include <utility>

namespace hipmap::tiny {

/// A scene with its partition and all that rendering needs, on the heap so that it can be returned.
struct ReadyScene {
    Scene scene;
    Partition partition;
    std::unique_ptr<RenderScene> render;
};

inline std::unique_ptr<ReadyScene> ready(Scene scene)
{
    auto out = std::make_unique<ReadyScene>();
    out->scene = std::move(scene);
    out->partition = build_partition(out->scene, {}).partition;
    out->render = std::make_unique<RenderScene>(out->scene, out->partition);
    return out;
}

/// Lambert, purely.
inline Material diffuse(const Rgb& albedo)
{
    Material material;
    material.base_color = albedo;
    material.metallic = 0;
    material.specular = 0;
    return material;
}

inline Material mirror(const Rgb& reflectance)
{
    Material material;
    material.base_color = reflectance;
    material.roughness = 0;
    return material;
}

inline Material glass(float ior)
{
    Material material;
    material.metallic = 0;
    material.roughness = 0;
    material.transmission = 1;
    material.ior = ior;
    return material;
}

inline Material emissive(const Rgb& radiance)
{
    Material material = diffuse(Rgb(0));
    material.emission = radiance;
    return material;
}

inline void scale(TriangleMesh& mesh, float factor)
{
    for (glm::vec3& p : mesh.positions)
        p *= factor;
}

inline void move(TriangleMesh& mesh, const glm::vec3& by)
{
    for (glm::vec3& p : mesh.positions)
        p += by;
}

/// Turns every front into a back.
inline void turn_inside_out(TriangleMesh& mesh)
{
    for (FaceId face = 0; face < mesh.face_count(); ++face)
        flip(mesh, face);
}

/// Adds `mesh` to the scene with a material of its own.
inline void add(Scene& scene, const TriangleMesh& mesh, const Material& material)
{
    std::vector<MaterialId> materials = scene.mesh.material_of_face;
    scene.materials.push_back(material);
    scene.mesh = together(scene.mesh, mesh);
    materials.resize(scene.mesh.face_count(), static_cast<MaterialId>(scene.materials.size() - 1));
    scene.mesh.material_of_face = std::move(materials);
}

/// Square of side `side` about (0, y, 0), facing up, or down if `side` is negative: 2 faces.
inline TriangleMesh floor_at(float y, float side)
{
    const float h = 0.5f * side, w = std::abs(h);
    return make_mesh({{-w, y, h}, {w, y, h}, {w, y, -h}, {-w, y, -h}}, {{0, 1, 2}, {0, 2, 3}});
}

/// A sphere about the origin of 16,000 facets, with the volume of one of the radius.
inline TriangleMesh fine_ball(double radius)
{
    TriangleMesh mesh = uv_sphere(128, 64);
    double volume = 0;
    for (const glm::uvec3& c : mesh.corners)
        volume +=
            glm::dot(glm::dvec3(mesh.positions[c.x]),
                     glm::cross(glm::dvec3(mesh.positions[c.y]), glm::dvec3(mesh.positions[c.z]))) /
            6;
    scale(mesh, static_cast<float>(radius * std::cbrt(4 * M_PI / 3 / volume)));
    return mesh;
}

/// The parallelogram from `corner` along two sides, facing along u x v: 2 faces.
inline TriangleMesh parallelogram(const glm::vec3& corner, const glm::vec3& u, const glm::vec3& v)
{
    return make_mesh({corner, corner + u, corner + u + v, corner + v}, {{0, 1, 2}, {0, 2, 3}});
}

/// Looks along `forward` (unit, not along z) at a square of side `side` about `middle` and across
/// it, by parallel rays that start `distance` before it.
inline Camera square_view(const glm::vec3& middle, const glm::vec3& forward, float side,
                          float distance)
{
    Camera camera;
    camera.projection = Projection::orthographic;
    camera.position = middle - distance * forward;
    camera.forward = forward;
    camera.right = glm::normalize(glm::cross(forward, glm::vec3(0, 0, 1)));
    camera.up = glm::cross(camera.right, forward);
    camera.half_height = 0.5f * side;
    return camera;
}

} // namespace hipmap::tiny
