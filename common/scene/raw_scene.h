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
    std::vector<SharedFaces> shared;          ///< that have copies, ascending
    std::vector<FaceCopy> copies;             ///< in the world
    std::vector<RawObject> objects;
    std::vector<Material> materials; ///< media per metre, thickness in metres
    std::vector<TextureImage> images;
    double texture_cache_mib = SceneOptions().texture_cache_mib; ///< see there
    std::vector<SceneLight> lights;
    std::vector<RawCamera> cameras;
    glm::dvec3 world{0.0};                ///< radiance of the sky, W/(m2 sr)
    std::filesystem::path world_map_file; ///< empty: none
    double world_strength = 1.0;
    double world_turn_deg = 0.0;
    Medium around;                             ///< per metre
    Look look = Look::gltf;                    ///< which materials and lights have
    LightUnits light_units = LightUnits::spec; ///< of the file
    std::optional<SceneSweep> sweep;           ///< of the animation of which this is one moment
    SceneAudit audit;

    /// Returns the number of faces with those of copies.
    std::size_t all_face_count() const
    {
        std::size_t count = corners.size();
        for (const FaceCopy& copy : copies)
            count += shared[copy.shared].count;
        return count;
    }
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
