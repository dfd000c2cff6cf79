#pragma once

#include "common/scene/decode_texture.h"
#include "common/scene/raw_scene.h"

#include <cstdint>
#include <span>
#include <string>

namespace hipmap {

/// Adds textures to a scene while all of them together have at most kMostPixelsInAll pixels.  Once
/// their pixels exceed the scene's texture_cache_mib, all go into one TextureCache.
class TextureStore {
  public:
    /// scene: borrowed.
    explicit TextureStore(RawScene& scene) : scene_(scene) {}

    /// Decodes a file as decode_texture does, to no more pixels than there is room for.
    DecodedTexture decode(std::span<const unsigned char> bytes) const;

    /// Returns whether there is room for another image of this size; warns that `what` is left out
    /// if not.
    bool has_room_for(const TextureImage& image, const std::string& what);

    /// Adds an image for which there is room, and returns its index.  Throws InputError as
    /// TextureCache::add does.
    std::uint32_t add(TextureImage image);

    /// Returns a copy of an image of the scene with all pixels in memory.
    TextureImage copy_of(std::uint32_t index) const;

    /// Warns that a texture cannot be used.  problem: as in DecodedTexture.
    void warn(const std::string& name, const std::string& problem);

  private:
    RawScene& scene_;
    std::uint64_t pixels_left_ = kMostPixelsInAll;
    std::shared_ptr<TextureCache> cache_; ///< null: all pixels are in memory
};

} // namespace hipmap
