#include "common/scene/gltf_specular_glossiness.h"
#include "tests/common/scene/append_bytes.h"
#include "tests/common/scene/tiny_gltf_file.h"

#include <catch2/catch.hpp>
#include <stb/stb_image_write.h>

namespace hipmap::tiny {

namespace {

GltfFile glossy(const json& values)
{
    GltfFile file = tetrahedron_file();
    file.root["extensionsRequired"] = {kSpecularGlossiness};
    file.root["extensionsUsed"] = {kSpecularGlossiness};
    file.root["materials"][0]["pbrMetallicRoughness"] = {{"baseColorFactor", {0, 1, 0, 1}}};
    file.root["materials"][0]["extensions"][kSpecularGlossiness] = values;
    return file;
}

/// One pixel, as an image of the file.
void add_pixel(GltfFile& file, const std::array<unsigned char, 4>& rgba)
{
    std::string png;
    stbi_write_png_to_func(append_bytes, &png, 1, 1, 4, rgba.data(), 4);
    const int accessor =
        file.add_accessor(std::vector<char>(png.begin(), png.end()), "SCALAR", 1, 5121);
    file.root["images"] = {{{"bufferView", file.root["accessors"][accessor]["bufferView"]},
                            {"mimeType", "image/png"}}};
    file.root["textures"] = {{{"source", 0}}};
}

} // namespace

TEST_CASE("specular-glossiness: factors become those of a dielectric", "[scene][material]")
{
    const LoadedScene loaded = load(glossy({{"diffuseFactor", {0.5, 0.25, 0.125, 0.75}},
                                            {"specularFactor", {0.04, 0.5, 1}},
                                            {"glossinessFactor", 0.75}}));
    const Material& material = loaded.scene.materials.at(0);
    CHECK(material.base_color == Rgb(0.5f, 0.25f, 0.125f));
    CHECK(material.alpha == 0.75f);
    CHECK(material.metallic == 0);
    CHECK(material.roughness == 0.25f);
    const float step = (material.ior - 1) / (material.ior + 1);
    CHECK(step * step * material.specular_color.x * material.specular ==
          Approx(0.04).epsilon(1e-3));
    CHECK(step * step * material.specular_color.z == Approx(1).epsilon(1e-3));
    CHECK(loaded.audit.warnings.empty());
}

TEST_CASE("specular-glossiness: without values it is a white mirror over white",
          "[scene][material]")
{
    const Material material = load(glossy(json::object())).scene.materials.at(0);
    CHECK(material.base_color == Rgb(1));
    CHECK(material.specular_color == Rgb(1));
    CHECK(material.roughness == 0);
    CHECK_THROWS_AS(load(glossy({{"specularFactor", 1}})), InputError);
}

TEST_CASE("specular-glossiness: one texture gives specular colour and roughness",
          "[scene][material]")
{
    GltfFile file = glossy({{"glossinessFactor", 0.5},
                            {"diffuseTexture", {{"index", 0}}},
                            {"specularGlossinessTexture", {{"index", 0}}}});
    add_pixel(file, {10, 20, 30, 204});
    const LoadedScene loaded = load(file);
    const Material& material = loaded.scene.materials.at(0);
    REQUIRE(find_texture(material.textures, TextureUse::base_color) != nullptr);
    CHECK(find_texture(material.textures, TextureUse::specular_color)->sampler.srgb);
    const TextureSlot* const rough =
        find_texture(material.textures, TextureUse::metallic_roughness);
    REQUIRE(rough != nullptr);
    CHECK(loaded.scene.images[rough->image].rgba[1] == 153); // 255 (1 - 0.5 * 204 / 255)
    CHECK(material.roughness == 1);
    CHECK(loaded.audit.warnings.empty());
}

} // namespace hipmap::tiny
