#include "tests/closed_forms/closed_forms.h"
#include "tests/support/fresnel.h"
#include "tests/support/mirror_shaft.h"

namespace hipmap {

namespace {

/// Of the floors: so dark that what mirrors and glass send back to them does not count.
constexpr double kDark = 0.001;
const char* const kHidden = "no path finds a sun through glass or in a mirror";

/// Irradiance 1 across `direction`.
SceneSunLight sun_along(const glm::vec3& direction)
{
    SceneSunLight sun;
    sun.direction = direction;
    sun.irradiance = Rgb(1);
    return sun;
}

/// A slab that shades all of a small floor.
ClosedForm cast_through_a_slab()
{
    constexpr double kIndex = 1.5;
    ClosedForm out{"sun through a slab of glass on a floor",
                   "ρ/π E cos θ T",
                   {},
                   0,
                   PhotonsRead::others,
                   40'000,
                   kHidden};
    TriangleMesh slab = tiny::cube();
    for (glm::vec3& p : slab.positions)
        p.y = 0.1f * p.y + 0.3f;
    out.scene = tiny::make_scene(slab);
    out.scene.materials[0] = tiny::glass(kIndex);
    tiny::add(out.scene, tiny::floor_at(0, 0.4f), tiny::diffuse(Rgb(kDark)));
    const double cosine = std::cos(M_PI / 6);
    out.scene.lights = {sun_along({0.5f, static_cast<float>(-cosine), 0})};
    out.scene.cameras[0] = tiny::square_view(glm::vec3(0), {0, -1, 0}, 0.3f, 0.05f);
    out.expected = kDark / M_PI * cosine * through_slab(fresnel(cosine, kIndex), 1);
    return out;
}

/// A shaft of mirrors casts a parallelogram of light onto a floor below it.  The view is in the
/// part where that lies, whichever way it leaves.  A black plate to the left of the shaft keeps all
/// other sun from the floor.
ClosedForm cast_by_mirrors(int bounces)
{
    const tiny::MirrorShaft shaft{bounces, 0.3f, {0.9f, 0.8f, 0.6f}};
    ClosedForm out{"sun by way of " + std::to_string(bounces) + " mirrors on a floor",
                   "ρ/π E cos θ R^n",
                   shaft.scene(),
                   0,
                   PhotonsRead::others,
                   40'000,
                   kHidden};
    const float y = -shaft.height() - 0.1f * shaft.width;
    tiny::add(out.scene, tiny::parallelogram({-0.3f, y, 0.3f}, {0.9f, 0, 0}, {0, 0, -0.6f}),
              tiny::diffuse(Rgb(kDark)));
    tiny::add(out.scene, tiny::parallelogram({-1.5f, 0, 0.5f}, {1.499f, 0, 0}, {0, 0, -1}),
              tiny::diffuse(Rgb(0)));
    out.scene.lights = {sun_along(shaft.entering())};
    out.scene.cameras[0] = tiny::square_view({0.5f * shaft.width, y, 0}, {0, -1, 0},
                                             0.4f * shaft.width, 0.05f * shaft.width);
    out.expected = kDark / M_PI * std::sqrt(0.5) * shaft.passed();
    return out;
}

} // namespace

std::vector<ClosedForm> cast_forms()
{
    return {cast_through_a_slab(), cast_by_mirrors(2), cast_by_mirrors(3)};
}

} // namespace hipmap
