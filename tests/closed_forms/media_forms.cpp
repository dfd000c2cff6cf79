#include "tests/closed_forms/closed_forms.h"
#include "tests/support/tiny_media.h"
#include "tests/support/tiny_rooms.h"

namespace hipmap {

namespace {

constexpr std::uint64_t kPhotonsInMedia = 4000;

ClosedForm absorbed()
{
    constexpr double kLight = 2;
    Medium medium;
    medium.absorption = {0.5f, 1, 4};
    ClosedForm out{"emissive square through an absorbing slab", "L exp(-a d)",
                   tiny::cube_of(medium), 0};
    tiny::add(out.scene, tiny::floor_at(-0.6f, 3), tiny::emissive(Rgb(kLight)));
    for (int c = 0; c < 3; ++c)
        out.expected += kLight * std::exp(-double{medium.absorption[c]}) / 3;
    return out;
}

ClosedForm emissive()
{
    Medium medium;
    medium.absorption = {0, 1, 2};
    medium.emission = Rgb(3);
    ClosedForm out{"slab that absorbs and emits", "e/a (1 - exp(-a d))", tiny::cube_of(medium),
                   (3 + 3 * -std::expm1(-1.0) + 1.5 * -std::expm1(-2.0)) / 3};
    return out;
}

/// It scatters as much as comes, so that it is not seen.
ClosedForm under_sky(const std::string& name, const PhaseFunction& phase)
{
    Medium medium;
    medium.scattering = {1, 3, 9};
    medium.phase = phase;
    ClosedForm out{"white fog under a sky, " + name,
                   "L",
                   tiny::cube_of(medium),
                   1,
                   PhotonsRead::media,
                   kPhotonsInMedia};
    out.scene.environment = Rgb(1);
    return out;
}

ClosedForm in_a_box()
{
    ClosedForm out{"emissive box full of white fog",
                   "e/(1 - ρ)",
                   tiny::emissive_box({0.7f, 0.5f, 0.3f}),
                   1,
                   PhotonsRead::media,
                   kPhotonsInMedia};
    out.scene.around.scattering = {1, 2, 4};
    return out;
}

/// So little that no light to speak of is scattered twice.
ClosedForm scattered_once()
{
    constexpr double kScattering = 1e-4, kAbsorption = 1, kMeanCosine = 0.5, kSide = 0.2;
    constexpr int kSteps = 40; // midpoints each way: the error is below 1e-5
    Medium medium;
    medium.absorption = Rgb(kAbsorption);
    medium.scattering = Rgb(kScattering);
    medium.phase = {PhaseKind::henyey_greenstein, kMeanCosine};
    ClosedForm out{"point light in thin fog", "∫ s p I/d² exp(-t (d + d'))",
                   tiny::cube_of(medium, kSide), 0};
    out.why_not_photons = "hardly any photon of a pass is scattered";
    ScenePointLight light;
    light.position = {0.4f, 0, 0};
    light.intensity = Rgb(1);
    out.scene.lights = {light};
    const auto middle = [](int cell, double side) { return side * ((cell + 0.5) / kSteps - 0.5); };
    for (int i = 0; i < kSteps * kSteps * kSteps; ++i) {
        const glm::dvec3 p(middle(i % kSteps, kSide), middle(i / kSteps / kSteps, 1),
                           middle(i / kSteps % kSteps, kSide));
        const glm::dvec3 way = p - glm::dvec3(light.position);
        const double d = glm::length(way), g = kMeanCosine;
        const double cosine = way.y / d; // from the light, and up to the eye
        const double phase = (1 - g * g) / (4 * M_PI * std::pow(1 + g * g - 2 * g * cosine, 1.5));
        out.expected += kScattering * phase / (d * d) *
                        std::exp(-(kAbsorption + kScattering) * (d + 0.5 - p.y)) /
                        (kSteps * kSteps * kSteps);
    }
    return out;
}

} // namespace

std::vector<ClosedForm> media_forms()
{
    return {absorbed(),
            emissive(),
            under_sky("isotropic", {}),
            under_sky("Henyey and Greenstein", {PhaseKind::henyey_greenstein, 0.7f}),
            under_sky("Schlick", {PhaseKind::schlick, -0.4f}),
            in_a_box(),
            scattered_once()};
}

} // namespace hipmap
