#include "common/scene/gltf_model.h"

#include "common/scene/gltf_buffers.h"
#include "common/scene/gltf_draco.h"
#include "common/scene/gltf_meshopt.h"
#include "common/scene/gltf_unread.h"
#include "common/scene/raw_scene.h"
#include "common/scene/scene_names.h"

#include <set>

namespace hipmap {

namespace {

/// The JSON that tinygltf gets to see.  It would fail a load whose indices or buffers exist in
/// compressed form only, so these are left to us, as are materials and textures.
std::string text_for_tinygltf(const GltfDocument& document)
{
    const std::set<std::string> ours = {"buffers",  "images",    "textures",
                                        "samplers", "materials", "animations"};
    nlohmann::json root;
    for (const auto& [key, value] : document.json.items())
        if (!ours.contains(key))
            root[key] = value;
    if (root.contains("meshes"))
        for (nlohmann::json& mesh : root["meshes"])
            for (nlohmann::json& primitive : mesh["primitives"]) {
                primitive.erase("indices");
                primitive.erase("material");
            }
    return root.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

void restore_references(const GltfDocument& document, tinygltf::Model& model)
{
    for (std::size_t m = 0; m < model.meshes.size(); ++m) {
        const nlohmann::json& primitives = document.json["meshes"][m]["primitives"];
        for (std::size_t p = 0; p < primitives.size(); ++p) {
            tinygltf::Primitive& primitive = model.meshes[m].primitives[p];
            primitive.indices = primitives[p].value("indices", -1);
            primitive.material = primitives[p].value("material", -1);
        }
    }
}

/// An uncompressed bufferView must not lie in a buffer that is only a placeholder.
void check_plain_views(const GltfDocument& document, const tinygltf::Model& model)
{
    for (std::size_t i = 0; i < model.bufferViews.size(); ++i) {
        const tinygltf::BufferView& view = model.bufferViews[i];
        if (model.buffers[static_cast<std::size_t>(view.buffer)].data.empty())
            throw scene_error(document.path, "bufferViews[" + std::to_string(i) + "]",
                              "lies in a fallback buffer that the file lacks; export it "
                              "again");
    }
}

} // namespace

tinygltf::Model parse_gltf(GltfDocument& document)
{
    check_required_extensions(document);
    std::vector<std::vector<unsigned char>> buffers = load_gltf_buffers(document);
    tinygltf::Model model;
    std::string error, warning;
    bool good = false;
    try {
        const std::string text = text_for_tinygltf(document);
        good = tinygltf::TinyGLTF().LoadASCIIFromString(&model, &error, &warning, text.data(),
                                                        static_cast<unsigned int>(text.size()), "");
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& failure) {
        error = failure.what();
    }
    if (!good)
        throw scene_error(document.path, "glTF",
                          "cannot be read (" + quote_name(error.substr(0, error.find('\n'))) +
                              "); export it again");
    restore_references(document, model);
    for (std::vector<unsigned char>& bytes : buffers)
        model.buffers.emplace_back().data = std::move(bytes);
    decode_meshopt_views(document, model);
    check_plain_views(document, model);
    decode_draco_primitives(document, model);
    return model;
}

} // namespace hipmap
