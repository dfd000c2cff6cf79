#include "tests/closed_forms/find_forms.h"

#include "render/integrator/integrators.h"
#include "tests/support/fresnel.h"
#include "tests/support/tiny_rooms.h"

#include <algorithm>

namespace hipmap {

namespace {

/// Relative error of a product of some numbers in float: 16 units in the last place.
constexpr double kRounding = 0x1p-20;

bool reads_photons(const ClosedForm& form, const Method& method)
{
    return form.read == PhotonsRead::others || form.read == PhotonsRead::media ||
           (form.read == PhotonsRead::direct && method.direct == DirectLight::photons);
}

/// docs/photon_maps.md (2)
double least_of(const ClosedForm& form, const Method& method)
{
    const bool nearest = method.integrator == Integrator::direct &&
                         form.read != PhotonsRead::media && reads_photons(form, method);
    return form.expected * (nearest ? (kNeighbours - 1) / (kNeighbours - 0.5) : 1);
}

RenderOptions options_for(const ClosedForm& form, const Method& method)
{
    RenderOptions options;
    options.integrator = method.integrator;
    options.direct = method.direct;
    options.indirect = method.indirect;
    options.width = options.height = 16;
    options.filter = PixelFilter::box; // the mean of such pixels is that of the picture
    options.photons = reads_photons(form, method) ? form.photons : 1000;
    options.maps.neighbours = kNeighbours;
    options.seed = 1;
    return options;
}

/// A spot that emits on the middle of a glass ball in a diffuse room; at the rim facets differ most
/// from a ball.
struct LitBall {
    static constexpr double kRadius = 0.2, kDistance = 0.5, kIndex = 1.5;
    SceneSpotLight light;

    LitBall()
    {
        light.position = {0, kDistance - 0.2, 0};
        light.direction = {0, -1, 0};
        light.intensity = Rgb(1);
        light.cos_inner = std::cos(0.15f);
        light.cos_outer = std::cos(0.24f);
    }

    Scene scene(const Rgb& absorption) const
    {
        Scene scene = tiny::box(tiny::diffuse(Rgb(0.5f)));
        TriangleMesh ball = tiny::fine_ball(kRadius);
        tiny::move(ball, {0, -0.2f, 0});
        tiny::add(scene, ball, tiny::glass(kIndex));
        scene.materials.back().absorption = absorption;
        scene.lights = {light};
        return scene;
    }

    /// Power that leaves the ball, by midpoints of equal solid angle.
    double leaving(double absorption) const
    {
        constexpr int kRings = 20'000;
        const double inner = light.cos_inner, outer = light.cos_outer;
        double sum = 0;
        for (int i = 0; i < kRings; ++i) {
            const double cosine = 1 - (1 - outer) * (i + 0.5) / kRings;
            const double t = std::min(1.0, (cosine - outer) / (inner - outer));
            const double offset = kDistance / kRadius * std::sqrt(1 - cosine * cosine);
            sum += t * t * out_of_ball_at(offset, kIndex, kRadius * absorption);
        }
        return 2 * M_PI * (1 - outer) * sum / kRings;
    }
};

double power_of_caustics(const RenderScene& scene, const PhotonOptions& options)
{
    double sum = 0;
    for (const Photon& photon : trace_photons(scene, options).caustic)
        sum += (double{photon.power.x} + photon.power.y + photon.power.z) / 3;
    return sum;
}

} // namespace

std::vector<FoundForm> find_form(const ClosedForm& form, const Method& method, std::uint64_t passes)
{
    const FoundForm row{form.name,     form.formula,           method.name,
                        form.expected, least_of(form, method), {}};
    std::vector<FoundForm> out{row};
    out[0].why_not =
        method.integrator == Integrator::path ? form.why_not_path : form.why_not_photons;
    if (!out[0].why_not.empty())
        return out;
    const auto ready = tiny::ready(form.scene);
    const RenderOptions options = options_for(form, method);
    RenderStatistics ignored;
    const PassSource source = make_pass_source(*ready->render, options, ignored);
    if (source.bias == BiasKnowledge::from_radii) {
        out.resize(3, row);
        out[1].method += ", radii / √2";
        out[2].method += ", radii / 2";
    }
    for (std::uint64_t pass = 0; pass < passes; ++pass) {
        const PassImages images = source.render(pass, {}).images;
        out[0].found.add(mean_of(images.radiance));
        if (out.size() == 3) {
            out[1].found.add(mean_of(images.narrow));
            out[2].found.add(mean_of(images.narrower));
        }
    }
    return out;
}

std::vector<FoundForm> find_power_from_glass(std::uint64_t passes)
{
    constexpr std::uint64_t kPaths = 2000;
    const LitBall form;
    std::vector<FoundForm> out;
    for (const Rgb& absorption : {Rgb(0), Rgb(2, 5, 10)}) {
        const auto ready = tiny::ready(form.scene(absorption));
        const bool clear = is_black(absorption);
        const std::string name =
            clear ? "power that leaves a clear ball" : "power that leaves a coloured ball";
        double expected = 0;
        for (int c = 0; c < 3; ++c)
            expected += form.leaving(absorption[c]) / 3;
        FoundForm plain{name,      clear ? "∫ I" : "∫ I (R + (1 - R)² a/(1 - R a))",
                        "photons", expected,
                        expected,  {}};
        FoundForm aimed = plain;
        aimed.method = "photons, aimed";
        for (std::uint64_t pass = 0; pass < passes; ++pass) {
            plain.found.add(power_of_caustics(*ready->render, {kPaths, 1, pass, false, 0}));
            aimed.found.add(power_of_caustics(*ready->render, {1, 1, pass, false, kPaths}));
        }
        out.push_back(plain);
        out.push_back(aimed);
    }
    return out;
}

double z_score(const FoundForm& found)
{
    const double error = std::hypot(found.found.standard_error(), kRounding * found.expected);
    const double mean = found.found.mean();
    const double t = (mean - std::clamp(mean, found.least, found.expected)) / error;
    const auto freedom = static_cast<double>(found.found.count()) - 1;
    const double z =
        std::sqrt(freedom * std::log1p(t * t / freedom)) * (8 * freedom + 1) / (8 * freedom + 3);
    return std::copysign(z, t);
}

} // namespace hipmap
