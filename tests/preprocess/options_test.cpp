#include "common/file/output_file.h"
#include "common/input_error.h"
#include "preprocess/options.h"
#include "preprocess/summary.h"
#include "tests/support/tiny_meshes.h"

#include <CLI/CLI.hpp>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <unistd.h>

using namespace hipmap;

namespace {

/// The arguments as parsed; throws what CLI11 throws.
PreprocessArguments parse(const std::string& line)
{
    PreprocessArguments arguments;
    CLI::App app("", "preprocess");
    add_arguments(app, arguments);
    app.parse(line);
    return arguments;
}

} // namespace

TEST_CASE("preprocess options: every option arrives", "[preprocess]")
{
    const PreprocessArguments a =
        parse("desk.glb -o desk.hpm --angle 45.5 --split both --weld 1e-3 --images out --json "
              "desk.json --coloured maps.glb --size 640x360 "
              "--photons 300000 --neighbours 25 --camera Top --exclude Cutter --exclude Helper "
              "--light-units raw --threads 3");
    CHECK(a.scene == "desk.glb");
    CHECK(a.output == "desk.hpm");
    CHECK(a.angle_deg == 45.5);
    CHECK(a.split == SplitBy::both);
    CHECK(a.weld_metres == 1e-3);
    CHECK(a.photons == 300'000u);
    CHECK(a.neighbours == 25);
    CHECK(a.images == "out");
    CHECK(a.json == "desk.json");
    CHECK(a.coloured == "maps.glb");
    CHECK(a.size.width == 640);
    CHECK(a.size.height == 360);
    CHECK(a.scene_options.camera == "Top");
    CHECK(a.scene_options.exclude == std::vector<std::string>{"Cutter", "Helper"});
    CHECK(a.scene_options.light_units == LightUnits::raw);
    CHECK(a.threads == 3);
}

TEST_CASE("preprocess options: a frame has its moment and files of its own", "[preprocess]")
{
    const PreprocessArguments all =
        parse("desk.glb -o a.b/desk.hpm --json desk.json --images out --frames 7:9 --fps 10");
    CHECK(all.frames.first == 7);
    CHECK(all.frames.last == 9);
    const PreprocessArguments a = arguments_of_frame(all, 8);
    CHECK(a.scene_options.time == 0.8);
    CHECK(a.output == "a.b/desk.0008.hpm");
    CHECK(a.json == "desk.0008.json");
    CHECK(a.images == "out.0008");
    CHECK(a.coloured.empty());
    CHECK(frame_path("a/noon", 123456) == "a/noon.123456");
}

TEST_CASE("preprocess options: defaults", "[preprocess]")
{
    const PreprocessArguments a = parse("-o desk.hpm desk.glb");
    CHECK(a.angle_deg == 30);
    CHECK(a.split == SplitBy::angle);
    CHECK(a.weld_metres == 0);
    CHECK(a.size.width == 768);
    CHECK(a.size.height == 0);
    CHECK(a.images.empty());
}

TEST_CASE("preprocess options: what makes no sense is refused", "[preprocess]")
{
    for (const char* line :
         {"desk.glb", "-o desk.hpm", "desk.glb -o desk.hpm --angle nan",
          "desk.glb -o desk.hpm --angle inf", "desk.glb -o desk.hpm --angle 180.5",
          "desk.glb -o desk.hpm --angle 1e999", "desk.glb -o desk.hpm --size 0x4",
          "desk.glb -o desk.hpm --threads -1", "desk.glb -o desk.hpm more.glb"})
        CHECK_THROWS_AS(parse(line), CLI::ParseError);
}

TEST_CASE("check_outputs: no file is written over the scene or over another output", "[preprocess]")
{
    const auto folder = std::filesystem::temp_directory_path() /
                        ("hipmap_options_test_" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder);
    write_file(folder / "a.glb", std::string_view("scene"));
    PreprocessArguments a;
    a.scene = folder / "a.glb";
    a.output = folder / "a.hpm";
    CHECK_NOTHROW(check_outputs(a));
    a.json = folder / "." / "a.hpm";
    CHECK_THROWS_AS(check_outputs(a), InputError);
    a.json.clear();
    a.output = folder / "." / "a.glb";
    CHECK_THROWS_AS(check_outputs(a), InputError);
    a.output = folder / "a.hpm";
    a.images = folder / "a.glb"; // a file
    CHECK_THROWS_AS(check_outputs(a), InputError);
    a.images = folder / "none" / "pictures";
    CHECK_THROWS_AS(check_outputs(a), InputError);
    a.images = folder / "pictures";
    CHECK_NOTHROW(check_outputs(a));
    CHECK_FALSE(std::filesystem::exists(a.images));
    std::filesystem::remove_all(folder);
}

TEST_CASE("summary: areas in square metres, a sentence for every defect", "[preprocess]")
{
    Scene scene = tiny::make_scene(tiny::together(tiny::degenerate(), tiny::flipped_pair()));
    for (std::size_t v = 5; v < scene.mesh.positions.size(); ++v)
        scene.mesh.positions[v].z = 1;
    scene.frame.metres_per_unit = 4;
    scene.mesh.object_names = {"desk"};
    scene.materials[0].name = "oak";
    const auto [partition, summary] = build_partition(scene, {});
    PreprocessArguments arguments = parse("desk.glb -o desk.hpm");
    arguments.scene = "bad utf-8 \xff";

    LegendEntry scale{std::vector<Rgb>(96), "reach"};
    scale.colours.back() = Rgb(1);
    const std::vector<LegendedPicture> pictures{{"a.png", 12, 8, {scale, {{}, "words"}}}};
    const auto json =
        nlohmann::json::parse(summary_json(arguments, scene, partition, summary, pictures));
    REQUIRE(json["pictures"].size() == 1);
    CHECK(json["pictures"][0]["height"] == 8);
    const auto colours = json["pictures"][0]["legend"][0]["colours"];
    REQUIRE(colours.size() == 16);
    CHECK(colours[0] == "#000000");
    CHECK(colours[14] == "#000000");
    CHECK(colours[15] == "#ffffff");
    CHECK(json["pictures"][0]["legend"][1]["colours"].empty());
    CHECK(json["faces"] == 6);
    CHECK(json["shared_maps"] == 2);
    CHECK(json["groups"] == 0);
    CHECK(json["grouped_faces"] == 0);
    REQUIRE(json["maps"].size() == 2);
    CHECK(json["maps"][0]["area_m2"].get<double>() == Approx(16));
    CHECK(json["maps"][0]["objects"] == nlohmann::json{"desk"});
    CHECK(json["maps"][1]["materials"] == nlohmann::json{"oak"});
    CHECK(json["edges"]["connected"] == 2);
    CHECK(json["edges"]["border"] == 8);
    CHECK(json["defects"]["degenerate_faces"] == 2);
    CHECK(json["seconds"].contains("share maps"));
    CHECK(describe_defects(summary).size() == 2);
    CHECK(describe_defects({}).empty());
    CHECK(describe(summary, 30).size() == 4);
}
