#pragma once

#include "common/input_error.h"
#include "common/math/bounds.h"
#include "common/scene/load_scene.h"
#include "common/scene/scene.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hipmap {

struct RawObject {
    std::string name;      ///< what a Blender user calls it (the node's name in glTF)
    std::string mesh_name; ///< of the shared mesh data; may be empty
};

/// A light as its file describes it: intensity in the file's own unit.
struct RawLight {
    std::string name;
    LightKind kind = LightKind::point;
    glm::dvec3 position{0.0};       ///< metres
    glm::dvec3 direction{0, 0, -1}; ///< unit
    glm::dvec3 intensity{1.0};      ///< colour times intensity
    double inner_angle = 0.0;       ///< radians from the axis; spot
    double outer_angle = 0.0;
    SpotFalloff falloff = SpotFalloff::gltf;
    double radius = 0.0;     ///< metres; point, spot
    double half_angle = 0.0; ///< radians; directional
};

/// A flat light that emits to one side.
struct RawAreaLight {
    std::string name;
    bool is_disc = false;
    glm::dvec3 centre{0.0}; ///< metres
    glm::dvec3 half_right{1, 0, 0}, half_up{0, 1, 0};
    glm::dvec3 direction{0, 0, -1}; ///< unit
    glm::dvec3 radiance{0.0};       ///< W/(m2 sr)
};

struct RawCamera {
    std::string name;
    Projection projection = Projection::perspective;
    glm::dvec3 position{0.0}; ///< metres
    glm::dvec3 right{1, 0, 0}, up{0, 1, 0}, forward{0, 0, -1};
    double tan_half_height = 0.5;
    double half_height = 1.0;                           ///< metres
    double aspect = 0.0;                                ///< 0: as the image
    glm::dvec2 shift{0.0};                              ///< right and up, in heights of the image
    double near_clip = 0.0;                             ///< metres
    double far_clip = 0.0;                              ///< 0: none
    double aperture_radius = 0.0, focus_distance = 0.0; ///< metres
};

/// The bounds of objects, lights and cameras over an animation, metres.
struct SceneSweep {
    std::vector<Bounds<glm::dvec3>> objects; ///< [O] of their faces
    Bounds<glm::dvec3> others;               ///< lights, cameras and other nodes without a mesh
};

/// A scene as its file describes it: metres, world space, doubles.  Every vertex is used by some
/// face.
struct RawScene {
    std::filesystem::path path;
    std::vector<glm::dvec3> positions;        ///< [V]
    std::vector<glm::vec3> normals;           ///< [V] unit; zero where there is none
    VertexAttributes attributes;              ///< [V] or empty
    std::vector<glm::uvec3> corners;          ///< [F]
    std::vector<MaterialId> material_of_face; ///< [F]
    std::vector<ObjectId> object_of_face;     ///< [F]
    std::vector<RawObject> objects;
    std::vector<Material> materials; ///< media per metre, thickness in metres
    std::vector<TextureImage> images;
    std::vector<RawLight> lights;
    std::vector<RawAreaLight> area_lights;
    std::vector<RawCamera> cameras;
    glm::dvec3 world{0.0};                ///< radiance of the sky, W/(m2 sr)
    std::filesystem::path world_map_file; ///< empty: none
    double world_strength = 1.0;
    double world_turn_deg = 0.0;
    Medium around;                   ///< per metre
    Look look = Look::gltf;          ///< which materials and lights have
    std::optional<SceneSweep> sweep; ///< of the animation of which this is one moment
    SceneAudit audit;
};

/// Returns the error for bad input: "file: place: what".
inline InputError scene_error(const std::filesystem::path& path, std::string_view place,
                              std::string_view what)
{
    std::string line = path.string() + ": ";
    if (!place.empty())
        line.append(place).append(": ");
    return InputError(line.append(what));
}

} // namespace hipmap
