#include "tests/common/scene/append_bytes.h"
#include "tests/support/gltf_file.h"
#include "tests/support/temporary_folder.h"

#include <catch2/catch.hpp>
#include <stb/stb_image_write.h>

#include <algorithm>
#include <cmath>

namespace hipmap::tiny {

namespace {

/// A PNG of one row of grey or coloured pixels.
std::string png_of(const std::vector<unsigned char>& rgba)
{
    std::string png;
    const int width = static_cast<int>(rgba.size() / 4);
    stbi_write_png_to_func(append_bytes, &png, width, 1, 4, rgba.data(), 4 * width);
    return png;
}

/// A square with texture coordinates and its material, beside textures of two and of one pixel.
/// head: first line of the material's file.
LoadedScene load_textured(const std::string& mtl, const std::string& head = "")
{
    static const TemporaryFolder folder;
    write_text(folder / "two.png", png_of({255, 0, 0, 255, 0, 255, 0, 255}));
    write_text(folder / "grey.png", png_of({51, 51, 51, 255}));
    write_text(folder / "normals.png", png_of({204, 128, 229, 255}));
    write_text(folder / "scene.mtl", head + "newmtl m\n" + mtl);
    write_text(folder / "scene.obj", "mtllib scene.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
                                     "vt 0 0\nvt 1 0\nvt 1 0.75\nvt 0 1\nusemtl m\n"
                                     "f 1/1 2/2 3/3 4/4\n");
    return load_scene(folder / "scene.obj", {});
}

const TextureImage& image_of(const LoadedScene& loaded, TextureUse use)
{
    const TextureSlot* const slot = find_texture(loaded.scene.materials.at(0).textures, use);
    REQUIRE(slot != nullptr);
    return loaded.scene.images.at(slot->image);
}

} // namespace

TEST_CASE("MTL textures: map_Kd is the base colour, with v downwards", "[scene][obj]")
{
    const LoadedScene loaded = load_textured("Kd 0.5 0.5 0.5\nmap_Kd two.png\n");
    const Scene& scene = loaded.scene;
    CHECK(loaded.audit.warnings.empty());
    CHECK(scene.materials[0].base_color == Rgb(0.5f));
    CHECK(scene.materials[0].textures.at(0).sampler.srgb);
    CHECK(image_of(loaded, TextureUse::base_color).width == 2);
    CHECK(scene.mesh.attributes.uv[0] ==
          std::vector<glm::vec2>{{0, 1}, {1, 1}, {1, 0.25f}, {0, 0}});
    CHECK(load_textured("Kd 0 0 0\nmap_Kd two.png\n").scene.materials[0].base_color == Rgb(1));
    CHECK(load_textured("map_Kd two.png\n").scene.materials[0].base_color == Rgb(1));
}

TEST_CASE("MTL textures: scale and offset count from the lower left", "[scene][obj]")
{
    const LoadedScene loaded = load_textured("Kd 1 1 1\nmap_Kd -s 2 4 1 -o 0.25 0.5 0 two.png\n");
    const TextureSlot& slot = loaded.scene.materials[0].textures.at(0);
    // (u, v upwards) = (0.5, 0.25) is (0.5, 0.75) downwards, and becomes (1.25, 1.5) upwards.
    const glm::vec2 at = slot.uv_transform * glm::vec3(0.5f, 0.75f, 1);
    CHECK(at.x == Approx(1.25));
    CHECK(at.y == Approx(1 - 1.5));
}

TEST_CASE("MTL textures: opacity joins the base colour's alpha", "[scene][obj]")
{
    const LoadedScene loaded = load_textured("Kd 1 1 1\nmap_Kd two.png\nmap_d grey.png\n");
    const TextureImage& image = image_of(loaded, TextureUse::base_color);
    CHECK(image.rgba == std::vector<std::uint8_t>{255, 0, 0, 51, 0, 255, 0, 51});
    CHECK(loaded.scene.materials[0].alpha_mode == AlphaMode::blend);
    const LoadedScene alone = load_textured("Kd 1 1 1\nmap_d grey.png\n");
    CHECK(image_of(alone, TextureUse::base_color).rgba ==
          std::vector<std::uint8_t>{255, 255, 255, 51});
}

TEST_CASE("MTL textures: roughness and metallic share one, emission and normals have theirs",
          "[scene][obj]")
{
    const LoadedScene loaded =
        load_textured("Kd 1 1 1\nmap_Pr grey.png\nmap_Pm two.png\nmap_Ke two.png\nnorm two.png\n");
    CHECK(image_of(loaded, TextureUse::metallic_roughness).rgba ==
          std::vector<std::uint8_t>{255, 51, 255, 255});
    const Material& material = loaded.scene.materials[0];
    CHECK(material.roughness == 1);
    CHECK(material.metallic == 1);
    CHECK(material.emission == Rgb(1));
    CHECK_FALSE(find_texture(material.textures, TextureUse::normal)->sampler.srgb);
    CHECK(loaded.scene.images.size() == 3); // each file once, and what was joined
}

TEST_CASE("MTL textures: a path of another machine means the file of that name", "[scene][obj]")
{
    CHECK(load_textured("Kd 1 1 1\nmap_Kd C:\\art\\two.png\n").scene.images.size() == 1);
    const LoadedScene lost = load_textured("Kd 1 1 1\nmap_Kd ../../gone.png\n");
    CHECK(lost.scene.images.empty());
    CHECK(lost.audit.warnings.at(0).find("'../../gone.png' cannot be read") != std::string::npos);
    const LoadedScene unread = load_textured("Kd 1 1 1\ndisp grey.png\n");
    CHECK(unread.audit.warnings.at(0).find("disp of materials ('m')") != std::string::npos);
}

TEST_CASE("MTL textures: exponents become roughness, of Blender they are roughness", "[scene][obj]")
{
    const std::string shiny = "Kd 1 1 1\nKs 0.5 0.5 0.5\nNs 100\nmap_Ns grey.png\n";
    const LoadedScene loaded = load_textured(shiny);
    const double rough = std::pow(2 / (51.0 / 255 * 100 + 2), 0.25);
    CHECK(image_of(loaded, TextureUse::metallic_roughness).rgba ==
          std::vector<std::uint8_t>{255, static_cast<std::uint8_t>(std::lround(255 * rough)), 255,
                                    255});
    CHECK(loaded.scene.materials[0].roughness == 1);
    CHECK(loaded.audit.warnings.empty());
    const LoadedScene blender = load_textured(shiny, "# Blender 3.4.1 MTL File: 'None'\n");
    CHECK(image_of(blender, TextureUse::metallic_roughness).rgba.at(1) == 51);
    const LoadedScene matte = load_textured("Kd 1 1 1\nKs 0 0 0\nmap_Ns grey.png\n");
    CHECK(matte.audit.warnings.at(0).find("map_Ns of materials ('m')") != std::string::npos);
}

TEST_CASE("MTL textures: a bump map is a height map or a normal map, as its colours say",
          "[scene][obj]")
{
    const LoadedScene flat = load_textured("Kd 1 1 1\nmap_Bump -bm 0.5 grey.png\n");
    CHECK(image_of(flat, TextureUse::normal).rgba == std::vector<std::uint8_t>{128, 128, 255, 255});
    const std::string note = "map_Bump of materials ('m') is heights: white is 1 % of";
    CHECK(std::ranges::any_of(flat.audit.assumed, [&](const std::string& sentence) {
        return sentence.starts_with(note);
    }));
    const LoadedScene tilted = load_textured("Kd 1 1 1\nmap_Bump -bm 0.5 normals.png\n");
    const TextureSlot* const slot =
        find_texture(tilted.scene.materials.at(0).textures, TextureUse::normal);
    REQUIRE(slot != nullptr);
    CHECK(slot->strength == 0.5f);
    CHECK(tilted.scene.images.at(slot->image).name == "normals.png");
    const LoadedScene both = load_textured("Kd 1 1 1\nmap_Bump grey.png\nnorm normals.png\n");
    CHECK(image_of(both, TextureUse::normal).name == "normals.png");
}

} // namespace hipmap::tiny
