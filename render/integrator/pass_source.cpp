#include "render/integrator/pass_source.h"

#include "common/rays/camera_ray.h"
#include "common/stopwatch.h"
#include "render/integrator/path_tracer.h"

#include <tbb/combinable.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <memory>

namespace hipmap {

namespace {

constexpr int kTile = 16;

/// Of the work of a pass, what its photons are taken for in the progress shown.
constexpr double kPhotonShare = 0.2;

/// Light paths for each one that is aimed at specular surfaces besides: nearly all of those leave a
/// caustic photon, where few of the others would.
constexpr std::uint64_t kPathsPerCausticPath = 4;

/// Counts of one thread.
struct ThreadCounts {
    SearchStatistics caustic;
    SearchStatistics global;
    std::uint64_t dropped = 0;
};

struct PassMapSet {
    PhotonMaps caustic;
    PhotonMaps global;
};

/// One pass of eye paths.
class TileRenderer {
  public:
    TileRenderer(const PassMaps& maps, const RenderOptions& options, std::uint64_t pass)
        : maps_(maps), options_(options), pass_(pass), across_((options.width + kTile - 1) / kTile),
          down_((options.height + kTile - 1) / kTile)
    {
    }

    int tiles() const { return across_ * down_; }

    /// Writes the mean of the samples of each pixel of the tile.
    void render(int tile, PassImages& out, ThreadCounts& counts) const
    {
        EyeScratch scratch;
        const int x0 = tile % across_ * kTile, y0 = tile / across_ * kTile;
        for (int y = y0; y < std::min(y0 + kTile, options_.height); ++y)
            for (int x = x0; x < std::min(x0 + kTile, options_.width); ++x)
                pixel(x, y, scratch, out, counts.dropped);
        counts.caustic += scratch.caustic.search.statistics;
        counts.global += scratch.global.search.statistics;
    }

  private:
    void pixel(int x, int y, EyeScratch& scratch, PassImages& out, std::uint64_t& dropped) const
    {
        const std::uint64_t index = static_cast<std::uint64_t>(y) * options_.width + x;
        const Camera& camera = maps_.scene.scene.cameras[maps_.scene.scene.camera];
        const float aspect =
            static_cast<float>(options_.width) / static_cast<float>(options_.height);
        Rgb sum(0.0f);
        std::uint32_t kept = 0;
        for (std::uint32_t s = 0; s < options_.samples; ++s) {
            RandomSequence random(options_.seed, RandomStream::eye_paths, pass_,
                                  index * options_.samples + s);
            const glm::vec2 jitter = random.next2();
            const glm::vec2 picture((static_cast<float>(x) + jitter.x) / options_.width,
                                    (static_cast<float>(y) + jitter.y) / options_.height);
            const Ray ray = camera_ray(camera, picture, aspect);
            const Rgb sample = options_.integrator == Integrator::path
                                   ? trace_path(maps_.scene, ray, random)
                                   : trace_eye_path(maps_, ray, random, scratch);
            if (!is_finite(sample)) {
                ++dropped;
                continue;
            }
            sum += sample;
            ++kept;
        }
        const Rgb mean = sum / static_cast<float>(std::max(1u, kept));
        if (kept == 0 || !is_finite(mean))
            return;
        out.radiance.pixels[index] = mean;
        out.kept[index] = 1;
    }

    const PassMaps& maps_;
    const RenderOptions& options_;
    std::uint64_t pass_;
    int across_, down_;
};

void count_kind(KindStatistics& kind, const PhotonMaps& maps)
{
    kind.stored += maps.size;
    kind.shared_maps = maps.maps.size();
    kind.largest_map = maps.largest_map();
    kind.local_maps = maps.locals.maps.size() + maps.local_tier.maps.size();
    kind.group_maps = maps.groups.maps.size() + maps.group_tier.maps.size();
    kind.local_plan = maps.local_tier.plan;
    kind.group_plan = maps.group_tier.plan;
}

PassMapSet make_maps(const RenderScene& scene, const RenderOptions& options, std::uint64_t pass,
                     RenderStatistics& statistics)
{
    const Stopwatch watch;
    PhotonOptions photons{options.photons, options.seed, pass,
                          options.direct == DirectLight::photons,
                          options.photons / kPathsPerCausticPath};
    if (options.maps.mode == MapMode::none || options.integrator == Integrator::path)
        photons.paths = photons.caustic_paths = 0;
    TracedPhotons traced = trace_photons(scene, photons);
    statistics.emitted += traced.emitted;
    statistics.aimed += traced.aimed;
    statistics.dropped_photons += traced.dropped;
    statistics.cut_paths += traced.cut;
    statistics.power = traced.power;
    statistics.seconds_photons += watch.seconds();

    const Stopwatch building;
    MapOptions of_maps = options.maps;
    of_maps.directions = scene.directional;
    const auto build = [&](std::vector<Photon> of_kind) {
        return build_photon_maps(of_kind, scene.mesh(), scene.partition, of_maps);
    };
    PassMapSet maps;
    maps.caustic = build(std::move(traced.caustic)); // which it frees
    maps.global = build(std::move(traced.global));
    count_kind(statistics.caustic, maps.caustic);
    count_kind(statistics.global, maps.global);
    statistics.seconds_maps += building.seconds();
    statistics.processor_maps += building.processor_seconds();
    return maps;
}

/// False: stopped before every tile was done.
bool render_tiles(const TileRenderer& renderer, const PassControl& control, PassImages& out,
                  RenderStatistics& statistics)
{
    tbb::combinable<ThreadCounts> counts;
    std::atomic<int> done{0};
    tbb::parallel_for(0, renderer.tiles(), [&](int tile) {
        if (control.stop != nullptr && control.stop->load())
            return;
        renderer.render(tile, out, counts.local());
        const double part = static_cast<double>(++done) / renderer.tiles();
        if (control.progress)
            control.progress(kPhotonShare + (1 - kPhotonShare) * part);
    });
    counts.combine_each([&](const ThreadCounts& thread) {
        statistics.caustic.searches += thread.caustic;
        statistics.global.searches += thread.global;
        statistics.dropped_samples += thread.dropped;
    });
    return done == renderer.tiles();
}

RenderedPass render_pass(const RenderScene& scene, const MapSurfaces& surfaces,
                         const RenderOptions& options, std::uint64_t pass,
                         const PassControl& control, RenderStatistics& statistics)
{
    const PassMapSet maps = make_maps(scene, options, pass, statistics);
    if (control.progress)
        control.progress(kPhotonShare);
    const Stopwatch watch;
    RenderedPass out;
    out.images.radiance = Image(options.width, options.height);
    out.images.kept.resize(out.images.radiance.pixels.size());
    const PassMaps pass_maps{scene, surfaces, maps.caustic, maps.global, options.direct};
    const TileRenderer renderer(pass_maps, options, pass);
    out.whole = render_tiles(renderer, control, out.images, statistics);
    statistics.passes += out.whole ? 1 : 0;
    statistics.seconds_image += watch.seconds();
    statistics.processor_image += watch.processor_seconds();
    return out;
}

/// Of a small image by few photons.
double pilot_mean(const RenderScene& scene, const MapSurfaces& surfaces, RenderOptions options)
{
    constexpr int kPilotSide = 32;
    constexpr std::uint64_t kPilotShare = 16;
    options.width = std::min(options.width, kPilotSide);
    options.height = std::min(options.height, kPilotSide);
    options.samples = 1;
    options.photons /= kPilotShare;
    RenderStatistics ignored;
    const RenderedPass pilot = render_pass(scene, surfaces, options, kPilotPass, {}, ignored);
    double sum = 0;
    for (const Rgb& pixel : pilot.images.radiance.pixels)
        sum += double{pixel.x} + double{pixel.y} + double{pixel.z};
    return sum / (3 * static_cast<double>(pilot.images.radiance.pixels.size()));
}

} // namespace

PassSource make_pass_source(const RenderScene& scene, const RenderOptions& options,
                            RenderStatistics& statistics)
{
    const auto surfaces = std::make_shared<MapSurfaces>(scene.mesh(), scene.partition);
    PassSource source;
    source.width = options.width;
    source.height = options.height;
    source.pilot_mean = pilot_mean(scene, *surfaces, options);
    source.bias =
        options.integrator == Integrator::path ? BiasKnowledge::unbiased : BiasKnowledge::unknown;
    source.render = [&scene, &options, &statistics, surfaces](std::uint64_t pass,
                                                              const PassControl& control) {
        return render_pass(scene, *surfaces, options, pass, control, statistics);
    };
    return source;
}

} // namespace hipmap
