#include "common/scene/blender_losses.h"

#include "common/scene/named_lights.h"
#include "common/scene/scene_names.h"

#include <algorithm>
#include <cctype>
#include <set>

namespace hipmap {

namespace {

using nlohmann::json;

/// Bones may be leaves too.
std::set<std::size_t> joints_of(const json& root)
{
    std::set<std::size_t> out;
    const auto skins = root.find("skins");
    if (skins != root.end())
        for (const json& skin : *skins)
            for (const json& joint : skin["joints"])
                out.insert(joint.get<std::size_t>());
    return out;
}

bool is_bare(const json& node)
{
    for (const char* key : {"mesh", "camera", "extensions", "children"})
        if (node.contains(key) && !(node[key].is_array() && node[key].empty()))
            return false;
    const auto extras = node.find("extras");
    return extras == node.end() || !extras->is_object() || !extras->contains("hipmap");
}

std::vector<std::string> empty_leaves(const json& root, const std::vector<PlacedNode>& nodes)
{
    const std::set<std::size_t> joints = joints_of(root);
    std::vector<std::string> out;
    for (const PlacedNode& at : nodes) {
        const json& node = root["nodes"][at.node];
        if (is_bare(node) && !joints.contains(at.node))
            out.push_back(clean_name(node.value("name", std::string("node"))));
    }
    return out;
}

/// Materials of a Principled BSDF whose colour is white or was lost.
std::vector<std::string> white_materials(const json& root)
{
    std::vector<std::string> out;
    const auto materials = root.find("materials");
    if (materials == root.end())
        return out;
    for (const json& material : *materials) {
        const auto base = material.find("pbrMetallicRoughness");
        const bool is_glass = has_extension(material, "KHR_materials_transmission");
        if (base != material.end() && !base->empty() && !base->contains("baseColorFactor") &&
            !base->contains("baseColorTexture") && !is_glass)
            out.push_back(clean_name(material.value("name", std::string("material"))));
    }
    return out;
}

/// Objects with a mesh whose names are usual for what is hidden in renders.
std::vector<std::string> hidden_by_name(const json& root, const std::vector<PlacedNode>& nodes)
{
    std::vector<std::string> out;
    for (const PlacedNode& at : nodes) {
        const json& node = root["nodes"][at.node];
        if (!node.contains("mesh"))
            continue;
        const std::string name = node.value("name", std::string());
        std::string lower = name;
        std::ranges::transform(lower, lower.begin(),
                               [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
        for (const char* word : {"cutter", "bool", "helper", "hidden", "collision", "collider"})
            if (lower.find(word) != std::string::npos) {
                out.push_back(clean_name(name));
                break;
            }
    }
    return out;
}

void note_hidden_objects(const std::vector<std::string>& names, SceneAudit& audit)
{
    const std::string by_name =
        names.empty() ? "" : "; by its name, " + list_names(names) + " may have been hidden";
    audit.assumed.push_back("hidden objects are rendered if they are in the file (export with "
                            "Include > Renderable Objects, or --exclude NAME)" +
                            by_name);
}

void note_sizes(const RawScene& scene, SceneAudit& audit)
{
    std::vector<std::string> lights, cameras;
    for (const SceneLight& light : scene.lights)
        if (describe_light(light).lacks_size)
            lights.push_back(name_of(light));
    for (const RawCamera& camera : scene.cameras)
        if (camera.projection == Projection::perspective && !(camera.aperture_radius > 0))
            cameras.push_back(camera.name);
    const char* const cure = "; docs/scene.md, Custom properties, says how to add it";
    if (!lights.empty())
        audit.assumed.push_back("lights without size: " + list_names(lights) +
                                " (Blender's exporter drops their radius or angle)" + cure);
    if (!cameras.empty())
        audit.assumed.push_back("no depth of field: camera " + list_names(cameras) +
                                " (Blender's exporter drops it)" + cure);
}

void note_white_materials(const json& root, SceneAudit& audit)
{
    const std::vector<std::string> white = white_materials(root);
    if (!white.empty())
        audit.assumed.push_back("white base colour: " + list_names(white) +
                                "; if Blender shows another colour, its nodes (such as Noise or "
                                "Mix) were lost: bake them to an image texture");
}

/// Whether the add-on wrote or completed the file: it names in Blender what is lost.
bool is_completed(const GltfDocument& document)
{
    return generator_of(document).find("hipmap for Blender") != std::string::npos;
}

} // namespace

void note_blender_losses(const GltfDocument& document, const std::vector<PlacedNode>& nodes,
                         RawScene& scene)
{
    SceneAudit& audit = scene.audit;
    note_white_materials(document.json, audit);
    if (is_completed(document))
        return;
    const std::vector<std::string> leaves = empty_leaves(document.json, nodes);
    if (!leaves.empty())
        audit.warnings.push_back(
            "nothing in " + list_names(leaves) +
            ": an Empty of Blender, or what its exporter leaves out (area lights, hair, metaballs, "
            "objects of geometry nodes); replace an area light by a plane with an Emission "
            "material, and convert other objects to meshes");
    audit.assumed.push_back("modifiers are in the file if it was exported with Data > Mesh > Apply "
                            "Modifiers; hair and instances of geometry nodes never are");
    note_sizes(scene, audit);
    note_hidden_objects(hidden_by_name(document.json, nodes), audit);
}

} // namespace hipmap
