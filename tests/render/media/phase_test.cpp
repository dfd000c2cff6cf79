#include "render/media/phase.h"
#include "tests/support/drawn_directions.h"
#include "tests/support/statistics.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

std::vector<PhaseFunction> phases()
{
    std::vector<PhaseFunction> out{{PhaseKind::isotropic, 0}};
    for (const PhaseKind kind : {PhaseKind::henyey_greenstein, PhaseKind::schlick})
        for (const float g : {-0.8f, -0.3f, 0.0f, 1e-6f, 0.5f, 0.85f})
            out.push_back({kind, g});
    return out;
}

} // namespace

TEST_CASE("phase functions: all light goes somewhere, and its mean cosine is g", "[media]")
{
    for (const PhaseFunction& phase : phases()) {
        constexpr int kSteps = 100'000;
        double sum = 0, cosines = 0;
        for (int i = 0; i < kSteps; ++i) {
            const double cosine = -1 + (i + 0.5) * 2 / kSteps;
            const double ring = 2 * M_PI * 2 / kSteps * phase_value(phase, float(cosine));
            sum += ring;
            cosines += ring * cosine;
        }
        INFO(int(phase.kind) << ", g = " << phase.g);
        CHECK(sum == Approx(1).epsilon(1e-4));
        if (phase.kind != PhaseKind::schlick)
            CHECK(cosines == Approx(phase.g).margin(1e-4));
        else // an approximation of it
            CHECK(std::abs(cosines - phase.g) < 0.1);
    }
}

TEST_CASE("phase functions: directions are drawn as they are dense", "[media]")
{
    const glm::vec3 back = glm::normalize(glm::vec3(0.3f, -0.5f, 0.7f));
    for (const PhaseFunction& phase : phases()) {
        INFO(int(phase.kind) << ", g = " << phase.g);
        const MediumStack inside{};
        const Interaction at = scattering_point({}, back, phase, inside);
        CHECK(std::abs(tiny::chi_square_z(at, Lobes::gathered)) < kMostZ);
        CHECK(is_black(scattered(at, back, Lobes::followed).value));
    }
}

TEST_CASE("phase functions: light goes forward for g above zero", "[media]")
{
    for (const PhaseKind kind : {PhaseKind::henyey_greenstein, PhaseKind::schlick}) {
        CHECK(phase_value({kind, 0.5f}, 1) > 2 * phase_value({kind, 0.5f}, 0));
        CHECK(phase_value({kind, 0.5f}, 0) > phase_value({kind, 0.5f}, -1));
    }
}
