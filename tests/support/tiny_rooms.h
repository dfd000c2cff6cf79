#pragma once

#include "tests/support/tiny_scenes.h"

namespace hipmap::tiny {

/// A square of side 1 about the origin, facing up, albedo 1/2.
inline Scene diffuse_floor()
{
    Scene scene = make_scene(floor_at(0, 1));
    scene.materials[0] = diffuse(Rgb(0.5f));
    return scene;
}

/// The inside of a closed diffuse sphere, albedo 1/2, radiance emitted 1/2: 1 everywhere.
inline Scene furnace()
{
    TriangleMesh sphere = uv_sphere(48, 24);
    turn_inside_out(sphere);
    scale(sphere, 0.5f);
    Scene scene = make_scene(sphere);
    scene.materials[0] = diffuse(Rgb(0.5f));
    scene.materials[0].emission = Rgb(0.5f);
    scene.cameras[0].position = {0.1f, 0.05f, 0};
    scene.cameras[0].tan_half_height = 1;
    return scene;
}

/// The inside of a cube, seen from one wall.
inline Scene box(const Material& walls)
{
    TriangleMesh mesh = cube();
    turn_inside_out(mesh);
    Scene scene = make_scene(mesh);
    scene.materials[0] = walls;
    scene.cameras[0].position = {0, 0, 0.48f};
    scene.cameras[0].tan_half_height = 0.8f;
    return scene;
}

/// With a ball of glass and one of mirror on the left and right.
inline Scene with_glass_and_mirror(Scene scene, const Rgb& reflectance)
{
    TriangleMesh ball = uv_sphere(16, 8);
    scale(ball, 0.15f);
    move(ball, {-0.2f, -0.3f, 0});
    add(scene, ball, glass(1.5f));
    move(ball, {0.4f, 0, 0});
    add(scene, ball, mirror(reflectance));
    return scene;
}

/// A diffuse box, inside, with a glass ball, a mirror ball and a light.
inline Scene room()
{
    Scene scene = with_glass_and_mirror(box(diffuse({0.7f, 0.6f, 0.5f})), Rgb(0.9f));
    add(scene, floor_at(0.45f, -0.3f), emissive(Rgb(5)));
    return scene;
}

/// A diffuse box, inside, that sends out what it absorbs: radiance one everywhere, whatever absorbs
/// nothing is put in.
inline Scene emissive_box(const Rgb& albedo)
{
    Material walls = diffuse(albedo);
    walls.emission = 1.0f - albedo;
    return box(walls);
}

} // namespace hipmap::tiny
