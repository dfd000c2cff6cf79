#include "tests/closed_forms/closed_forms.h"
#include "tests/support/form_factor.h"
#include "tests/support/tiny_rooms.h"

#include <algorithm>
#include <numbers>

namespace hipmap {

namespace {

constexpr double kHalf = 0.5; ///< albedo of the floors
constexpr std::uint64_t kPhotons = 20'000;
const glm::vec3 kDown(0, -1, 0);

/// The floor about the origin, seen from just above.
Scene floor_seen(float side)
{
    Scene scene = tiny::diffuse_floor();
    scene.cameras[0] = tiny::square_view(glm::vec3(0), kDown, side, 0.05f);
    return scene;
}

/// All of a sphere lights the floor as a point does.
ClosedForm under_point_light(const std::string& name, float radius)
{
    constexpr double kSide = 0.5, kHeight = 0.4, kIntensity = 3;
    ClosedForm out{name, "ρ/π I Ω/A", floor_seen(kSide), 0, PhotonsRead::direct, kPhotons};
    ScenePointLight light;
    light.radius = radius;
    light.position = {0, kHeight, 0};
    light.intensity = Rgb(kIntensity);
    out.scene.lights = {light};
    const double a2 = kSide * kSide / 4;
    const double solid_angle = 4 * std::asin(a2 / (a2 + kHeight * kHeight));
    out.expected = kHalf / M_PI * kIntensity * solid_angle / (kSide * kSide);
    return out;
}

ClosedForm under_spot()
{
    constexpr double kSide = 0.25, kHeight = 0.5, kIntensity = 2;
    ClosedForm out{"smooth edge of a spot", "ρ/π I t² cos θ/d²",
                   floor_seen(kSide),       0,
                   PhotonsRead::direct,     kPhotons};
    SceneSpotLight light;
    light.position = {0, kHeight, 0};
    light.direction = kDown;
    light.intensity = Rgb(kIntensity);
    light.cos_inner = std::cos(0.1f);
    light.cos_outer = std::cos(0.5f);
    out.scene.lights = {light};
    const double outer = light.cos_outer, inner = light.cos_inner;
    out.expected = mean_over_square(kSide, [=](double x, double z) {
        const double d2 = x * x + z * z + kHeight * kHeight, cosine = kHeight / std::sqrt(d2);
        const double t = std::clamp((cosine - outer) / (inner - outer), 0.0, 1.0);
        return kHalf / M_PI * kIntensity * t * t * cosine / d2;
    });
    return out;
}

/// So does a disc in the sky as a sun of its irradiance.
ClosedForm under_sun(const std::string& name, float half_angle)
{
    ClosedForm out{name, "ρ/π E cos θ", floor_seen(0.5f), 0, PhotonsRead::direct, kPhotons};
    SceneSunLight sun;
    sun.half_angle = half_angle;
    sun.direction = glm::normalize(glm::vec3(1, -2, 0));
    sun.irradiance = Rgb(5);
    out.scene.lights = {sun};
    out.expected = kHalf / M_PI * 5 * 2 / std::sqrt(5.0);
    return out;
}

ClosedForm under_sky()
{
    ClosedForm out{"open floor under a sky", "ρ L",   floor_seen(0.5f), 0,
                   PhotonsRead::direct,      kPhotons};
    out.scene.environment = {0.25f, 0.5f, 1};
    out.expected = kHalf * 1.75 / 3;
    return out;
}

ClosedForm under_square_light()
{
    constexpr double kSide = 0.4, kHeight = 0.3;
    ClosedForm out{"square under an emissive square",
                   "ρ L F",
                   floor_seen(kSide),
                   0,
                   PhotonsRead::direct,
                   kPhotons};
    tiny::add(out.scene, tiny::floor_at(kHeight, -kSide), tiny::emissive(Rgb(2)));
    out.expected = kHalf * 2 * facing_squares(kSide / kHeight);
    return out;
}

ClosedForm under_rectangle_light()
{
    constexpr double kSide = 0.4, kHeight = 0.3;
    ClosedForm out{"square under a square area light",
                   "ρ L F",
                   floor_seen(kSide),
                   0,
                   PhotonsRead::direct,
                   kPhotons};
    SceneAreaLight light;
    light.centre = {0, kHeight, 0};
    light.half_right = {kSide / 2, 0, 0};
    light.half_up = {0, 0, kSide / 2};
    light.direction = kDown;
    light.radiance = Rgb(2);
    out.scene.lights = {light};
    out.expected = kHalf * 2 * facing_squares(kSide / kHeight);
    return out;
}

ClosedForm under_disc_light()
{
    constexpr double kSide = 0.4, kHeight = 0.3, kRadius = 0.2;
    ClosedForm out{"floor under a round area light",
                   "ρ L/2 (1 - (h²+a²-r²)/√((h²+a²+r²)²-4a²r²))",
                   floor_seen(kSide),
                   0,
                   PhotonsRead::direct,
                   kPhotons};
    SceneAreaLight light;
    light.is_disc = true;
    light.centre = {0, kHeight, 0};
    light.half_right = {kRadius, 0, 0};
    light.half_up = {0, 0, kRadius};
    light.direction = kDown;
    light.radiance = Rgb(2);
    out.scene.lights = {light};
    // Howell's catalogue, B-13.
    out.expected = mean_over_square(kSide, [=](double x, double z) {
        const double a2 = x * x + z * z, h2 = kHeight * kHeight, r2 = kRadius * kRadius;
        const double sum = h2 + a2 + r2;
        return kHalf * 2 * 0.5 * (1 - (h2 + a2 - r2) / std::sqrt(sum * sum - 4 * a2 * r2));
    });
    return out;
}

ClosedForm under_triangle_light()
{
    constexpr double kSide = 0.3;
    ClosedForm out{"emissive triangle over a floor",
                   "ρ/π L ½ Σ γ n·Γ",
                   floor_seen(kSide),
                   0,
                   PhotonsRead::direct,
                   kPhotons};
    const std::vector<glm::vec3> corners{{-0.2f, 0.3f, -0.1f}, {0.3f, 0.4f, 0}, {0, 0.3f, 0.25f}};
    tiny::add(out.scene, tiny::make_mesh(corners, {{0, 1, 2}}), tiny::emissive(Rgb(2)));
    const std::vector<glm::dvec3> exact(corners.begin(), corners.end());
    out.expected = mean_over_square(kSide, [&](double x, double z) {
        return kHalf / M_PI * 2 * polygon_irradiance({x, 0, z}, {0, 1, 0}, exact);
    });
    return out;
}

/// A wall lit by the sun lights a floor that the sun does not reach.
struct LitWall {
    static constexpr double kWallAlbedo = 0.8, kFloorAlbedo = 0.1, kSun = 5;
    static constexpr double kSide = 0.5, kNear = 0.15, kLow = 0.1, kView = 0.2;
    const glm::vec3 direction = glm::normalize(glm::vec3(-1, 0.1f, 0));
    const std::vector<glm::dvec3> wall{{0, kLow, -kSide / 2},
                                       {0, kLow, kSide / 2},
                                       {0, kLow + kSide, kSide / 2},
                                       {0, kLow + kSide, -kSide / 2}};

    /// Irradiance at a point of the floor by radiance 1 of the wall.
    double from_wall(double x, double z) const
    {
        return polygon_irradiance({x, 0, z}, {0, 1, 0}, wall);
    }

    /// The share of the wall's light that comes back to it from the floor; the wall taken as lit
    /// evenly by that, which is off by a part of its few thousandths.
    double returned() const
    {
        const double to_floor = mean_over_square(kSide, [&](double x, double z) {
            return from_wall(x + kNear + kSide / 2, z) / M_PI; // their areas are equal
        });
        return kWallAlbedo * kFloorAlbedo * to_floor * to_floor;
    }
};

ClosedForm lit_by_a_wall()
{
    const LitWall form;
    const auto side = static_cast<float>(form.kSide), near = static_cast<float>(form.kNear),
               low = static_cast<float>(form.kLow);
    ClosedForm out{"floor lit by a sunlit wall", "ρ ρ'/π E cos θ F", {}, 0,
                   PhotonsRead::others,          3 * kPhotons};
    out.scene =
        tiny::make_scene(tiny::parallelogram({near, 0, side / 2}, {side, 0, 0}, {0, 0, -side}));
    out.scene.materials[0] = tiny::diffuse(Rgb(static_cast<float>(form.kFloorAlbedo)));
    tiny::add(out.scene, tiny::parallelogram({0, low, side / 2}, {0, 0, -side}, {0, side, 0}),
              tiny::diffuse(Rgb(static_cast<float>(form.kWallAlbedo))));
    SceneSunLight sun;
    sun.direction = form.direction;
    sun.irradiance = Rgb(static_cast<float>(form.kSun));
    out.scene.lights = {sun};
    out.scene.cameras[0] =
        tiny::square_view({near + side / 2, 0, 0}, kDown, static_cast<float>(form.kView), 0.05f);
    const double wall = form.kWallAlbedo / M_PI * form.kSun / std::sqrt(1.01);
    const double irradiance = mean_over_square(form.kView, [&](double x, double z) {
        return form.from_wall(x + form.kNear + form.kSide / 2, z);
    });
    out.expected = form.kFloorAlbedo / M_PI * wall * irradiance / (1 - form.returned());
    return out;
}

} // namespace

std::vector<ClosedForm> lit_forms()
{
    const Rgb albedo(0.7f, 0.5f, 0.3f);
    return {
        under_point_light("point light over a floor", 0),
        under_point_light("sphere light over a floor", 0.2f),
        under_spot(),
        under_sun("sun on a floor", 0),
        under_sun("sun of 60 degrees on a floor", 0.5f * std::numbers::pi_v<float> / 3),
        under_sky(),
        under_square_light(),
        under_rectangle_light(),
        under_disc_light(),
        under_triangle_light(),
        lit_by_a_wall(),
        {"emissive box", "e/(1 - ρ)", tiny::emissive_box(albedo), 1, PhotonsRead::others, kPhotons},
        {"emissive box with a glass and a mirror ball", "e/(1 - ρ)",
         tiny::with_glass_and_mirror(tiny::emissive_box(albedo), Rgb(1)), 1, PhotonsRead::others,
         kPhotons},
    };
}

std::vector<ClosedForm> closed_forms()
{
    std::vector<ClosedForm> out = lit_forms();
    for (std::vector<ClosedForm> more : {seen_forms(), cast_forms(), media_forms()})
        out.insert(out.end(), more.begin(), more.end());
    return out;
}

} // namespace hipmap
