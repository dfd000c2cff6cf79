#include "common/math/sampling.h"
#include "render/lobes/lobe.h"
#include "tests/support/lit_surface.h"
#include "tests/support/statistics.h"

#include <catch2/catch.hpp>

#include <array>

using namespace hipmap;

namespace {

constexpr Reflectance kGold{{1, 0.8f, 0.3f}, Rgb(1)};

/// At least one of each kind that spreads light.
const std::vector<Lobe> kLobes{
    Lambert{{0.8f, 0.5f, 0.2f}},
    Burley{{0.8f, 0.5f, 0.2f}, {0.9f}},
    DiffuseTransmission{{0.3f, 0.6f, 0.9f}},
    Sheen{{0.9f, 0.4f, 0.7f}, 0.4f},
    MicrofacetReflection{kGold, {0.2f}},
    MicrofacetReflection{kGold, {0.15f, 0.6f}},
    MicrofacetReflection{kGold, {0.5f}, Rgb(0.1f)},
    RoughDielectric{0.7f, {0.9f, 0.8f, 0.7f}, Rgb(1), {0.3f}},
    Phong{{0.2f, 0.6f, 0.4f}, 12},
    Schlick{kGold, 0.6f, 0.4f},
    OrenNayar{{0.8f, 0.5f, 0.2f}, {0.9f}},
    Ward{{0.2f, 0.6f, 0.4f}, {0.3f, 0.3f}},
    Ward{{0.9f, 1, 0.4f}, {0.15f, 0.8f}},
    Lafortune{{0.2f, 0.6f, 0.4f}, 12, {-1, -0.6f, 0.8f}},
    Lafortune{{0.9f, 1, 0.4f}, 5, {1, 1, 1}},
    Lafortune{{0.2f, 0.6f, 0.4f}, 0, {-1, 0.5f, 0}},
};

bool spreads(const Lobe& lobe)
{
    return std::visit([]<typename Kind>(const Kind&) { return SpreadLobe<Kind>; }, lobe);
}

template <std::size_t... kind>
std::array<bool, sizeof...(kind)> which_spread(std::index_sequence<kind...>)
{
    return {SpreadLobe<std::variant_alternative_t<kind, Lobe>>...};
}

LobeView view_through(const glm::vec3& out, bool solid = true)
{
    return {{0, 0, 1}, out, out.z, {0.6f, 0.8f, 0}, 1.5f, solid};
}

const glm::vec3 kOuts[] = {glm::normalize(glm::vec3(0.1f, 0, 1)),
                           glm::normalize(glm::vec3(0.7f, -0.4f, 0.6f)),
                           glm::normalize(glm::vec3(-1, 0.2f, 0.25f))};

} // namespace

TEST_CASE("Oren-Nayar: closed values, and brighter back towards the light", "[lobes]")
{
    const OrenNayar smooth{Rgb(0.5f), {0}}, rough{Rgb(0.5f), {1}};
    const LobeView above = view_through({0, 0, 1}), aslant = view_through({0.8f, 0, 0.6f});
    const float scale = 1 / (1 + 0.5f - 2 / (3 * kPi));
    CHECK(smooth.shape(aslant, {-0.8f, 0, 0.6f}) == 1);
    CHECK(rough.shape(above, {0, 0, 1}) == Approx(scale));
    CHECK(rough.shape(aslant, {0.8f, 0, 0.6f}) == Approx(scale * (1 + 0.64f / 0.6f)));
    CHECK(rough.shape(aslant, {-0.8f, 0, 0.6f}) == Approx(scale * (1 - 0.64f)));
}

TEST_CASE("lobes: every kind that spreads light is tested here", "[lobes]")
{
    const auto spread = which_spread(std::make_index_sequence<std::variant_size_v<Lobe>>());
    std::array<bool, spread.size()> tested{};
    for (const Lobe& lobe : kLobes) {
        CHECK(spreads(lobe));
        tested[lobe.index()] = true;
    }
    CHECK(tested == spread);
}

TEST_CASE("lobes: the mean weight is the integral of f, and the pdf that of the draws", "[lobes]")
{
    for (const Lobe& lobe : kLobes)
        for (const glm::vec3& out : kOuts) {
            const LobeView view = view_through(out);
            double integral = 0, density = 0;
            tiny::over_sphere(250, [&](const glm::vec3& in, double solid_angle) {
                if (in.z < 0 && !transmits(lobe))
                    return;
                integral += double{eval(lobe, view, in).y * std::abs(in.z)} * solid_angle;
                density += double{pdf(lobe, view, in)} * solid_angle;
            });
            RunningMean weights;
            int found = 0;
            constexpr int kDraws = 20000;
            for (std::uint64_t i = 0; i < kDraws; ++i) {
                RandomSequence random(5, RandomStream::pictures, 0, i);
                const LobeSample drawn = sample(lobe, view, random);
                weights.add(drawn.weight.y / (drawn.eta * drawn.eta));
                found += is_black(drawn.weight) ? 0 : 1;
            }
            INFO("kind " << lobe.index() << ", height " << out.z);
            CHECK(std::abs(weights.mean() - integral) < 0.003 + kMostZ * weights.standard_error());
            CHECK(density == Approx(static_cast<double>(found) / kDraws).margin(0.02));
        }
}

TEST_CASE("lobes: a weight drawn is f cos over the pdf", "[lobes]")
{
    for (const Lobe& lobe : kLobes)
        for (std::uint64_t i = 0; i < 300; ++i) {
            RandomSequence random(7, RandomStream::pictures, 0, i);
            const LobeView view = view_through(kOuts[i % 3]);
            const LobeSample drawn = sample(lobe, view, random);
            if (is_black(drawn.weight))
                continue;
            const Rgb f = eval(lobe, view, drawn.direction);
            const float scale = std::abs(drawn.direction.z) * drawn.eta * drawn.eta /
                                pdf(lobe, view, drawn.direction);
            INFO("kind " << lobe.index());
            CHECK(f.x * scale == Approx(drawn.weight.x).epsilon(2e-3));
        }
}

TEST_CASE("lobes: light takes the same way back", "[lobes]")
{
    for (const Lobe& lobe : kLobes)
        for (std::uint64_t i = 0; i < 500; ++i) {
            RandomSequence random(11, RandomStream::pictures, 0, i);
            const auto above = [&] {
                return direction_from_cosine(0.05f + 0.95f * random.next(), random.next());
            };
            const glm::vec3 a = above(), b = above();
            INFO("kind " << lobe.index());
            CHECK(eval(lobe, view_through(a), b).y ==
                  Approx(eval(lobe, view_through(b), a).y).epsilon(2e-3).margin(1e-5));
        }
}

TEST_CASE("lobes: no lobe sends on more than it receives, and the albedo is near that", "[lobes]")
{
    for (const Lobe& lobe : kLobes)
        for (const glm::vec3& out : kOuts) {
            const LobeView view = view_through(out, false);
            glm::dvec3 sent(0.0);
            tiny::over_sphere(250, [&](const glm::vec3& in, double solid_angle) {
                if (in.z > 0 || transmits(lobe))
                    sent += glm::dvec3(eval(lobe, view, in)) * double{std::abs(in.z)} * solid_angle;
            });
            INFO("kind " << lobe.index() << ", height " << out.z);
            CHECK(std::max({sent.x, sent.y, sent.z}) <= 1.005);
            CHECK(albedo(lobe, view).y > 0.5 * sent.y);
            CHECK(albedo(lobe, view).y < 2.5 * sent.y + 0.01);
        }
}
