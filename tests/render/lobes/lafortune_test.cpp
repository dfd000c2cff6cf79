#include "render/lobes/lafortune.h"
#include "render/lobes/phong.h"
#include "tests/render/lobes/view_from.h"
#include "tests/support/lit_surface.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

double share_sent(const Lafortune& lobe, const LobeView& view)
{
    double sum = 0;
    tiny::over_sphere(400, [&](const glm::vec3& in, double solid_angle) {
        if (in.z > 0)
            sum += double{lobe.eval(view, in).x} * double{in.z} * solid_angle;
    });
    return sum;
}

} // namespace

TEST_CASE("Lafortune: values by hand", "[lobes]")
{
    const double pi = std::numbers::pi;
    const Lafortune lobe{Rgb(0.5f), 3, {-0.5f, 1, 0.25f}};
    const LobeView view = view_from({0.6f, 0, 0.8f});
    CHECK(lobe.eval(view, {-0.6f, 0, 0.8f}).x ==
          Approx(0.5 * 5 / (2 * pi) * std::pow(0.5 * 0.36 + 0.25 * 0.64, 3)));
    CHECK(lobe.eval(view, {0, 0.6f, 0.8f}).x ==
          Approx(0.5 * 5 / (2 * pi) * std::pow(0.25 * 0.64, 3)));
    CHECK(lobe.eval(view, {0.8f, 0, 0.6f}).x == 0); // -0.24 + 0.12
    const Lafortune back{Rgb(0.5f), 20, {1, 1, 1}};
    CHECK(back.eval(view, view.out).x == Approx(0.5 * 22 / (2 * pi)));
}

TEST_CASE("Lafortune: with the coefficients of a mirror it is Phong's lobe", "[lobes]")
{
    for (const float exponent : {0.0f, 2.0f, 50.0f, 500000.0f}) {
        const Phong phong{{0.2f, 0.6f, 0.4f}, exponent};
        const Lafortune lafortune{{0.2f, 0.6f, 0.4f}, exponent, {-1, -1, 1}};
        for (std::uint64_t i = 0; i < 200; ++i) {
            RandomSequence random(3, RandomStream::pictures, 0, i), same = random;
            const LobeView view =
                view_from(direction_from_cosine(0.1f + 0.9f * random.next(), 0.3f));
            same = random;
            const LobeSample drawn = phong.sample(view, random),
                             other = lafortune.sample(view, same);
            INFO("exponent " << exponent);
            CHECK(glm::distance(drawn.direction, other.direction) < 1e-5f);
            CHECK(drawn.weight.y == Approx(other.weight.y).margin(1e-5));
            CHECK(lafortune.eval(view, drawn.direction).y ==
                  Approx(phong.eval(view, drawn.direction).y).epsilon(3e-3));
            CHECK(lafortune.pdf(view, drawn.direction) ==
                  Approx(phong.pdf(view, drawn.direction)).epsilon(3e-3));
            CHECK(lafortune.albedo(view).y == Approx(phong.albedo(view).y));
        }
    }
}

TEST_CASE("Lafortune: the albedo is that of closed forms for exponents 0 and 1", "[lobes]")
{
    const double pi = std::numbers::pi;
    for (const glm::vec3& c : {glm::vec3(-1, -1, 1), glm::vec3(0.5f, 1, 0.3f), glm::vec3(-1, 1, 0)})
        for (const glm::vec3& out :
             {glm::vec3(0.6f, 0, 0.8f), glm::vec3(0.48f, 0.8f, 0.36f), glm::vec3(0, 0.8f, 0.6f)}) {
            const LobeView view = view_from(out);
            const double length = glm::length(c * out), cosine = c.z * out.z / length;
            const Lafortune even{Rgb(1), 0, c};
            INFO("coefficients " << c.x << ", " << c.y << ", " << c.z << ", height " << out.z);
            CHECK(share_sent(even, view) == Approx((1 + cosine) / 2).epsilon(0.004));
            CHECK(even.albedo(view).x == Approx((1 + cosine) / 2));
            const double angle = std::acos(std::min(cosine, 1.0));
            CHECK(share_sent({Rgb(1), 1, c}, view) ==
                  Approx(length * (std::sin(angle) + (pi - angle) * cosine) / pi).epsilon(0.002));
        }
}

TEST_CASE("Lafortune: where the coefficients leave no direction there is no light", "[lobes]")
{
    for (const float exponent : {0.0f, 4.0f}) {
        const Lafortune flat{Rgb(1), exponent, {-1, 1, 0}};
        const LobeView view = view_from({0, 0, 1});
        RandomSequence random(1, RandomStream::pictures, 0, 0);
        CHECK(flat.eval(view, {0.6f, 0, 0.8f}) == Rgb(0));
        CHECK(flat.pdf(view, {0.6f, 0, 0.8f}) == 0);
        CHECK(flat.sample(view, random).weight == Rgb(0));
        CHECK(flat.albedo(view) == Rgb(0));
    }
}

TEST_CASE("Lafortune: without a tangent, light goes by the mean of the first two coefficients",
          "[lobes]")
{
    const Lafortune brushed{Rgb(1), 4, {-1, -0.5f, 1}}, even{Rgb(1), 4, {-0.75f, -0.75f, 1}};
    CHECK(brushed.is_directed());
    CHECK_FALSE(even.is_directed());
    LobeView view = view_from({0.48f, 0.36f, 0.8f});
    const glm::vec3 in = {-0.48f, -0.6f, 0.64f};
    const float with_tangent = even.eval(view, in).x;
    view.tangent = glm::vec3(0);
    CHECK(brushed.eval(view, in).x == Approx(with_tangent));
    CHECK(even.eval(view, in).x == Approx(with_tangent));
}
