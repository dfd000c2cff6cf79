#include "experiments/rivals/illumination_map.h"

#include "experiments/rivals/face_cells.h"
#include "experiments/rivals/pixels.h"
#include "experiments/rivals/seen_surface.h"
#include "render/photons/trace_photons.h"

namespace hipmap {

namespace {

constexpr std::uint64_t kPathsAtOnce = 100'000; // so that photons take little memory
constexpr std::uint64_t kAimedShare = 4;        // a path in so many is aimed at specular surfaces

void add_power(const RenderScene& scene, const FaceCells& cells, const std::vector<Photon>& photons,
               std::vector<Rgb>& power)
{
    for (const Photon& photon : photons) {
        const glm::vec2 at = barycentric_of(scene.mesh(), photon.face, photon.position);
        power[2 * std::size_t{cell_at(cells, photon.face, at)} + photon.side] += photon.power;
    }
}

/// Returns the irradiance of caustic and indirect light by cell and side, W/m2.
std::vector<Rgb> trace_irradiance(const RenderScene& scene, const FaceCells& cells,
                                  const RivalSettings& settings)
{
    std::vector<Rgb> out(2 * cells.count(), Rgb(0));
    PhotonOptions options;
    options.seed = settings.seed;
    const std::uint64_t passes = (settings.rays + kPathsAtOnce - 1) / kPathsAtOnce;
    for (options.pass = 0; options.pass < passes; ++options.pass) {
        options.paths = settings.rays / passes;
        options.caustic_paths = options.paths / kAimedShare;
        const TracedPhotons photons = trace_photons(scene, options);
        add_power(scene, cells, photons.global, out);
        add_power(scene, cells, photons.caustic, out);
    }
    for (std::uint32_t cell = 0; cell < cells.count(); ++cell) {
        const FaceId face = cells.face_of_cell[cell];
        const double area = face_area(scene.mesh(), face) /
                            (static_cast<double>(cells.across[face]) * cells.across[face]);
        for (std::size_t side = 0; side < 2; ++side)
            out[2 * std::size_t{cell} + side] *=
                area > 0 ? static_cast<float>(1 / (area * static_cast<double>(passes))) : 0;
    }
    return out;
}

} // namespace

RivalImage render_illumination_map(const RenderScene& scene, const RivalSettings& settings)
{
    RivalImage out;
    const Stopwatch preparing;
    const FaceCells cells = divide_faces(scene.mesh(), settings.cells);
    const std::vector<Rgb> irradiance =
        values_of_corners(cells, trace_irradiance(scene, cells, settings));
    out.prepared.add(preparing);
    out.stored = irradiance.size() * sizeof(Rgb);
    const Stopwatch rendering;
    out.image = render_pixels(scene, settings, [&](const Ray& ray, RandomSequence& random) {
        return see_surfaces(scene, ray, random,
                            [&](const Interaction& at, const RayHit& hit, RandomSequence& more) {
                                return direct_light(scene, at, more) +
                                       at.bsdf().diffuse / kPi *
                                           smooth_value(cells, irradiance, hit, at.side);
                            });
    });
    out.rendered.add(rendering);
    return out;
}

} // namespace hipmap
