#pragma once

#include "common/scene/gltf_document.h"
#include "common/scene/raw_scene.h"
#include "common/scene/texture_store.h"

#include <tiny_gltf.h>

#include <map>
#include <optional>
#include <vector>

namespace hipmap {

/// Reads the textures of materials, and each texture they name once.
class GltfTextureReader {
  public:
    GltfTextureReader(const GltfDocument& document, const tinygltf::Model& model, RawScene& scene)
        : document_(document), model_(model), scene_(scene), store_(scene)
    {
    }

    /// Reads the textures of a checked material.  A texture that is missing, damaged, too large or
    /// in an unsupported format, and a third set of texture coordinates, are warned of and left
    /// out, so that the factor stands alone.
    std::vector<TextureSlot> read(const nlohmann::json& material, const std::string& name);

  private:
    struct SlotKind;

    std::optional<TextureSlot> read_slot(const SlotKind& kind, const nlohmann::json& info,
                                         const std::string& material);
    /// Adds the roughness that a glossiness texture stands for, once for each factor; nothing, with
    /// a warning, if that would be too many pixels.
    std::optional<std::uint32_t> add_roughness(std::uint32_t image, float glossiness);
    Sampler read_sampler(const nlohmann::json& texture) const;
    std::optional<std::uint32_t> image_of(std::size_t index);
    std::optional<std::uint32_t> load_image(std::size_t index);
    std::vector<unsigned char> encoded_bytes(std::size_t index) const;

    static const SlotKind kSlotKinds[];

    const GltfDocument& document_;
    const tinygltf::Model& model_;
    RawScene& scene_;
    std::vector<std::optional<std::optional<std::uint32_t>>> images_; ///< by the file's number
    std::map<std::pair<std::uint32_t, float>, std::uint32_t> roughness_images_;
    TextureStore store_;
};

} // namespace hipmap
