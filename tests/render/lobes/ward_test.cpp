#include "render/lobes/ward.h"
#include "tests/render/lobes/view_from.h"
#include "tests/support/lit_surface.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

/// A unit direction at a height above the surface and an azimuth from the tangent.
glm::vec3 direction_at(float height, float azimuth)
{
    const float flat = std::sqrt(1 - height * height);
    return {flat * std::cos(azimuth), flat * std::sin(azimuth), height};
}

double share_sent(const Ward& lobe, const glm::vec3& out)
{
    const LobeView view = view_from(out);
    double sum = 0;
    tiny::over_sphere(300, [&](const glm::vec3& in, double solid_angle) {
        if (in.z > 0)
            sum += double{lobe.eval(view, in).x} * double{in.z} * solid_angle;
    });
    return sum;
}

} // namespace

TEST_CASE("Ward: values by hand", "[lobes]")
{
    const double pi = std::numbers::pi;
    const Ward brushed{Rgb(0.5f), {0.4f, 0.2f}};
    const glm::vec3 up(0, 0, 1);
    CHECK(brushed.eval(view_from(up), up).x == Approx(0.5 / (4 * pi * 0.08)));
    CHECK(brushed.eval(view_from({0.6f, 0, 0.8f}), {-0.6f, 0, 0.8f}).x ==
          Approx(0.5 / (4 * pi * 0.08 * 0.64)));
    // The half vector of (0.6, 0, 0.8) and the normal has a slope of 1/3, and 0.9 of their lengths'
    // sum squared in its own.
    const double shape = 3.6 / std::pow(1.8, 4);
    CHECK(brushed.eval(view_from(up), {0.6f, 0, 0.8f}).x ==
          Approx(0.5 / (pi * 0.08) * shape * std::exp(-1 / (9 * 0.16))));
    CHECK(brushed.eval(view_from(up), {0, 0.6f, 0.8f}).x ==
          Approx(0.5 / (pi * 0.08) * shape * std::exp(-1 / (9 * 0.04))));
}

TEST_CASE("Ward: the albedo at normal incidence is that of the closed form", "[lobes]")
{
    for (const float slope : {0.05f, 0.2f, 0.5f, 1.0f}) {
        const double square = double{slope} * double{slope};
        const double exact = 1 - square * (1 - std::exp(-1 / square));
        const Ward lobe{Rgb(1), glm::vec2(slope)};
        INFO("slope " << slope);
        CHECK(share_sent(lobe, {0, 0, 1}) == Approx(exact).epsilon(0.002));
        CHECK(lobe.albedo(view_from({0, 0, 1})).x == Approx(exact));
    }
}

TEST_CASE("Ward: no direction gets more than the factor, and most of it towards grazing", "[lobes]")
{
    for (const glm::vec2& slopes : {glm::vec2(0.1f), glm::vec2(0.5f), glm::vec2(1),
                                    glm::vec2(1, 0.1f), glm::vec2(0.1f, 0.4f)})
        for (const float height : {1.0f, 0.8f, 0.5f, 0.2f, 0.05f})
            for (const float azimuth : {0.0f, 0.8f, 1.57f}) {
                const double sent = share_sent({Rgb(1), slopes}, direction_at(height, azimuth));
                INFO("slopes " << slopes.x << ", " << slopes.y << ", height " << height);
                CHECK(sent <= 1.002);
                CHECK(sent >= 0.36);
            }
    CHECK(share_sent({Rgb(1), glm::vec2(0.5f)}, direction_at(0.01f, 0)) ==
          Approx(0.9546).margin(0.004));
}

TEST_CASE("Ward: without a tangent, light spreads by the mean of the slopes", "[lobes]")
{
    const Ward brushed{Rgb(0.5f), {0.8f, 0.2f}}, even{Rgb(0.5f), {0.4f, 0.4f}};
    CHECK(brushed.is_directed());
    CHECK_FALSE(even.is_directed());
    LobeView view = view_from(direction_at(0.7f, 0.3f));
    const glm::vec3 in = direction_at(0.4f, 2.5f);
    const float with_tangent = even.eval(view, in).x;
    view.tangent = glm::vec3(0);
    CHECK(brushed.eval(view, in).x == Approx(with_tangent));
    CHECK(even.eval(view, in).x == Approx(with_tangent));
}
