#include "common/input_error.h"
#include "tests/common/scene/append_bytes.h"
#include "tests/common/scene/tiny_gltf_file.h"

#include <catch2/catch.hpp>
#include <stb/stb_image_write.h>

#include <cmath>

namespace hipmap::tiny {

namespace {

/// Two pixels, red and half-clear green.
std::string two_pixel_png()
{
    const unsigned char rgba[] = {255, 0, 0, 255, 0, 255, 0, 128};
    std::string png;
    stbi_write_png_to_func(append_bytes, &png, 2, 1, 4, rgba, 8);
    return png;
}

std::string grey_jpeg(int size)
{
    const std::vector<unsigned char> rgb(static_cast<std::size_t>(3 * size * size), 128);
    std::string jpeg;
    stbi_write_jpg_to_func(append_bytes, &jpeg, size, size, 3, rgb.data(), 95);
    return jpeg;
}

std::string base64(const std::string& bytes)
{
    const char* const digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        unsigned int word = 0;
        for (std::size_t k = 0; k < 3; ++k)
            word =
                word << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0);
        for (std::size_t k = 0; k < 4; ++k)
            text += i + k > bytes.size() ? '=' : digits[word >> (18 - 6 * k) & 63];
    }
    return text;
}

/// A tetrahedron with the material; texture 0 shows the texture, which lies in the buffer.
GltfFile textured(const json& material, const std::string& picture)
{
    GltfFile file = tetrahedron_file();
    file.root["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", file.bytes.size()}, {"byteLength", picture.size()}});
    file.bytes += picture;
    file.bytes.resize((file.bytes.size() + 3) / 4 * 4);
    file.root["images"] = {
        {{"name", "tiles"}, {"bufferView", file.root["bufferViews"].size() - 1}}};
    file.root["textures"] = {{{"source", 0}}};
    file.root["materials"] = json::array({material});
    return file;
}

json base_texture()
{
    return {{"name", "floor"}, {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}};
}

void check_two_pixels(const Scene& scene)
{
    REQUIRE(scene.images.size() == 1);
    CHECK(scene.images[0].width == 2);
    CHECK(scene.images[0].height == 1);
    CHECK(scene.images[0].rgba == std::vector<std::uint8_t>{255, 0, 0, 255, 0, 255, 0, 128});
}

} // namespace

TEST_CASE("textures are read from the buffer, from base64 and from files beside the scene",
          "[scene][gltf][texture]")
{
    const std::string png = two_pixel_png();
    GltfFile file = textured(base_texture(), png);
    check_two_pixels(load(file).scene);
    file.root["images"][0] = {{"uri", "data:image/png;base64," + base64(png)}};
    check_two_pixels(load(file).scene);

    const TemporaryFolder folder;
    file.root["images"][0] = {{"uri", "my%20tiles.png"}};
    write_text(folder / "my tiles.png", png);
    write_text(folder / "scene.glb", file.glb());
    check_two_pixels(load_scene(folder / "scene.glb", {}).scene);

    const Scene grey = load(textured(base_texture(), grey_jpeg(16))).scene;
    REQUIRE(grey.images.size() == 1);
    CHECK(std::abs(grey.images[0].rgba.at(4 * 100) - 128) <= 2);
    CHECK(grey.images[0].rgba.at(4 * 100 + 3) == 255);
}

TEST_CASE("every slot of a material is read with its use, encoding, strength and sampler",
          "[scene][gltf][texture]")
{
    const json texture = {{"index", 0}};
    json strong = texture, partial = texture;
    strong["scale"] = 0.5;
    partial["strength"] = 0.25;
    GltfFile file =
        textured({{"pbrMetallicRoughness",
                   {{"baseColorTexture", texture}, {"metallicRoughnessTexture", texture}}},
                  {"normalTexture", strong},
                  {"occlusionTexture", partial},
                  {"emissiveTexture", texture},
                  {"extensions",
                   {{"KHR_materials_transmission", {{"transmissionTexture", texture}}},
                    {"KHR_materials_volume", {{"thicknessTexture", texture}}},
                    {"KHR_materials_specular",
                     {{"specularTexture", texture}, {"specularColorTexture", texture}}},
                    {"KHR_materials_clearcoat",
                     {{"clearcoatTexture", texture},
                      {"clearcoatRoughnessTexture", texture},
                      {"clearcoatNormalTexture", strong}}},
                    {"KHR_materials_sheen",
                     {{"sheenColorTexture", texture}, {"sheenRoughnessTexture", texture}}},
                    {"KHR_materials_anisotropy", {{"anisotropyTexture", texture}}},
                    {"KHR_materials_diffuse_transmission",
                     {{"diffuseTransmissionTexture", texture},
                      {"diffuseTransmissionColorTexture", texture}}}}}},
                 two_pixel_png());
    file.root["samplers"] = {
        {{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}, {"minFilter", 9987}}};
    file.root["textures"][0]["sampler"] = 0;
    const Scene scene = load(file).scene;
    CHECK(scene.images.size() == 1); // read once
    const std::vector<TextureSlot>& slots = scene.materials.at(0).textures;
    CHECK(slots.size() == 17);
    for (int use = 0; use < 17; ++use) {
        const TextureSlot* slot = find_texture(slots, static_cast<TextureUse>(use));
        REQUIRE(slot);
        const bool colour =
            slot->use == TextureUse::base_color || slot->use == TextureUse::emission ||
            slot->use == TextureUse::specular_color || slot->use == TextureUse::sheen_color ||
            slot->use == TextureUse::diffuse_transmission_color;
        CHECK(slot->sampler.srgb == colour);
        CHECK(slot->sampler.wrap_u == Wrap::clamp);
        CHECK(slot->sampler.wrap_v == Wrap::mirror);
        CHECK(slot->sampler.magnify == Filter::nearest);
        CHECK(slot->sampler.minify == Filter::linear);
    }
    CHECK(find_texture(slots, TextureUse::normal)->strength == 0.5f);
    CHECK(find_texture(slots, TextureUse::clearcoat_normal)->strength == 0.5f);
    CHECK(find_texture(slots, TextureUse::occlusion)->strength == 0.25f);
    CHECK(find_texture(slots, TextureUse::emission)->strength == 1.0f);
}

TEST_CASE("KHR_texture_transform scales, turns and moves coordinates and may choose their set",
          "[scene][gltf][texture]")
{
    json material = base_texture();
    json& info = material["pbrMetallicRoughness"]["baseColorTexture"];
    info["extensions"]["KHR_texture_transform"] = {{"offset", {10, 20}},
                                                   {"scale", {2, 3}},
                                                   {"rotation", std::acos(-1.0) / 2},
                                                   {"texCoord", 1}};
    GltfFile file = textured(material, two_pixel_png());
    file.root["extensionsRequired"] = {"KHR_texture_transform"};
    const TextureSlot slot = load(file).scene.materials.at(0).textures.at(0);
    CHECK(slot.uv_set == 1);
    // A quarter turn takes +u to -v (up on the texture) and +v to +u.
    const glm::vec2 moved = slot.uv_transform * glm::vec3(0.5f, 0.25f, 1.0f);
    CHECK(moved.x == Approx(10 + 3 * 0.25));
    CHECK(moved.y == Approx(20 - 2 * 0.5));
}

TEST_CASE("an unlit material shows its texture as light", "[scene][gltf][texture]")
{
    json material = base_texture();
    material["extensions"]["KHR_materials_unlit"] = json::object();
    const Material unlit = load(textured(material, two_pixel_png())).scene.materials.at(0);
    CHECK(unlit.unlit);
    CHECK(find_texture(unlit.textures, TextureUse::emission));
    CHECK(find_texture(unlit.textures, TextureUse::base_color));
}

TEST_CASE("textures that cannot be read are warned of by name and leave the plain colour",
          "[scene][gltf][texture][damaged]")
{
    const std::string png = two_pixel_png(), jpeg = grey_jpeg(64);
    std::string bomb = png, empty = png;
    bomb.replace(16, 8, std::string("\x00\x00\xea\x60\x00\x00\xea\x60", 8)); // 60000 x 60000
    std::string wide = png;
    wide.replace(16, 8, std::string("\x00\x00\x3f\xff\x00\x00\x3f\xff", 8)); // within 2^28 pixels
    empty.replace(16, 8, std::string(8, '\0'));
    for (const std::string& picture :
         {bomb, wide, empty, png.substr(0, png.size() / 2), png.substr(0, 20),
          std::string("GIF89a"), jpeg.substr(0, jpeg.size() / 2), jpeg.substr(0, 3),
          std::string(64, 'x')}) {
        const LoadedScene loaded = load(textured(base_texture(), picture));
        CHECK(loaded.scene.images.empty());
        CHECK(loaded.scene.materials.at(0).textures.empty());
        CHECK(says(loaded.audit.warnings, "texture 'tiles'"));
    }
    GltfFile file = textured(base_texture(), png);
    for (const char* uri : {"gone.png", "../up.png", "http://127.0.0.1/a.png", "data:image/png,x",
                            "data:image/png;base64,!!!!", "/dev/zero", "%"}) {
        file.root["images"][0] = {{"uri", uri}};
        INFO(uri);
        CHECK(says(load(file).audit.warnings, "texture 'image 0' cannot be read"));
    }
    file = textured(base_texture(), png);
    file.root["textures"][0].erase("source");
    CHECK(says(load(file).audit.warnings, "no image in a supported format"));
    file = textured(base_texture(), png);
    file.root["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["texCoord"] = 2;
    CHECK(says(load(file).audit.warnings, "TEXCOORD_2"));
}

TEST_CASE("a PNG with any bytes changed is loaded or warned of", "[scene][gltf][texture][damaged]")
{
    const std::string png = two_pixel_png();
    for (std::size_t i = 0; i < png.size(); ++i)
        for (const char value : {'\0', '\x7f', '\xff', '\x01'}) {
            std::string damaged = png;
            damaged[i] = value;
            const LoadedScene loaded = load(textured(base_texture(), damaged));
            CHECK((loaded.scene.images.size() == 1 ||
                   says(loaded.audit.warnings, "texture 'tiles'")));
        }
}

} // namespace hipmap::tiny
