#include "tests/support/tiny_scenes.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

Material medium_of(float absorption)
{
    Material out;
    out.boundary = false;
    out.absorption = Rgb(absorption);
    return out;
}

/// Cubes of sides 1 and 1/2 in each other, and a ball of glass in both.
Scene nested()
{
    Scene scene = tiny::make_scene(tiny::cube());
    scene.materials[0] = medium_of(1);
    TriangleMesh inner = tiny::cube();
    tiny::scale(inner, 0.5f);
    tiny::add(scene, inner, medium_of(3));
    TriangleMesh ball = tiny::uv_sphere(32, 16);
    tiny::scale(ball, 0.1f);
    tiny::add(scene, ball, tiny::glass(1.5f));
    return scene;
}

std::vector<MaterialId> list(const MediumStack& inside)
{
    return {inside.entered.begin(), inside.entered.begin() + inside.count};
}

} // namespace

TEST_CASE("medium_stack_at: what a point is in, the last that was entered last", "[media]")
{
    const auto ready = tiny::ready(nested());
    const MediaSet& media = ready->render->media.value();
    CHECK(list(medium_stack_at(media, {0.6f, 0, 0})).empty());
    CHECK(list(medium_stack_at(media, {0.45f, 0.45f, 0.45f})) == std::vector<MaterialId>{0});
    CHECK(list(medium_stack_at(media, {0.2f, -0.2f, 0.1f})) == std::vector<MaterialId>{0, 1});
    CHECK(list(medium_stack_at(media, {0.01f, 0.02f, 0.03f})) == std::vector<MaterialId>{0, 1, 2});
}

TEST_CASE("let_through: absorption by way of nested media, nothing through a surface", "[media]")
{
    Scene scene = nested();
    scene.around.absorption = Rgb(0.5f);
    const auto ready = tiny::ready(scene);
    const MediaSet& media = ready->render->media.value();
    Ray ray;
    ray.origin = {-2, 0.2f, 0.13f};
    ray.direction = {1, 0, 0};
    ray.far = 4;
    // Around: within the sphere round the cube.
    const double half = std::sqrt(0.75 - 0.2 * 0.2 - 0.13 * 0.13);
    const double depth = 0.5 * (2 * half - 1) + 1 * 0.5 + 3 * 0.5;
    CHECK(let_through(media, ray, {}).x == Approx(std::exp(-depth)));
    ray.far = 2; // to the middle
    CHECK(let_through(media, ray, {}).x == Approx(std::exp(-depth / 2)));
    ray.origin.y = ray.origin.z = 0; // into the ball
    CHECK(let_through(media, ray, {}) == Rgb(0));
}

TEST_CASE("media are found only where a scene has some", "[media]")
{
    Scene scene = nested();
    CHECK(tiny::ready(scene)->render->media);
    for (Material& material : scene.materials)
        material = tiny::glass(1.5f);
    scene.materials[0].absorption = Rgb(1); // as glass has it
    CHECK(!tiny::ready(scene)->render->media);
    scene.materials[1].scattering = Rgb(1);
    CHECK(tiny::ready(scene)->render->media);
    scene.materials[1] = tiny::diffuse(Rgb(0.5f));
    scene.materials[1].scattering = Rgb(1); // which no light reaches
    CHECK(!tiny::ready(scene)->render->media);
    scene.around.emission = Rgb(1);
    CHECK(tiny::ready(scene)->render->media);
}

TEST_CASE("media are found where a light is partly in glass that absorbs", "[media]")
{
    Scene tinted = tiny::make_scene(tiny::cube());
    tinted.materials[0] = tiny::glass(1.5f);
    tinted.materials[0].absorption = Rgb(1);
    tinted.cameras[0].position = {0, 0, 5};
    const auto with_light = [&](const SceneLight& light) {
        Scene scene = tinted;
        scene.lights = {light};
        return tiny::ready(scene)->render->media.has_value();
    };
    // Seen from the middle of the cube, whose faces are 1/2 away, along x.
    ScenePointLight ball{.name = "", .position = {1, 0, 0}, .intensity = Rgb(1), .radius = 0.6};
    CHECK(with_light(ball));
    ball.radius = 0.4;
    CHECK(!with_light(ball));
    for (const bool is_disc : {false, true}) {
        SceneAreaLight flat{
            .name = "", .is_disc = is_disc, .centre = {1, 0, 0}, .radiance = Rgb(1)};
        flat.half_right = {0.6, 0, 0};
        flat.half_up = {0, 0.2, 0};
        CHECK(with_light(flat));
        flat.half_right = {0.4, 0, 0};
        CHECK(!with_light(flat));
    }
    const auto with_face = [&](float side) {
        Scene scene = tinted;
        TriangleMesh lamp = tiny::floor_at(0, side);
        tiny::move(lamp, {1, 0.1f, 0.5f});
        tiny::add(scene, lamp, tiny::emissive(Rgb(1)));
        return tiny::ready(scene)->render->media.has_value();
    };
    CHECK(with_face(1.2f)); // a corner is in the cube
    CHECK(!with_face(0.8f));
}

namespace {

/// Two cubes of glass of side 1 that share half of their height, the upper one of such a priority.
Scene overlapping(float priority_above)
{
    Scene scene = tiny::make_scene(tiny::cube());
    scene.materials[0] = tiny::glass(1.3f);
    TriangleMesh above = tiny::cube();
    tiny::move(above, {0, 0.5f, 0});
    tiny::add(scene, above, tiny::glass(1.6f));
    scene.materials[1].priority = priority_above;
    scene.nested_dielectrics = true;
    return scene;
}

/// Heights at which a ray upwards, or downwards, through both of them meets surfaces.
std::vector<float> surfaces_met(const MediaSet& media, float up)
{
    Ray ray;
    ray.origin = {0.11f, up > 0 ? -2 : 2, 0.07f};
    ray.direction = {0, up, 0};
    std::vector<float> out;
    MediumStack inside;
    while (true) {
        const WalkEnd end = walk(media, ray, inside, [](const MediumSegment&) { return true; });
        if (!end.hit)
            return out;
        const SurfacePoint at = surface_point(media.mesh, end.hit->face, end.hit->barycentric);
        out.push_back(at.position.y);
        cross(media, end.hit->face, glm::dot(ray.direction, at.geometric_normal) <= 0, inside);
        ray.origin = offset_origin(at, ray.direction);
    }
}

} // namespace

TEST_CASE("walk: where dielectrics overlap the higher priority is there, whichever way a ray goes",
          "[media]")
{
    for (const float above : {0.0f, 1.0f}) {
        Scene scene = overlapping(above);
        scene.materials[0].priority = 0.5f;
        const auto ready = tiny::ready(scene);
        const MediaSet& media = ready->render->media.value();
        const float between = above > 0.5f ? 0.0f : 0.5f;
        CHECK(surfaces_met(media, 1) == std::vector<float>{-0.5f, between, 1});
        CHECK(surfaces_met(media, -1) == std::vector<float>{1, between, -0.5f});
        const MaterialId there = above > 0.5f ? 1 : 0;
        CHECK(medium_stack_at(media, {0.1f, 0.25f, 0.2f}).current() == there);
        CHECK(dielectric_at(media, medium_stack_at(media, {0.1f, 0.25f, 0.2f})) == there);
    }
}

TEST_CASE("walk: meshes of one glass that overlap are one, and fog in it is no surface", "[media]")
{
    Scene scene = overlapping(0);
    scene.mesh.material_of_face.assign(scene.mesh.face_count(), 0);
    TriangleMesh cloud = tiny::cube();
    tiny::scale(cloud, 0.25f);
    tiny::add(scene, cloud, medium_of(1));
    const auto ready = tiny::ready(scene);
    const MediaSet& media = ready->render->media.value();
    CHECK(surfaces_met(media, 1) == std::vector<float>{-0.5f, 1});
    CHECK(dielectric_at(media, medium_stack_at(media, {0.01f, 0.02f, 0.03f})) == 0);
    CHECK(medium_stack_at(media, {0.01f, 0.02f, 0.03f}).current() == 2);
}
