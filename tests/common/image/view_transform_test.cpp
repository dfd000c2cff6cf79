#include "common/file/output_file.h"
#include "common/image/blender_config.h"
#include "common/image/read_image.h"
#include "common/image/view_transform.h"
#include "common/input_error.h"
#include "tests/support/temporary_folder.h"

#include <catch2/catch.hpp>

#include <filesystem>

using namespace hipmap;
using Catch::Contains;

namespace {

namespace fs = std::filesystem;

/// A view that halves, and one that leaves everything as it is.
constexpr const char* kConfig = R"(ocio_profile_version: 2
strictparsing: true
roles: {default: Linear Rec.709, scene_linear: Linear Rec.709}
file_rules:
  - !<Rule> {name: Default, colorspace: default}
displays:
  screen:
    - !<View> {name: Half, colorspace: half}
    - !<View> {name: Plain, colorspace: Linear Rec.709}
colorspaces:
  - !<ColorSpace> {name: Linear Rec.709}
  - !<ColorSpace>
    name: half
    from_reference: !<MatrixTransform> {matrix: [0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 1]}
)";

std::string replaced(std::string text, const std::string& what, const std::string& with)
{
    for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += with.size())
        text.replace(at, what.size(), with);
    return text;
}

} // namespace

TEST_CASE("view transform: none asked for is none", "[image][view]")
{
    CHECK(!make_view({}));
    CHECK_THROWS_WITH(make_view({"", "Filmic"}), Contains("--ocio"));
}

TEST_CASE("view transform: Blender's newest configuration is found beside its program",
          "[image][view]")
{
    const TemporaryFolder folder;
    const std::vector<fs::path> places = {folder / "none", folder / "blender"};
    CHECK_THROWS_WITH(find_blender_config(places), Contains("config.ocio"));
    for (const char* version : {"3.6", "4.10", "4.2", "scripts"}) {
        const fs::path at = folder / "blender" / version / "datafiles/colormanagement";
        fs::create_directories(at);
        write_file(at / "config.ocio", "");
    }
    CHECK(find_blender_config(places) ==
          folder / "blender" / "4.10/datafiles/colormanagement/config.ocio");
}

#ifdef HIPMAP_OPENCOLORIO

TEST_CASE("view transform: the default view and those named are applied after the exposure",
          "[image][view]")
{
    const TemporaryFolder folder;
    const std::string config = folder / "config.ocio";
    write_file(config, kConfig);
    Image image(2, 1);
    image.pixels = {Rgb(0.1f, 0.2f, 0.4f), Rgb(1, 0, 0.6f)};
    for (const auto& [view, factor] : {std::pair("", 1.0), std::pair("Plain", 2.0)}) {
        write_image(folder / "a.ppm", image, {1, make_view({config, view})});
        const std::vector<std::byte> bytes = read_file(folder / "a.ppm");
        for (std::size_t i = 0; i < 6; ++i) {
            const double value =
                std::min(1.0, factor * double{image.pixels[i / 3][static_cast<int>(i % 3)]});
            CHECK(std::to_integer<int>(bytes[bytes.size() - 6 + i]) ==
                  static_cast<int>(255 * value + 0.5));
        }
    }
}

TEST_CASE("view transform: what is wrong with a configuration is one line", "[image][view]")
{
    const TemporaryFolder folder;
    const std::string config = folder / "config.ocio";
    write_file(config, kConfig);
    CHECK_THROWS_WITH(make_view({config, "Filmic"}),
                      Contains("config.ocio") && Contains("no view 'Filmic', but 'Half', 'Plain'"));
    CHECK_THROWS_AS(make_view({folder / "none.ocio", ""}), InputError);
    write_file(config, replaced(kConfig, "Linear Rec.709", "camera"));
    CHECK_THROWS_WITH(make_view({config, ""}), Contains("no linear Rec. 709"));
    write_file(config, "no configuration");
    CHECK_THROWS_AS(make_view({config, ""}), InputError);
}

#else

TEST_CASE("view transform: a build without OpenColorIO says so", "[image][view]")
{
    CHECK_THROWS_WITH(make_view({"blender", ""}), Contains("libopencolorio-dev"));
}

#endif
