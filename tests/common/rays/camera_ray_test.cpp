#include "common/rays/camera_ray.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace hipmap;

TEST_CASE("camera ray: the top edge of the picture is half the angle of view up", "[rays]")
{
    Camera camera;
    camera.tan_half_height = std::tan(0.3f);
    camera.aspect = 2;
    const Ray top = camera_ray(camera, {0.5f, 0}, 2);
    CHECK(std::atan2(top.direction.y, -top.direction.z) == Approx(0.3));
    CHECK(top.direction.x == 0);
    const Ray right = camera_ray(camera, {1, 0.5f}, 2);
    CHECK(right.direction.x / -right.direction.z == Approx(2 * std::tan(0.3)));
    const Ray centre = camera_ray(camera, {0.5f, 0.5f}, 2);
    CHECK(centre.direction == glm::vec3(0, 0, -1));
}

TEST_CASE("camera ray: a picture of another shape still shows all of the camera's view", "[rays]")
{
    Camera camera;
    camera.tan_half_height = 0.5f;
    camera.aspect = 2;
    const Ray narrow = camera_ray(camera, {1, 0.5f}, 1);
    CHECK(narrow.direction.x / -narrow.direction.z == Approx(1.0));
    const Ray wide = camera_ray(camera, {0.5f, 0}, 4);
    CHECK(wide.direction.y / -wide.direction.z == Approx(0.5));
}

TEST_CASE("camera ray: orthographic rays are parallel and half_height apart from the middle",
          "[rays]")
{
    Camera camera;
    camera.projection = Projection::orthographic;
    camera.half_height = 3;
    const Ray top = camera_ray(camera, {0.5f, 0}, 1);
    CHECK(top.origin == glm::vec3(0, 3, 0));
    CHECK(top.direction == glm::vec3(0, 0, -1));
}

TEST_CASE("camera ray: a shifted image is a part of a larger one", "[rays]")
{
    Camera whole;
    whole.tan_half_height = 0.6f;
    Camera part = whole; // its right third above the middle
    part.tan_half_height = 0.3f;
    part.shift = {1.0f, 0.5f};
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        whole.projection = part.projection = projection;
        whole.half_height = 2;
        part.half_height = 1;
        for (const glm::vec2& at : {glm::vec2(0, 0), glm::vec2(1, 1), glm::vec2(0.2f, 0.7f)}) {
            const Ray small = camera_ray(part, at, 1);
            const Ray large = camera_ray(whole, {2.0f / 3 + at.x / 3, at.y / 2}, 1.5f);
            CHECK(glm::distance(small.origin, large.origin) < 1e-6f);
            CHECK(glm::distance(small.direction, large.direction) < 1e-6f);
        }
    }
}

TEST_CASE("camera ray: clipping planes are measured along the view", "[rays]")
{
    Camera camera;
    camera.tan_half_height = 1;
    camera.near_clip = 2;
    camera.far_clip = 10;
    const Ray corner = camera_ray(camera, {0, 0}, 1);
    CHECK(corner.near == Approx(2 * std::sqrt(3.0)));
    CHECK(corner.far == Approx(10 * std::sqrt(3.0)));
    camera.far_clip = 0;
    CHECK(std::isinf(camera_ray(camera, {0, 0}, 1).far));
}

TEST_CASE("camera ray: rays of a lens meet in the plane in focus and fill the aperture", "[rays]")
{
    Camera camera;
    camera.tan_half_height = 0.5f;
    camera.aperture_radius = 0.1f;
    const glm::vec2 picture(0.8f, 0.1f);
    const Ray sharp = camera_ray(camera, picture, 1, {0.6f, 0.8f});
    CHECK(sharp.origin == camera.position); // no focus: a pinhole
    camera.focus_distance = 4;
    camera.near_clip = 1;
    const glm::vec3 focus(4 * 0.5f * 0.6f, 4 * 0.5f * 0.8f, -4);
    for (const glm::vec2& lens :
         {glm::vec2(0), glm::vec2(0.6f, 0.8f), glm::vec2(-1, 0), glm::vec2(0.2f, -0.3f)}) {
        const Ray ray = camera_ray(camera, picture, 1, lens);
        CHECK(glm::distance(ray.origin, glm::vec3(0.1f * lens, 0)) < 1e-7f);
        const glm::vec3 there = ray.origin + ray.direction * (-4 / ray.direction.z);
        CHECK(glm::distance(there, focus) < 1e-5f);
        CHECK(ray.near * -ray.direction.z == Approx(1));
    }
    camera.projection = Projection::orthographic;
    CHECK_FALSE(has_lens(camera));
}
