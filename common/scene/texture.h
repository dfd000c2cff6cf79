#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace hipmap {

class TextureCache;

/// A 128-bit hash of pixels.
using PixelDigest = std::array<std::uint64_t, 2>;

/// The pixels of a texture that memory need not hold.
struct CachedPixels {
    std::shared_ptr<TextureCache> cache;
    std::uint32_t first_tile = 0;
    bool has_alpha = false; ///< some alpha is below 255
    PixelDigest digest{};
};

/// A texture as its file has it, 8 bits a channel, rows from the top left.
struct TextureImage {
    std::string name;
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba; ///< [4 * width * height]; empty if `cached` has the pixels
    std::optional<CachedPixels> cached = std::nullopt; ///< none: all pixels are in memory
};

/// How a texture continues outside [0, 1]: repeated, mirrored, or by its edge.
enum class Wrap : std::uint8_t { repeat, mirror, clamp };
enum class Filter : std::uint8_t { linear, nearest };

/// How a texture is sampled.
struct Sampler {
    Wrap wrap_u = Wrap::repeat;
    Wrap wrap_v = Wrap::repeat;
    Filter magnify = Filter::linear;
    Filter minify = Filter::linear; ///< without the file's wishes as to mip maps
    bool srgb = false;              ///< RGB holds sRGB values, as colours do; alpha never does
};

/// The use of a texture.  Channels are glTF's.
enum class TextureUse : std::uint8_t {
    base_color,                 ///< RGB; A: alpha
    metallic_roughness,         ///< G: roughness, B: metallic
    normal,                     ///< RGB: 2 c - 1, in the frame of tangent, bitangent and normal
    occlusion,                  ///< R
    emission,                   ///< RGB
    transmission,               ///< R
    thickness,                  ///< G
    specular,                   ///< A
    specular_color,             ///< RGB
    clearcoat,                  ///< R
    clearcoat_roughness,        ///< G
    clearcoat_normal,           ///< as normal
    sheen_color,                ///< RGB
    sheen_roughness,            ///< A
    anisotropy,                 ///< RG: 2 c - 1, the direction; B: strength
    diffuse_transmission,       ///< A
    diffuse_transmission_color, ///< RGB
};

/// A texture of a material.
struct TextureSlot {
    TextureUse use = TextureUse::base_color;
    std::uint32_t image = 0;  ///< index in Scene::images
    std::uint32_t uv_set = 0; ///< index in VertexAttributes::uv
    Sampler sampler;
    glm::mat3x2 uv_transform{1, 0, 0, 1, 0, 0}; ///< of (u, v, 1), as KHR_texture_transform has it
    float strength = 1.0f; ///< normals: factor of x and y; occlusion: how much of it
};

/// Returns the slot for `use`; null if there is none.
const TextureSlot* find_texture(const std::vector<TextureSlot>& slots, TextureUse use);

/// Moves the pixels of a texture that has some into a cache.  Throws InputError as
/// TextureCache::add does.  One thread.
void move_to_cache(TextureImage& image, const std::shared_ptr<TextureCache>& cache);

/// Returns a copy of a texture with all pixels in memory.  Throws InputError if they cannot be
/// read.
TextureImage in_memory(const TextureImage& image);

/// Returns a hash of the pixels, wherever they are.  Linear in the pixels of a
/// texture that is in memory.
PixelDigest pixel_digest(const TextureImage& image);

/// Returns whether some pixel has an alpha below 255.  Cost: as pixel_digest.
bool has_alpha(const TextureImage& image);

/// Returns the bytes that the pixels of all textures of a scene take, and those of them that memory
/// holds at most.
struct TextureBytes {
    std::uint64_t all = 0, in_memory = 0;
};
TextureBytes bytes_of_textures(const std::vector<TextureImage>& images);

/// Samples a texture at `uv`, (0, 0) its top left corner and (1, 1) its bottom right one: linear
/// RGB and alpha in [0, 1].  Bilinear between the middles of pixels, after sRGB values are made
/// linear; or the pixel that holds the point, if sampler.magnify says nearest. A coordinate that is
/// not finite counts as 0; a texture without pixels is white.  Throws InputError if a cache cannot
/// read its file.  Thread-safe.
glm::vec4 sample_texture(const TextureImage& image, const Sampler& sampler, glm::vec2 uv);

/// Returns whether all numbers of a transform of texture coordinates are finite.
bool is_finite_transform(const glm::mat3x2& m);

} // namespace hipmap
