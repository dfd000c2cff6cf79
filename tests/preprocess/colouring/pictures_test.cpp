#include "common/file/output_file.h"
#include "common/image/colour_scale.h"
#include "common/image/srgb.h"
#include "common/partition/limiting_radius.h"
#include "preprocess/colouring/map_colours.h"
#include "preprocess/colouring/painters.h"
#include "preprocess/colouring/partition_pictures.h"
#include "preprocess/partition/build_partition.h"
#include "tests/support/hard_surfaces.h"

#include <catch2/catch.hpp>
#include <tbb/global_control.h>
#include <unistd.h>

using namespace hipmap;

namespace {

/// A quad that fills the middle half of a square picture, both ways, seen head-on.
Scene quad_scene()
{
    Scene scene = tiny::make_scene(tiny::quad());
    scene.cameras[0].projection = Projection::orthographic;
    scene.cameras[0].position = {0.5f, 0.5f, 1};
    scene.cameras[0].half_height = 1;
    return scene;
}

Rgb display(const Rgb& linear)
{
    return {srgb_from_linear(linear.x), srgb_from_linear(linear.y), srgb_from_linear(linear.z)};
}

bool near(const Rgb& a, const Rgb& b)
{
    return glm::length(a - b) < 1e-3f;
}

std::vector<Image> paint(const Scene& scene, int size, const std::vector<Painter>& painters)
{
    const EmbreeScene rays(scene.mesh);
    return colour_images({scene.mesh, rays, scene.cameras[0], size, size}, painters);
}

} // namespace

TEST_CASE("colour_images: a face seen head-on has its painter's colour", "[colouring]")
{
    const Rgb colour(0.1f, 0.5f, 0.9f);
    const std::vector<Image> images =
        paint(quad_scene(), 16, {[&](const SeenPoint&) { return colour; }});
    REQUIRE(images.size() == 1);
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x) {
            const bool inside = x >= 4 && x < 12 && y >= 4 && y < 12;
            CHECK(near(images[0].at(x, y), display(colour)) == inside);
            CHECK(near(images[0].at(x, y), images[0].at(0, 0)) != inside);
        }
}

TEST_CASE("colour_images: the same with one and four threads", "[colouring]")
{
    Scene scene = tiny::make_scene(tiny::uv_sphere(20, 12));
    scene.cameras[0].position = {0.3f, 0.2f, 4};
    const Partition partition = build_partition(scene, {.angle_threshold = 0.4}).partition;
    const auto run = [&](std::size_t threads) {
        const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
        return paint(scene, 40, {paint_maps(partition), paint_edges(scene.mesh, partition)});
    };
    const std::vector<Image> one = run(1);
    const std::vector<Image> four = run(4);
    for (std::size_t i = 0; i < one.size(); ++i)
        CHECK(one[i].pixels == four[i].pixels);
}

TEST_CASE("paint_edges: lines lie on the edges, in the colour of their class", "[colouring]")
{
    const Scene scene = quad_scene();
    const Partition partition = build_partition(scene, {}).partition;
    const Image image = paint(scene, 200, {paint_edges(scene.mesh, partition)})[0];
    CHECK(near(image.at(100, 149), display(edge_colour(EdgeClass::border)))); // lower edge
    CHECK(near(image.at(50, 100), display(edge_colour(EdgeClass::border))));  // left edge
    CHECK(near(image.at(120, 100), image.at(80, 100)));                       // plain face
    const Rgb diagonal = image.at(100, 99); // from lower left to upper right
    CHECK(diagonal.z > diagonal.x + 0.1f);
    CHECK(near(image.at(80, 80), image.at(120, 100))); // the other diagonal has no edge
}

TEST_CASE("paint_candidates: candidates by expected photons, the rest grey", "[colouring]")
{
    Scene scene = quad_scene();
    Partition partition = build_partition(scene, {}).partition;
    const SeenPoint first{0, {}, {}, 1};
    const SeenPoint second{1, {}, {}, 1};
    const std::vector<float> photons = {500, 8000};
    partition.candidate = {1, 1};
    CHECK(paint_candidates(partition, photons)(first) == scale_colour(0));
    CHECK(paint_candidates(partition, photons)(second) == scale_colour(1));
    CHECK(paint_candidates(partition, {})(first) == scale_colour(1));
    partition.candidate = {0, 1};
    CHECK(paint_candidates(partition, photons)(first) == kPlainFace);
    CHECK(photons_of_candidates(partition, photons).least == 8000);
    CHECK(photons_of_candidates(partition, {}).largest == 0);
}

TEST_CASE("paint_groups: a colour for each group, full where it is widest, dark at its rim",
          "[colouring]")
{
    const Scene scene =
        tiny::make_scene(tiny::bent_grid(32, 32, [](glm::vec2 p) { return glm::vec3(p, 0); }));
    Partition partition = build_partition(scene, {}).partition;
    REQUIRE(partition.group_count == 64);
    const auto widest = static_cast<FaceId>(std::ranges::max_element(partition.group_radius) -
                                            partition.group_radius.begin());
    const Rgb colour = group_colours(partition)[partition.group_of_face[widest]];
    const Painter painter = paint_groups(scene.mesh, partition);
    const glm::vec3 centre(face_centre(scene.mesh, widest));
    CHECK(near(painter({widest, centre, {}, 1}), colour));
    CHECK(near(painter({widest, centre + 1.0f, {}, 1}), 0.2f * colour));
    partition.group_of_face[widest] = kNone;
    CHECK(painter({widest, centre, {}, 1}) == kPlainFace);
}

TEST_CASE("write_partition_pictures: four pictures of the size asked for, legend below",
          "[colouring]")
{
    const auto folder = std::filesystem::temp_directory_path() /
                        ("hipmap_pictures_test_" + std::to_string(::getpid()));
    const Scene scene = quad_scene();
    const Partition partition = build_partition(scene, {}).partition;
    const auto pictures = write_partition_pictures(folder, {scene, partition, true}, 120, 80);
    REQUIRE(pictures.size() == 4);
    for (const LegendedPicture& picture : pictures) {
        CHECK(picture.width == 120);
        CHECK(picture.height == 80);
        CHECK(!picture.legend.empty());
        // Width and height are the first words of a PNG's header, big-endian.
        const std::vector<std::byte> png = read_file(picture.path);
        REQUIRE(png.size() > 24);
        CHECK(std::to_integer<int>(png[19]) == 120);
        CHECK(std::to_integer<int>(png[23]) > 80);
    }
    std::filesystem::remove_all(folder);
}
