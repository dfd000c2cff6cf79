#include "bench/gathered_image.h"

#include "common/command_line/command_line.h"
#include "common/command_line/picture_size.h"
#include "common/rays/camera_ray.h"

#include <cmath>
#include <ctime>

namespace hipmap {

namespace {

/// The neighbours of a reference for each one of the images.
constexpr std::uint32_t kReferenceNeighbours = 8;

/// A pixel gets so much of its light from caustic photons, at least, to count as lit by them.
constexpr float kCausticShare = 0.1f;

/// Processor seconds of this thread.
double thread_seconds()
{
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

bool is_rendered(const PhotonStudy& study, std::size_t pixel)
{
    const auto width = static_cast<std::size_t>(study.options.width);
    const std::size_t band = pixel / width / PhotonStudy::kBandRows;
    return band % static_cast<std::size_t>(study.every) == 0;
}

void render_all(const PhotonStudy& study, GatheredImage& image)
{
    for (int band = 0; band < study.bands(); ++band)
        render_band(study, band, image);
}

/// Sums of square differences and of the reference over some pixels.
struct ErrorSum {
    double square = 0, reference = 0;
    std::size_t count = 0;

    void add(const Rgb& found, const Rgb& wanted)
    {
        const Rgb off = found - wanted;
        square += glm::dot(off, off) / 3;
        reference += (wanted.x + wanted.y + wanted.z) / 3;
        ++count;
    }
    double relative() const
    {
        const double n = static_cast<double>(count);
        return reference > 0 ? std::sqrt(square / n) / (reference / n) : 0;
    }
};

} // namespace

PhotonStudy::PhotonStudy(const RenderScene& of, const ImagePlan& plan)
    : scene(of), surfaces(of.mesh(), of.partition), every(plan.every)
{
    const float aspect = of.scene.cameras[of.scene.camera].aspect;
    const PictureSize size = complete_size({plan.width, 0}, aspect);
    options.width = size.width;
    options.height = size.height;
    options.direct = DirectLight::photons;
    options.maps.neighbours = plan.neighbours;
}

void PhotonStudy::trace(std::uint64_t paths)
{
    options.photons = paths;
    traced = trace_photons(scene, photon_options(scene, options, 0));
}

void PhotonStudy::join()
{
    together = traced.global;
    together.insert(together.end(), traced.caustic.begin(), traced.caustic.end());
}

double PhotonStudy::share() const
{
    int rows = 0;
    for (int band = 0; band < bands(); band += every)
        rows += std::min(kBandRows, options.height - band * kBandRows);
    return static_cast<double>(rows) / options.height;
}

GatheredImage build_maps(const PhotonStudy& study, const MapSetting& setting)
{
    const MappedScene mapped{study.scene, study.surfaces};
    const auto of = [&](const std::vector<Photon>& photons, KindStatistics& kind) {
        return build_maps(mapped, photons, {study.options.maps, setting.options}, kind);
    };
    static const std::vector<Photon> kNoPhotons;
    GatheredImage out;
    const Stopwatch watch;
    out.caustic = of(setting.together ? kNoPhotons : study.traced.caustic, out.caustic_kind);
    out.global = of(setting.together ? study.together : study.traced.global, out.global_kind);
    out.build_s = watch.processor_seconds();
    out.pixels.resize(static_cast<std::size_t>(study.options.width) *
                      static_cast<std::size_t>(study.options.height));
    return out;
}

GatheredImage without_photons(const PhotonStudy& study)
{
    PhotonStudy empty(study.scene,
                      {study.options.width, study.every, study.options.maps.neighbours});
    return build_maps(empty, {});
}

void render_band(const PhotonStudy& study, int band, GatheredImage& image)
{
    const RenderOptions& options = study.options;
    const Camera& camera = study.scene.scene.cameras[study.scene.scene.camera];
    const PassMaps maps{study.scene, study.surfaces, image.caustic, image.global, options.direct};
    const glm::vec2 size(options.width, options.height);
    const int first = band * PhotonStudy::kBandRows;
    const int last = std::min(first + PhotonStudy::kBandRows, options.height);
    const double start = thread_seconds();
    for (int y = first; y < last; ++y)
        for (int x = 0; x < options.width; ++x) {
            const std::size_t pixel =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(options.width) +
                static_cast<std::size_t>(x);
            RandomSequence random(options.seed, RandomStream::eye_paths, 0, pixel);
            const glm::vec2 picture = (glm::vec2(x, y) + 0.5f) / size;
            image.pixels[pixel] = trace_eye_path(maps, camera_ray(camera, picture, size.x / size.y),
                                                 SeenLights::left_out, random, image.scratch);
        }
    image.image_s += thread_seconds() - start;
}

void make_reference(PhotonStudy& study, std::uint64_t paths)
{
    const std::uint32_t neighbours = study.options.maps.neighbours;
    study.options.maps.neighbours = kReferenceNeighbours * neighbours;
    study.trace(paths);
    GatheredImage all = build_maps(study, {});
    render_all(study, all);
    study.reference = std::move(all.pixels);
    study.traced.global.clear();
    GatheredImage caustic = build_maps(study, {});
    render_all(study, caustic);
    study.reference_caustic = std::move(caustic.pixels);
    study.options.maps.neighbours = neighbours;
}

std::array<double, 2> relative_errors(const PhotonStudy& study, const GatheredImage& image)
{
    ErrorSum all, lit_by_caustics;
    for (std::size_t pixel = 0; pixel < image.pixels.size(); ++pixel) {
        if (!is_rendered(study, pixel))
            continue;
        const Rgb& wanted = study.reference[pixel];
        all.add(image.pixels[pixel], wanted);
        const Rgb& caustic = study.reference_caustic[pixel];
        if (caustic.x + caustic.y + caustic.z >= kCausticShare * (wanted.x + wanted.y + wanted.z) &&
            caustic.x + caustic.y + caustic.z > 0)
            lit_by_caustics.add(image.pixels[pixel], wanted);
    }
    return {all.relative(), lit_by_caustics.relative()};
}

} // namespace hipmap
