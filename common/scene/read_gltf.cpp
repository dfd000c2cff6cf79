#include "common/scene/read_gltf.h"

#include "common/scene/blender_losses.h"
#include "common/scene/gltf_animation.h"
#include "common/scene/gltf_extras.h"
#include "common/scene/gltf_light_camera.h"
#include "common/scene/gltf_material.h"
#include "common/scene/gltf_model.h"
#include "common/scene/gltf_nodes.h"
#include "common/scene/gltf_placement.h"
#include "common/scene/gltf_unread.h"
#include "common/scene/scene_names.h"

namespace hipmap {

namespace {

std::string first_name(std::initializer_list<std::string> names)
{
    for (const std::string& name : names)
        if (!name.empty())
            return clean_name(name);
    return {};
}

void add_lights_and_cameras(const GltfDocument& document, const tinygltf::Model& model,
                            const std::vector<PlacedNode>& nodes, RawScene& scene)
{
    for (const PlacedNode& at : nodes) {
        if (!at.visible)
            continue;
        const tinygltf::Node& node = model.nodes[at.node];
        if (node.camera >= 0) {
            const auto camera = static_cast<std::size_t>(node.camera);
            const std::string name = first_name(
                {node.name, model.cameras[camera].name, "camera " + std::to_string(camera)});
            if (add_gltf_camera(model, camera, name, at.to_world, scene))
                read_camera_extras(document, at.node, camera, scene);
        }
        const auto punctual = node.extensions.find("KHR_lights_punctual");
        if (punctual != node.extensions.end()) {
            const auto light =
                static_cast<std::size_t>(punctual->second.Get("light").GetNumberAsInt());
            const std::string name =
                first_name({node.name, model.lights[light].name, "light " + std::to_string(light)});
            if (add_gltf_light(model, light, name, at.to_world, scene))
                read_light_extras(document, at, light, scene);
        }
        if (node.camera < 0 && punctual == node.extensions.end() && node.mesh < 0)
            read_empty_extras(document, at, scene);
    }
}

void note_scenes(const tinygltf::Model& model, SceneAudit& audit)
{
    if (model.scenes.size() < 2)
        return;
    const auto scene = static_cast<std::size_t>(std::max(0, model.defaultScene));
    audit.assumed.push_back(
        "of " + std::to_string(model.scenes.size()) +
        " scenes in the file, using the active one: " +
        quote_name(first_name({model.scenes[scene].name, "scene " + std::to_string(scene)})));
}

void note_hidden(const tinygltf::Model& model, const std::vector<PlacedNode>& nodes,
                 SceneAudit& audit)
{
    std::vector<std::string> hidden;
    for (const PlacedNode& at : nodes)
        if (!at.visible)
            hidden.push_back(
                first_name({model.nodes[at.node].name, "node " + std::to_string(at.node)}));
    if (!hidden.empty())
        audit.found.push_back("hidden (KHR_node_visibility), not rendered: " + list_names(hidden));
}

void note_animation(const GltfAnimation& animation, std::optional<double> time, SceneAudit& audit)
{
    if (animation.channels.empty())
        return;
    const std::string what = list_names(animation.names) + " moves " + list_names(animation.moved) +
                             " from " + short_number(animation.first) + " to " +
                             short_number(animation.last) + " s";
    if (time)
        audit.found.push_back("animation " + what + "; this frame is at " + short_number(*time) +
                              " s");
    else
        audit.assumed.push_back("animation " + what +
                                ": showing the rest pose (--frames A:B "
                                "renders frames of it)");
}

} // namespace

GltfSource::GltfSource(const std::filesystem::path& path, const SceneOptions& options)
    : document_(read_gltf_document(path)), model_(parse_gltf(document_)), rest_(model_.nodes)
{
    timeless_.path = path;
    const std::string generator = generator_of(document_);
    by_blender_ = look_of_generator(generator).has_value();
    timeless_.look = choose_look(options.look, generator);
    timeless_.light_units = options.light_units;
    timeless_.texture_cache_mib = options.texture_cache_mib;
    read_gltf_materials(document_, model_, timeless_);
    animation_ = read_gltf_animation(document_, model_, timeless_.audit);
    const bool has_copies = animation_.channels.empty() && options.exclude.empty();
    least_copied_ = has_copies ? options.least_copied_faces : kNever;
}

RawScene GltfSource::at(std::optional<double> time, bool last)
{
    if (time && !swept_)
        sweep_ = sweep_nodes(animation_, model_, timeless_.path);
    swept_ = swept_ || time;
    RawScene scene = last ? std::move(timeless_) : timeless_;
    scene.sweep = time ? sweep_ : std::nullopt;
    model_.nodes = rest_;
    if (time)
        pose_nodes(animation_, *time, model_);
    const std::vector<PlacedNode> nodes = place_nodes(model_, scene.path);
    place_meshes(model_, nodes, find_wanted_attributes(document_), least_copied_, scene);
    add_lights_and_cameras(document_, model_, nodes, scene);
    read_world_extras(document_, scene);
    note_scenes(model_, scene.audit);
    note_hidden(model_, nodes, scene.audit);
    if (by_blender_)
        note_blender_losses(document_, nodes, scene);
    note_animation(animation_, time, scene.audit);
    warn_of_unread_gltf(document_, scene.audit);
    return scene;
}

} // namespace hipmap
