#pragma once

#include "common/scene/texture_store.h"

#include <tiny_obj_loader.h>

#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace hipmap {

/// Reads the textures of MTL materials, each file once.
class ObjTextureReader {
  public:
    explicit ObjTextureReader(RawScene& scene) : scene_(scene), store_(scene) {}

    /// Adds the textures that a material names to `out`, whose factors they multiply, and their
    /// images to the scene; docs/scene.md has the table.  A texture that is missing, outside the
    /// scene's folder, damaged, too large or in another format than PNG and JPEG is warned of and
    /// left out.  by_blender: Blender wrote the file, whose map_Ns holds roughness.
    void read(const tinyobj::material_t& mtl, bool by_blender, Material& out);

    /// Warns, once for all materials, of textures that are named but not used, and notes how bump
    /// maps were taken.
    void note_textures() const;

  private:
    void read_colours(const tinyobj::material_t& mtl, Material& out);
    void read_opacity(const tinyobj::material_t& mtl, Material& out);
    void read_physical(const tinyobj::material_t& mtl, Material& out);
    void read_exponents(const tinyobj::material_t& mtl, bool by_blender, Material& out);
    void read_normals(const tinyobj::material_t& mtl, Material& out);
    void read_bump(const tinyobj::material_t& mtl, Material& out);
    void collect_unread(const tinyobj::material_t& mtl);
    /// Returns the index of the image; nothing, with a warning, if it cannot be used.
    std::optional<std::uint32_t> image_of(const std::string& name);
    std::optional<std::uint32_t> load_image(const std::string& name);
    std::optional<std::uint32_t> add_image(TextureImage image);

    RawScene& scene_;
    std::map<std::string, std::optional<std::uint32_t>> images_; ///< by name in the file
    /// Normal maps of height maps by name, strength and whether they end at the edge.
    std::map<std::tuple<std::string, float, bool>, std::optional<std::uint32_t>> bumps_;
    std::map<std::string, std::vector<std::string>> unread_; ///< materials by key
    std::vector<std::string> heights_, normals_;             ///< materials by their map_Bump
    TextureStore store_;
};

} // namespace hipmap
