#include "tests/closed_forms/closed_forms.h"
#include "tests/support/form_factor.h"
#include "tests/support/fresnel.h"
#include "tests/support/mirror_shaft.h"

namespace hipmap {

namespace {

constexpr double kBallRadius = 0.4, kBallIndex = 1.5;

ClosedForm seen_in_mirrors(int bounces)
{
    const tiny::MirrorShaft shaft{bounces, 0.9f / static_cast<float>(bounces), {0.9f, 0.8f, 0.6f}};
    ClosedForm out{"sky seen in " + std::to_string(bounces) + " mirrors", "R^n L", shaft.scene(),
                   shaft.passed()};
    out.scene.environment = Rgb(1);
    out.scene.cameras[0] =
        tiny::square_view({0.5f * shaft.width, 0, 0}, shaft.entering(), 0.3f * shaft.width, 0.1f);
    return out;
}

ClosedForm facing_mirrors()
{
    Material material = tiny::mirror(Rgb(0.7f));
    material.emission = Rgb(1);
    ClosedForm out{"between emissive mirrors", "e/(1 - R)", {}, 1 / 0.3};
    out.scene = tiny::make_scene(tiny::floor_at(-0.2f, 1));
    out.scene.materials[0] = material;
    tiny::add(out.scene, tiny::floor_at(0.2f, -1), material);
    out.scene.cameras[0] = tiny::square_view(glm::vec3(0), {0, -1, 0}, 0.2f, 0.1f);
    return out;
}

/// A light below, the sky above: what the slab does not let through it reflects.
ClosedForm seen_through_a_slab(const Rgb& absorption)
{
    constexpr float kThickness = 0.1f;
    constexpr double kIndex = 1.5, kLight = 2, kSky = 0.5;
    const bool clear = is_black(absorption);
    ClosedForm out{clear ? "emissive square through a slab of glass under a sky"
                         : "emissive square through a slab of coloured glass",
                   clear ? "T L + (1 - T) L'" : "T L, T = (1 - R)² a/(1 - R² a²)",
                   {},
                   0};
    TriangleMesh slab = tiny::cube();
    for (glm::vec3& p : slab.positions)
        p.y *= kThickness;
    out.scene = tiny::make_scene(slab);
    out.scene.materials[0] = tiny::glass(kIndex);
    out.scene.materials[0].absorption = absorption;
    tiny::add(out.scene, tiny::floor_at(-0.1f, 0.8f), tiny::emissive(Rgb(kLight)));
    if (clear)
        out.scene.environment = Rgb(kSky);
    out.scene.cameras[0] =
        tiny::square_view(glm::vec3(0), glm::normalize(glm::vec3(1, -1, 0)), 0.1f, 0.3f);
    const double cosine = std::sqrt(0.5), reflectance = fresnel(cosine, kIndex);
    const double way = kThickness / std::sqrt(1 - 0.5 / (kIndex * kIndex));
    for (int c = 0; c < 3; ++c) {
        const double through = through_slab(reflectance, std::exp(-absorption[c] * way));
        out.expected += (through * kLight + (clear ? (1 - through) * kSky : 0)) / 3;
    }
    return out;
}

Scene ball_seen(float side, const Rgb& absorption)
{
    Scene scene = tiny::make_scene(tiny::fine_ball(kBallRadius));
    scene.materials[0] = tiny::glass(kBallIndex);
    scene.materials[0].absorption = absorption;
    scene.environment = Rgb(1);
    scene.cameras[0] = tiny::square_view(glm::vec3(0), {0, -1, 0}, side, 1);
    return scene;
}

/// Its middle: at the rim facets differ most from a ball.
ClosedForm coloured_ball(const Rgb& absorption)
{
    constexpr double kSide = 0.4;
    ClosedForm out{"ball of coloured glass under a sky", "R + (1 - R)² a/(1 - R a)",
                   ball_seen(kSide, absorption), 0};
    for (int c = 0; c < 3; ++c)
        out.expected +=
            mean_over_square(kSide,
                             [&](double x, double y) {
                                 return out_of_ball_at(std::hypot(x, y) / kBallRadius, kBallIndex,
                                                       kBallRadius * absorption[c]);
                             }) /
            3;
    return out;
}

} // namespace

std::vector<ClosedForm> seen_forms()
{
    const Rgb colour(1, 2, 4);
    return {seen_in_mirrors(3),
            seen_in_mirrors(10),
            facing_mirrors(),
            seen_through_a_slab(Rgb(0)),
            seen_through_a_slab(colour),
            {"glass ball under an even sky", "L", ball_seen(1, Rgb(0)), 1},
            coloured_ball(colour)};
}

} // namespace hipmap
