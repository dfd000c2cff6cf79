#include "common/rays/camera_ray.h"
#include "render/layers/layer_file.h"
#include "render/layers/surface_layers.h"
#include "tests/support/tiny_media.h"

#include <catch2/catch.hpp>
#include <tbb/global_control.h>

using namespace hipmap;

namespace {

/// Not square.
RenderOptions image(int width, int height, PixelFilter filter = PixelFilter::box)
{
    RenderOptions options;
    options.width = width;
    options.height = height;
    options.filter = filter;
    return options;
}

/// The layers of these names, in this order.
std::vector<LayerImage> layers_of(const tiny::ReadyScene& scene, const RenderOptions& options,
                                  std::string_view names)
{
    return surface_layers(*scene.render, options, parse_layers(names));
}

std::vector<float> layer_of(const tiny::ReadyScene& scene, const RenderOptions& options,
                            std::string_view name)
{
    return layers_of(scene, options, name)[0].values;
}

Camera oblique_camera()
{
    Camera camera;
    camera.position = {0.1f, 0.2f, 0.9f};
    camera.forward = glm::normalize(glm::vec3(0.1f, -0.3f, -1));
    camera.right = glm::normalize(glm::cross(camera.forward, glm::vec3(0, 1, 0)));
    camera.up = glm::cross(camera.right, camera.forward);
    return camera;
}

/// A square about (x, 0, 0) across z, an object of its own.
void add_square(Scene& scene, float x, float side, const Material& material)
{
    std::vector<ObjectId> objects = scene.mesh.object_of_face;
    const auto object = objects.empty() ? 0 : objects.back() + 1;
    tiny::add(scene, tiny::parallelogram({x - side / 2, -side / 2, 0}, {side, 0, 0}, {0, side, 0}),
              material);
    objects.resize(scene.mesh.face_count(), object);
    scene.mesh.object_of_face = objects;
    scene.mesh.object_names.resize(object + 1);
}

/// Looks along -z at a square of side 2 about the origin.
Scene facing_scene()
{
    Scene scene;
    Camera camera;
    camera.projection = Projection::orthographic;
    camera.position = {0, 0, 1.5f};
    camera.half_height = 1;
    scene.cameras = {camera};
    return scene;
}

/// A square of side 1 on the left of the middle, one of side 1/2 on its right from `x` on; the rest
/// is empty.
std::unique_ptr<tiny::ReadyScene> two_squares(float x = 0)
{
    Scene scene = facing_scene();
    add_square(scene, -0.5f, 1, tiny::diffuse({0.8f, 0.4f, 0.2f}));
    add_square(scene, x + 0.25f, 0.5f, tiny::diffuse(Rgb(0.1f)));
    return tiny::ready(std::move(scene));
}

} // namespace

TEST_CASE("surface_layers: depth, position and normal of a plane are those of its equation",
          "[layers]")
{
    const glm::dvec3 corner(-4, -3, -1), u(8, 0, 1), v(0, 7, 2);
    Scene scene = tiny::make_scene(tiny::parallelogram(corner, u, v));
    scene.cameras[0] = oblique_camera();
    scene.frame = {{10, 20, 30}, 4};
    const auto ready = tiny::ready(std::move(scene));
    const RenderOptions options = image(9, 7);
    const auto layers = layers_of(*ready, options, "depth,position,normal");
    const Camera& camera = ready->scene.cameras[0];
    const glm::dvec3 normal = glm::normalize(glm::cross(u, v));
    for (int i = 0; i < 63; ++i) {
        const glm::vec2 at = (glm::vec2(i % 9, i / 9) + 0.5f) / glm::vec2(9, 7);
        const Ray ray = camera_ray(camera, at, 9.0f / 7);
        const glm::dvec3 from = ray.origin, along = ray.direction;
        const double distance = glm::dot(corner - from, normal) / glm::dot(along, normal);
        const glm::dvec3 p = from + distance * along;
        const double depth = 4 * glm::dot(p - from, glm::dvec3(camera.forward));
        INFO(i);
        CHECK(layers[0].values[i] == Approx(depth).epsilon(1e-5));
        const float* const place = &layers[1].values[3 * i];
        CHECK(place[0] == Approx(10 + 4 * p.x).epsilon(1e-5));
        CHECK(place[1] == Approx(-30 - 4 * p.z).epsilon(1e-5));
        CHECK(place[2] == Approx(20 + 4 * p.y).epsilon(1e-5));
        const float* const facing = &layers[2].values[3 * i];
        CHECK(facing[0] == Approx(normal.x).margin(1e-6));
        CHECK(facing[1] == Approx(-normal.z).margin(1e-6));
        CHECK(facing[2] == Approx(normal.y).margin(1e-6));
    }
}

TEST_CASE("surface_layers: numbers of objects, materials and maps fill the pixels that they cover",
          "[layers]")
{
    const auto ready = two_squares(0.25f);
    const auto layers =
        layers_of(*ready, image(16, 16), "object-index,material-index,map,depth,normal");
    for (int i = 0; i < 256; ++i) {
        const float x = (i % 16 + 0.5f) / 8 - 1, y = 1 - (i / 16 + 0.5f) / 8;
        const bool first = x < 0 && std::abs(y) < 0.5f;
        const bool second = x > 0.25f && x < 0.75f && std::abs(y) < 0.25f;
        const float number = first ? 1 : second ? 2 : 0;
        INFO(i);
        CHECK(layers[0].values[i] == number);
        CHECK(layers[1].values[i] == number);
        CHECK(layers[2].values[i] == number - 1);
        CHECK(layers[3].values[i] == (number > 0 ? 1.5f : 1e10f));
        CHECK(layers[4].values[3 * i + 1] == (number > 0 ? -1 : 0));
    }
}

TEST_CASE("surface_layers: the diffuse colour is the base colour that metal and glass leave",
          "[layers]")
{
    Material coated = tiny::diffuse({0.8f, 0.4f, 0.2f});
    coated.specular = 1;
    Material part_metal = coated;
    part_metal.metallic = 0.25f;
    Material part_glass = coated;
    part_glass.transmission = 0.5f;
    Material varnished = coated;
    varnished.clearcoat = 1;
    const std::vector<std::pair<Material, float>> shares = {
        {tiny::diffuse(coated.base_color), 1.0f},
        {coated, 1.0f},
        {part_metal, 0.75f},
        {part_glass, 0.5f},
        {varnished, 1.0f},
        {tiny::mirror(Rgb(1)), 0.0f},
        {tiny::glass(1.5f), 0.0f}};
    for (const auto& [material, share] : shares) {
        Scene scene = facing_scene();
        add_square(scene, 0, 4, material);
        const auto values = layer_of(*tiny::ready(std::move(scene)), image(2, 2), "diffuse-color");
        for (int c = 0; c < 12; ++c)
            CHECK(values[c] == Approx(share * coated.base_color[c % 3]).epsilon(1e-5));
    }
}

TEST_CASE("surface_layers: the albedo is what all lobes scatter", "[layers]")
{
    Material white = tiny::diffuse(Rgb(1));
    white.specular = 1;
    const Rgb grey(0.8f, 0.4f, 0.2f);
    const std::vector<std::pair<Material, Rgb>> albedos = {
        {tiny::diffuse(grey), grey}, // Lambert
        {white, Rgb(1)},             // a coat takes nothing from white
        {tiny::mirror(grey), grey},  // facing the camera: reflectance at normal incidence
        {tiny::glass(1.5f), Rgb(1)}, // what it does not reflect it transmits
        {tiny::emissive(Rgb(5)), Rgb(0)}};
    for (const auto& [material, albedo] : albedos) {
        Scene scene = facing_scene();
        add_square(scene, 0, 4, material);
        const auto values =
            layer_of(*tiny::ready(std::move(scene)), image(2, 2), "denoising-albedo");
        for (int c = 0; c < 12; ++c)
            CHECK(values[c] == Approx(albedo[c % 3]).margin(0.01));
    }
}

TEST_CASE("surface_layers: means weigh surfaces by the pixel filter", "[layers]")
{
    const auto ready = two_squares(); // whose middle is an edge between columns 1 and 2
    const auto box = layer_of(*ready, image(4, 4), "diffuse-color");
    CHECK(box[3 * 5] == Approx(0.8f));
    CHECK(box[3 * 6] == Approx(0.05f));
    CHECK(box[3 * 7] == 0);
    const auto wide = layer_of(*ready, image(4, 4, PixelFilter::b_spline), "diffuse-color");
    // 5/6 of the filter of a pixel beside an edge lie on its own side, 1 - 1/48 one pixel further
    CHECK(wide[3 * 4] == Approx(0.8f * 5 / 6 * 5 / 6).margin(0.02));
    const float below = 0.5f - 1.0f / 48; // of the height of the second square
    CHECK(wide[3 * 5] == Approx(0.8f * 5 / 6 * 5 / 6 + 0.1f / 6 * below).margin(0.02));
    CHECK(wide[3 * 7] == Approx(0.1f / 6 * below).margin(0.02));
}

TEST_CASE("surface_layers: a surface without opacity is not there, half of it is in half the rays",
          "[layers]")
{
    for (const float alpha : {0.0f, 0.5f, 1.0f}) {
        Scene scene = facing_scene();
        add_square(scene, 0, 4, tiny::diffuse(Rgb(0.5f)));
        Material veil = tiny::diffuse(Rgb(0));
        veil.alpha = alpha;
        veil.alpha_mode = AlphaMode::blend;
        add_square(scene, 0, 4, veil);
        for (std::size_t i = 4; i < 8; ++i)
            scene.mesh.positions[i].z = 0.5f;
        const auto ready = tiny::ready(std::move(scene));
        const auto depth = layer_of(*ready, image(32, 32), "depth");
        const auto near = std::count(depth.begin(), depth.end(), 1.0f);
        const auto far = std::count(depth.begin(), depth.end(), 1.5f);
        CHECK(near + far == 1024);
        CHECK(near == Approx(1024 * alpha).margin(alpha == 0.5f ? 80 : 0));
        const auto colour = layer_of(*ready, image(32, 32), "diffuse-color");
        double sum = 0;
        for (const float value : colour)
            sum += value;
        CHECK(sum / 3072 == Approx(0.5 * (1 - alpha)).margin(0.01));
    }
}

TEST_CASE("surface_layers: fog and the faces that bound it are not seen", "[layers]")
{
    Scene scene = facing_scene();
    add_square(scene, 0, 4, tiny::diffuse(Rgb(0.5f)));
    Medium milk;
    milk.scattering = Rgb(100);
    TriangleMesh cube = tiny::cube();
    tiny::move(cube, {0, 0, 0.6f});
    tiny::add(scene, cube, tiny::fog(milk));
    const auto ready = tiny::ready(std::move(scene));
    const auto layers = layers_of(*ready, image(4, 4), "depth,diffuse-color");
    for (int i = 0; i < 16; ++i) {
        CHECK(layers[0].values[i] == Approx(1.5f));
        CHECK(layers[1].values[3 * i] == Approx(0.5f));
    }
}

TEST_CASE("surface_layers: any number of threads gives the same values", "[layers]")
{
    const auto ready = two_squares();
    const std::string_view names = "depth,normal,diffuse-color,object-index";
    const auto all = layers_of(*ready, image(33, 17, PixelFilter::b_spline), names);
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
    const auto one = layers_of(*ready, image(33, 17, PixelFilter::b_spline), names);
    REQUIRE(all.size() == 4);
    for (std::size_t i = 0; i < all.size(); ++i)
        CHECK(all[i].values == one[i].values);
}

TEST_CASE("surface_layers: a lens blurs means and leaves numbers sharp", "[layers]")
{
    Scene scene = facing_scene();
    add_square(scene, -5, 10, tiny::diffuse(Rgb(1)));
    scene.cameras[0].projection = Projection::perspective;
    scene.cameras[0].aperture_radius = 0.3f;
    scene.cameras[0].focus_distance = 0.75f;
    const auto ready = tiny::ready(std::move(scene));
    const auto layers = layers_of(*ready, image(8, 8), "object-index,diffuse-color");
    for (int i = 0; i < 64; ++i)
        CHECK(layers[0].values[i] == (i % 8 < 4 ? 1 : 0));
    CHECK(layers[1].values[3 * 36] > 0);
    CHECK(layers[1].values[3 * 35] < 1);
}
