#include "common/input_error.h"
#include "common/scene/fingerprint.h"
#include "common/scene/ies_file.h"
#include "tests/common/scene/tiny_gltf_file.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

namespace hipmap::tiny {

namespace {

/// A file whose lines after TILT are `numbers`.
std::string ies(const std::string& numbers, const std::string& tilt = "NONE")
{
    return "IESNA:LM-63-2002\n[TEST] by hand\n[MORE] TILT= is below\nTILT=" + tilt + "\n" + numbers;
}

/// Two polar angles; intensities are the azimuth's number, from 1, and ten times that.
std::string with_azimuths(const std::vector<int>& azimuths)
{
    std::string angles, intensities;
    for (std::size_t i = 0; i < azimuths.size(); ++i) {
        angles += std::to_string(azimuths[i]) + " ";
        intensities += std::to_string(i + 1) + " " + std::to_string(10 * (i + 1)) + "\n";
    }
    return ies("1 -1 1 2 " + std::to_string(azimuths.size()) + " 1 2 0 0 0\n1 1 0\n0 90\n" +
               angles + "\n" + intensities);
}

PhotometricWeb read_text(const std::string& text)
{
    const TemporaryFolder folder;
    write_text(folder / "lamp.ies", text);
    return read_ies(folder / "lamp.ies");
}

/// Degrees and intensities at the polar angle 0, which go around.
void check_around(const std::vector<int>& azimuths, const std::vector<double>& degrees,
                  const std::vector<double>& candela)
{
    const PhotometricWeb web = read_text(with_azimuths(azimuths));
    REQUIRE(web.azimuth.size() == degrees.size());
    REQUIRE(web.candela.size() == 2 * degrees.size());
    for (std::size_t i = 0; i < degrees.size(); ++i) {
        CHECK(web.azimuth[i] == Approx(degrees[i] * std::numbers::pi / 180));
        CHECK(web.candela[i] == candela[i]);
        CHECK(web.candela[degrees.size() + i] == 10 * candela[i]);
    }
}

/// A tetrahedron under a light of kind `type`, turned by a quarter about x so that its -Z points
/// down, with extras.
GltfFile under_light(const char* type, const json& extras)
{
    GltfFile file = tetrahedron_file();
    file.root["extensions"]["KHR_lights_punctual"]["lights"] = {
        {{"type", type}, {"intensity", 5}, {"color", {1, 0.5, 0}}, {"spot", json::object()}}};
    const double half = std::sqrt(0.5);
    file.root["nodes"].push_back({{"name", "Lamp"},
                                  {"translation", {0, 2, 0}},
                                  {"rotation", {-half, 0, 0, half}},
                                  {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}},
                                  {"extras", {{"hipmap", extras}}}});
    file.root["scenes"][0]["nodes"] = {0, 1};
    return file;
}

LoadedScene load_beside(const GltfFile& file, const std::string& profile)
{
    const TemporaryFolder folder;
    write_text(folder / "lamp.ies", profile);
    write_text(folder / "scene.glb", file.glb());
    return load_scene(folder / "scene.glb", {});
}

} // namespace

TEST_CASE("ies: intensities are read with their factors", "[scene][ies]")
{
    const PhotometricWeb web =
        read_text(ies("1 1000 2 3 1 1 2 0.1 0.2 0.3\n0.5 1.5 60\n0 30 90\n0\n100 +80 2e1\n"));
    REQUIRE(web.polar.size() == 3);
    CHECK(web.polar[1] == Approx(std::numbers::pi / 6));
    CHECK(web.polar[2] == Approx(std::numbers::pi / 2));
    CHECK(web.azimuth == std::vector<double>{0, 2 * std::numbers::pi});
    const std::vector<double> expected = {150, 150, 120, 120, 30, 30};
    for (std::size_t i = 0; i < expected.size(); ++i)
        CHECK(web.candela.at(i) == Approx(expected[i]));
}

TEST_CASE("ies: planes of symmetry are filled in", "[scene][ies]")
{
    check_around({0}, {0, 360}, {1, 1});
    check_around({0, 90}, {0, 90, 180, 270, 360}, {1, 2, 1, 2, 1});
    check_around({0, 30, 90}, {0, 30, 90, 150, 180, 210, 270, 330, 360},
                 {1, 2, 3, 2, 1, 2, 3, 2, 1});
    check_around({0, 60, 180}, {0, 60, 180, 300, 360}, {1, 2, 3, 2, 1});
    check_around({0, 120, 240, 360}, {0, 120, 240, 360}, {1, 2, 3, 4});
    check_around({0, 120, 240}, {0, 120, 240, 360}, {1, 2, 3, 1});
}

TEST_CASE("ies: tilt factors are skipped, commas and other ends of lines accepted", "[scene][ies]")
{
    const PhotometricWeb web =
        read_text(ies("1\r\n2\r\n0 90\r\n1 0.5\r\n1,-1,1,2,1,1,2,0,0,0\r\n1,1,0\r\n0,90\r\n0\r\n7,"
                      "3",
                      "INCLUDE\r"));
    CHECK(web.candela == std::vector<double>{7, 7, 3, 3});
}

TEST_CASE("ies: a file that makes no sense is refused with the line and what is wrong",
          "[scene][ies][damaged]")
{
    const std::string good = "1 -1 1 2 1 1 2 0 0 0\n1 1 0\n0 90\n0\n5 4\n";
    CHECK_NOTHROW(read_text(ies(good)));
    const std::pair<std::string, std::string> bad[] = {
        {"", "no line TILT="},
        {"glTF\0\1", "no line TILT="},
        {ies(good, "lamp.tlt"), "line 5: TILT names another file"},
        {ies(""), "where the number of lamps belongs"},
        {ies("1 -1 1 2 1 1 2 0 0 0\n1 1 0\n0 90\n0\n5\n"), "where an intensity belongs"},
        {ies("1 -1 1 2 1 1 2 0 0 0\n1 1 0\n0 x\n0\n5 4\n"), "line 7: no number"},
        {ies("1 -1 1 2 1 3 2 0 0 0\n1 1 0\n0 90\n0\n5 4\n"), "line 5: photometry of type A or B"},
        {ies("1 -1 1 99999999 1 1 2 0 0 0\n"), "the number of vertical angles"},
        {ies("1 -1 1 2 1e300 1 2 0 0 0\n"), "the number of horizontal angles"},
        {ies("1 -1 1 1 1 1 2 0 0 0\n1 1 0\n0\n0\n5\n"), "the number of vertical angles"},
        {ies("1 -1 1 2.5 1 1 2 0 0 0\n1 1 0\n0 90\n0\n5 4\n"), "the number of vertical angles"},
        {ies("1 -1 0 2 1 1 2 0 0 0\n1 1 0\n0 90\n0\n5 4\n"), "must be above 0"},
        {ies("1 -1 1 2 1 1 2 0 0 0\n1 1 0\n90 0\n0\n5 4\n"), "line 7: a vertical angle"},
        {ies("1 -1 1 2 1 1 2 0 0 0\n1 1 0\n0 181\n0\n5 4\n"), "a vertical angle"},
        {ies("1 -1 1 2 1 1 2 0 0 0\n1 1 0\n0 1e-300\n0\n5 4\n"), "a vertical angle"},
        {ies("1 -1 1 2 1 1 2 0 0 0\n1 1 0\n0 90\n10\n5 4\n"), "horizontal angles must go"},
        {ies("1 -1 1 2 2 1 2 0 0 0\n1 1 0\n0 90\n0 45\n5 4 3 2\n"), "horizontal angles must go"},
        {ies("1 -1 1 2 1 1 2 0 0 0\n1 1 0\n0 90\n0\n5 -4\n"), "line 9: an intensity"},
        {ies("1 -1 1 2 1 1 2 0 0 0\n1 1 0\n0 90\n0\n5 1e39\n"), "an intensity"},
        {ies("1 -1 1 2 1 1 2 0 0 0\n1 1 0\n0 90\n0\n5 nan\n"), "line 9: no number"},
        {ies("1 -1 1 2 1 1 2 0 0 0\n1 1 0\n0 90\n0\n0 0\n"), "all intensities are 0"}};
    for (const auto& [text, what] : bad) {
        INFO(text);
        CHECK_THROWS_AS(read_text(text), InputError);
        CHECK_THROWS_WITH(read_text(text), Catch::Contains("lamp.ies") && Catch::Contains(what));
    }
}

TEST_CASE("ies: a point light takes its intensities from the file beside the scene", "[scene][ies]")
{
    const LoadedScene loaded =
        load_beside(under_light("point", {{"ies", "lamp.ies"}, {"ies_scale", 2}, {"radius", 0.1}}),
                    with_azimuths({0}));
    const Scene& scene = loaded.scene;
    const auto light = std::get<SceneIesLight>(scene.lights.at(0));
    CHECK(light.name == "Lamp");
    // The polar angle 0 is along the node's -Z, the azimuth 0 along its -Y.
    CHECK(glm::length(light.direction - glm::dvec3(0, -1, 0)) < 1e-6);
    CHECK(glm::length(light.start - glm::dvec3(0, 0, 1)) < 1e-6);
    const double unit = scene.frame.metres_per_unit;
    CHECK(light.intensity.x * unit * unit == Approx(2 / 683.0));
    CHECK(light.intensity.y == Approx(0.5 * light.intensity.x));
    CHECK(light.intensity.z == 0);
    CHECK(light.web.candela == std::vector<double>{1, 1, 10, 10});
    CHECK(says(loaded.audit.found, "IES light 'Lamp'"));
    CHECK(says(loaded.audit.assumed, "light 'Lamp': radius not used"));
    const Scene other = load_beside(under_light("point", {{"ies", "lamp.ies"}, {"ies_scale", 2}}),
                                    ies("1 -1 1 2 1 1 2 0 0 0\n1 1 0\n0 90\n0\n1 11\n"))
                            .scene;
    CHECK(content_fingerprint(other) != content_fingerprint(scene));
}

TEST_CASE("ies: extras that make no sense are refused", "[scene][ies][damaged]")
{
    const std::string profile = with_azimuths({0});
    for (const char* type : {"spot", "directional"})
        CHECK_THROWS_WITH(load_beside(under_light(type, {{"ies", "lamp.ies"}}), profile),
                          Catch::Contains("light 'Lamp'") && Catch::Contains("'ies'"));
    CHECK_THROWS_WITH(load_beside(under_light("point", {{"ies", "other.ies"}}), profile),
                      Catch::Contains("light 'Lamp'") && Catch::Contains("'other.ies'"));
    CHECK_THROWS_WITH(load_beside(under_light("point", {{"ies_scale", 2}}), profile),
                      Catch::Contains("'ies_scale'"));
    GltfFile flat = under_light("point", {{"ies", "lamp.ies"}});
    flat.root["nodes"][1]["scale"] = {1, 0, 1};
    CHECK_THROWS_WITH(load_beside(flat, profile), Catch::Contains("scale"));
}

} // namespace hipmap::tiny
