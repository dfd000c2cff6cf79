#include "common/scene/texture_store.h"

#include "common/scene/scene_names.h"
#include "common/scene/texture_cache.h"

#include <algorithm>
#include <cassert>

namespace hipmap {

namespace {

constexpr double kMib = 1 << 20;

std::uint64_t pixel_count(const TextureImage& image)
{
    return static_cast<std::uint64_t>(image.width) * static_cast<std::uint64_t>(image.height);
}

} // namespace

DecodedTexture TextureStore::decode(std::span<const unsigned char> bytes) const
{
    return decode_texture(bytes, std::min(kMostPixels, pixels_left_));
}

bool TextureStore::has_room_for(const TextureImage& image, const std::string& what)
{
    const bool room = pixel_count(image) <= pixels_left_;
    if (!room)
        scene_.audit.warnings.push_back(
            what + " " + quote_name(image.name) +
            " is left out: the textures have too many pixels; make them smaller");
    return room;
}

std::uint32_t TextureStore::add(TextureImage image)
{
    assert(pixel_count(image) <= pixels_left_);
    pixels_left_ -= pixel_count(image);
    scene_.images.push_back(std::move(image));
    const std::uint64_t bytes = 4 * (kMostPixelsInAll - pixels_left_);
    if (cache_) {
        move_to_cache(scene_.images.back(), cache_);
    } else if (const auto most = static_cast<std::uint64_t>(kMib * scene_.texture_cache_mib);
               bytes > most) {
        cache_ = std::make_shared<TextureCache>(most);
        for (TextureImage& each : scene_.images)
            move_to_cache(each, cache_);
    }
    return static_cast<std::uint32_t>(scene_.images.size() - 1);
}

TextureImage TextureStore::copy_of(std::uint32_t index) const
{
    return in_memory(scene_.images[index]);
}

void TextureStore::warn(const std::string& name, const std::string& problem)
{
    scene_.audit.warnings.push_back("texture " + quote_name(name) + " " + problem +
                                    "; using plain colours instead");
}

} // namespace hipmap
