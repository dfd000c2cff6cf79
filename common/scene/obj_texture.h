#pragma once

#include "common/scene/texture_store.h"

#include <tiny_obj_loader.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace hipmap {

/// Reads the textures of MTL materials, each file once.
class ObjTextureReader {
  public:
    explicit ObjTextureReader(RawScene& scene) : scene_(scene), store_(scene) {}

    /// Adds the textures that a material names to `out`, whose factors they multiply, and their
    /// images to the scene; docs/scene.md has the table.  A texture that is missing, outside the
    /// scene's folder, damaged, too large or in another format than PNG and JPEG is warned of and
    /// left out.
    void read(const tinyobj::material_t& mtl, Material& out);

    /// Warns, once for all materials, of textures that are named but not used.
    void note_unread() const;

  private:
    void read_colours(const tinyobj::material_t& mtl, Material& out);
    void read_opacity(const tinyobj::material_t& mtl, Material& out);
    void read_physical(const tinyobj::material_t& mtl, Material& out);
    void collect_unread(const tinyobj::material_t& mtl);
    /// Returns the index of the image; nothing, with a warning, if it cannot be used.
    std::optional<std::uint32_t> image_of(const std::string& name);
    std::optional<std::uint32_t> load_image(const std::string& name);
    std::optional<std::uint32_t> add_image(TextureImage image);

    RawScene& scene_;
    std::map<std::string, std::optional<std::uint32_t>> images_; ///< by name in the file
    std::map<std::string, std::vector<std::string>> unread_;     ///< materials by key
    TextureStore store_;
};

} // namespace hipmap
