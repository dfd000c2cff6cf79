#pragma once

#include "common/scene/load_scene.h"
#include "tests/support/temporary_folder.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace hipmap::tiny {

using nlohmann::json;

/// A glTF file in the making: JSON that tests edit, and the bytes of its one buffer.
struct GltfFile {
    json root = {{"asset", {{"version", "2.0"}}}, {"scene", 0}, {"scenes", {{{"nodes", {0}}}}}};
    std::string bytes;

    /// Appends an accessor over `values` with the given number of components; its index.
    template <typename T>
    int add_accessor(const std::vector<T>& values, const char* type, int components,
                     int component_type)
    {
        const std::size_t offset = bytes.size();
        bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
        const std::size_t length = bytes.size() - offset;
        bytes.resize((bytes.size() + 3) / 4 * 4);
        root["bufferViews"].push_back(
            {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", length}});
        root["accessors"].push_back(
            {{"bufferView", root["bufferViews"].size() - 1},
             {"componentType", component_type},
             {"count", values.size() / static_cast<std::size_t>(components)},
             {"type", type}});
        return static_cast<int>(root["accessors"].size()) - 1;
    }

    int add_vectors(const std::vector<float>& xyz) { return add_accessor(xyz, "VEC3", 3, 5126); }

    int add_indices(const std::vector<std::uint16_t>& indices)
    {
        return add_accessor(indices, "SCALAR", 1, 5123);
    }

    std::string text() const { return root.dump(-1, ' ', false, json::error_handler_t::replace); }

    /// The GLB container: JSON chunk and BIN chunk.
    std::string glb() const
    {
        json whole = root;
        if (!bytes.empty() && !whole.contains("buffers"))
            whole["buffers"] = {{{"byteLength", bytes.size()}}};
        std::string chunk = whole.dump();
        chunk.resize((chunk.size() + 3) / 4 * 4, ' ');
        const std::size_t total = 20 + chunk.size() + (bytes.empty() ? 0 : 8 + bytes.size());
        std::string out = "glTF" + word(2) + word(total) + word(chunk.size()) + "JSON" + chunk;
        if (!bytes.empty())
            out += word(bytes.size()) + std::string("BIN\0", 4) + bytes;
        return out;
    }

    static std::string word(std::size_t value)
    {
        std::string out;
        for (int shift = 0; shift < 32; shift += 8)
            out += static_cast<char>((value >> shift) & 0xff);
        return out;
    }
};

/// Not synced to the disk, as write_file would, nor written over, which some file systems sync
/// too: tests write thousands.
inline void write_text(const std::filesystem::path& path, const std::string& content)
{
    std::filesystem::remove(path);
    std::ofstream(path, std::ios::binary) << content;
}

inline LoadedScene load_text(const std::string& name, const std::string& content,
                             const SceneOptions& options = {})
{
    static const TemporaryFolder folder; // one for all: tests load thousands
    write_text(folder / name, content);
    return load_scene(folder / name, options);
}

inline LoadedScene load(const GltfFile& file, const SceneOptions& options = {})
{
    return load_text("scene.glb", file.glb(), options);
}

/// World position, in metres, of a vertex of a loaded scene.
inline glm::dvec3 world(const Scene& scene, std::uint32_t vertex)
{
    return scene.frame.centre +
           scene.frame.metres_per_unit * glm::dvec3(scene.mesh.positions[vertex]);
}

} // namespace hipmap::tiny
