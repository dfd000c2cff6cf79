#include "preprocess/open_glass.h"

#include "common/scene/scene_names.h"

#include <map>

namespace hipmap {

namespace {

constexpr std::size_t kMostNamed = 4;

/// The border edges of the open glass of each object that has some.
std::map<ObjectId, std::size_t> count_borders(const Scene& scene, const Partition& partition)
{
    std::map<ObjectId, std::size_t> out;
    for (FaceId face = 0; face < scene.mesh.face_count(); ++face) {
        const Material& material = scene.materials[scene.mesh.material_of_face[face]];
        if (!(material.transmission > 0) || partition.closed[face] != 0 ||
            !(face_area(scene.mesh, face) > 0))
            continue;
        std::size_t& edges = out[scene.mesh.object_of_face[face]];
        for (std::size_t c = 0; c < 3; ++c)
            edges += partition.edge_class[std::size_t{3} * face + c] == EdgeClass::border ? 1 : 0;
    }
    return out;
}

} // namespace

std::vector<std::string> describe_open_glass(const Scene& scene, const Partition& partition)
{
    const std::map<ObjectId, std::size_t> open = count_borders(scene, partition);
    std::vector<std::string> out;
    for (const auto& [object, edges] : open) {
        if (out.size() == kMostNamed)
            break;
        const std::string state =
            edges > 0 ? " is open (" + counted(edges, "border edge") + ")" : " encloses no volume";
        out.push_back(quote_name(scene.mesh.object_names[object]) + state +
                      ": rendered as a thin pane; close its mesh for solid glass");
    }
    if (open.size() > kMostNamed)
        out.push_back(counted(open.size() - kMostNamed, "more object") +
                      " of open glass: rendered as thin panes");
    return out;
}

} // namespace hipmap
