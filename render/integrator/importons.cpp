#include "render/integrator/importons.h"

#include "render/integrator/pixel_samples.h"
#include "render/maps/gather.h"

#include <tbb/parallel_for.h>

#include <cmath>
#include <numeric>
#include <utility>

namespace hipmap {

namespace {

constexpr int kSide = 128; ///< pixels of the image that importons come from, at most
constexpr int kBlock = 8;  ///< pixels across that share a weight

/// Photons that a thread weighs at a time, at least.
constexpr std::size_t kPhotonsOfTask = 256;

/// Importons that give the density at a photon.
constexpr std::uint32_t kNeighbours = 16;

RenderOptions importon_options(RenderOptions options)
{
    const double scale = std::min(1.0, double{kSide} / std::max(options.width, options.height));
    options.width = std::max(1, static_cast<int>(options.width * scale));
    options.height = std::max(1, static_cast<int>(options.height * scale));
    options.crop = {};
    options.samples = 1;
    return options;
}

/// Radiance of the paths of all pixels, and importons of those of some rows.
struct PilotPicture {
    Image radiance;
    Part rows;
    std::vector<Importons> importons; ///< [pixels of the rows]
};

PilotPicture trace_picture(const RenderScene& scene, const RenderOptions& options,
                           const ImportonPath& trace, const PilotTeam& team)
{
    const auto width = static_cast<std::size_t>(options.width);
    PilotPicture out{Image(options.width, options.height),
                     team.part(static_cast<std::size_t>(options.height)),
                     {}};
    out.importons.resize(width * out.rows.size());
    std::vector<Rgb> radiance(out.importons.size());
    const SampleAllocation evenly;
    const PictureJob job{scene, options, kPilotPass, evenly};
    tbb::parallel_for(out.rows.begin, out.rows.end, [&](std::size_t row) {
        const auto y = static_cast<int>(row);
        for (int x = 0; x < options.width; ++x) {
            const std::uint64_t pixel = job.index_of(x, y);
            RandomSequence random = sample_sequence(job, RandomStream::eye_paths, pixel, 1, 0);
            const Ray ray = pixel_ray(job, x, y, random).ray;
            const std::size_t at = pixel - width * out.rows.begin;
            const Rgb found = trace(ray, random, out.importons[at]);
            radiance[at] = is_finite(found) ? found : Rgb(0);
        }
    });
    out.radiance.pixels = joined(team, std::move(radiance));
    return out;
}

/// Mean of the channels around a pixel.
double level_around(const Image& image, int x, int y)
{
    const int x0 = x / kBlock * kBlock, y0 = y / kBlock * kBlock;
    const int x1 = std::min(x0 + kBlock, image.width), y1 = std::min(y0 + kBlock, image.height);
    Rgb sum(0);
    for (int v = y0; v < y1; ++v)
        for (int u = x0; u < x1; ++u)
            sum += image.at(u, v);
    return double{sum_of_channels(sum)} / (3.0 * (x1 - x0) * (y1 - y0));
}

void append(std::vector<Photon>& to, const std::vector<Photon>& from, float weight)
{
    for (Photon importon : from) {
        importon.power *= weight;
        if (is_finite(importon.power) && max_channel(importon.power) > 0)
            to.push_back(importon);
    }
}

/// Importons around a point, by area.
struct ImportonDensity {
    Rgb weight{0.0f};
    double count = 0;
};

/// The density of importons over the whole disc: what boundaries hide of it would cost more to find
/// than a guide gains by it.
ImportonDensity density_around(const PhotonMaps& importons, const MapSurfaces& surfaces,
                               const PhotonQuery& query, SearchScratch& scratch)
{
    const NearestSum found = sum_photons(importons, surfaces.partition, query, scratch).nearest;
    if (found.photons == 0)
        return {};
    double area = surfaces.area_at(query.face);
    if (found.photons == importons.options.neighbours)
        area = std::min(area, disc_area(std::sqrt(found.farthest2)));
    return {per_area(importons.power_scale, glm::dvec3(found.power), area), found.photons / area};
}

/// What each photon is worth, and the noise that it brings.
struct PhotonValues {
    std::vector<double> worth, noise;
};

/// What the photons of a kind are read with.
struct KindOfPhotons {
    const PhotonMaps& importons;
    const RadiusField* radii; ///< null: not known
    float rays = 1;           ///< that share what one of them finds
};

/// The area over which the image reads a photon, in units of that of an importon, at least one.
double importons_in_disc(const KindOfPhotons& kind, const MapSurfaces& surfaces,
                         const PhotonQuery& query, double density)
{
    if (kind.radii == nullptr)
        return 1;
    const double area = std::min(double{surfaces.area_at(query.face)},
                                 disc_area(double{radius_at(*kind.radii, surfaces, query)}));
    return std::max(1.0, area * density);
}

/// The values of the photons of a kind.
PhotonValues values_of(const MapSurfaces& surfaces, const std::vector<Photon>& photons,
                       const KindOfPhotons& kind)
{
    PhotonValues out{std::vector<double>(photons.size()), std::vector<double>(photons.size())};
    using Range = tbb::blocked_range<std::size_t>;
    tbb::parallel_for(Range(0, photons.size(), kPhotonsOfTask), [&](const Range& range) {
        SearchScratch scratch;
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
            const PhotonQuery query = query_at(photons[i], surfaces);
            const ImportonDensity found = density_around(kind.importons, surfaces, query, scratch);
            const Rgb each = photons[i].power * found.weight;
            if (!is_finite(each) || is_black(each))
                continue;
            out.worth[i] = double{each.x} + double{each.y} + double{each.z};
            out.noise[i] = out.worth[i] * out.worth[i] /
                           (kind.rays * importons_in_disc(kind, surfaces, query, found.count));
        }
    });
    return out;
}

/// The worth of the photons of paths.  Sums are of one path alone, so that they are the same
/// whichever other paths are traced.
class SumsOfWorth {
  public:
    /// worth: of each photon.  kind: its place among those of paths.
    SumsOfWorth(std::vector<double> worth, std::uint64_t PhotonCounts::*kind,
                const std::vector<PhotonCounts>& after_path)
        : up_to_(std::move(worth)), kind_(kind)
    {
        std::uint64_t begin = 0;
        for (const PhotonCounts& after : after_path) {
            const auto first = up_to_.begin() + static_cast<std::ptrdiff_t>(begin);
            const auto end = up_to_.begin() + static_cast<std::ptrdiff_t>(after.*kind);
            std::partial_sum(first, end, first);
            begin = after.*kind;
        }
    }

    /// Returns that of the photons from one place on to another, of a path that begins at `path`.
    double between(const PhotonCounts& path, const PhotonCounts& from, const PhotonCounts& to) const
    {
        return before(path, to) - before(path, from);
    }

  private:
    double before(const PhotonCounts& path, const PhotonCounts& place) const
    {
        return place.*kind_ == path.*kind_ ? 0 : up_to_[place.*kind_ - 1];
    }

    std::vector<double> up_to_; ///< with each photon
    std::uint64_t PhotonCounts::*kind_;
};

/// Adds the noise of the photons of a kind to that of their paths.
void add_noise(const std::vector<double>& of_photons, std::uint64_t PhotonCounts::*kind,
               const std::vector<PhotonCounts>& after_path, std::vector<double>& of_paths)
{
    auto first = of_photons.begin();
    for (std::size_t path = 0; path < after_path.size(); ++path) {
        const auto end = of_photons.begin() + static_cast<std::ptrdiff_t>(after_path[path].*kind);
        of_paths[path] += std::accumulate(first, end, 0.0);
        first = end;
    }
}

/// The sum over all kinds, as that of SumsOfWorth.
double between(const std::vector<SumsOfWorth>& kinds, const PhotonCounts& path,
               const PhotonCounts& from, const PhotonCounts& to)
{
    double out = 0;
    for (const SumsOfWorth& kind : kinds)
        out += kind.between(path, from, to);
    return out;
}

} // namespace

Importons trace_importons(const RenderScene& scene, const RenderOptions& options,
                          const ImportonPath& trace, const PilotTeam& team)
{
    const RenderOptions small = importon_options(options);
    const PilotPicture picture = trace_picture(scene, small, trace, team);
    const double dark = 0.1 * mean_of(picture.radiance);
    const std::size_t begin = picture.rows.begin * static_cast<std::size_t>(small.width);
    Importons out;
    for (std::size_t pixel = 0; pixel < picture.radiance.pixels.size(); ++pixel) {
        const auto x = static_cast<int>(pixel) % small.width,
                   y = static_cast<int>(pixel) / small.width;
        const double level = level_around(picture.radiance, x, y);
        const auto weight =
            dark > 0 ? static_cast<float>(1 / std::sqrt(level * level + dark * dark)) : 1.0f;
        const Rgb& found = picture.radiance.pixels[pixel];
        out.light += (double{found.x} + double{found.y} + double{found.z}) * double{weight};
        if (pixel < begin || pixel - begin >= picture.importons.size())
            continue;
        const Importons& from = picture.importons[pixel - begin];
        append(out.caustic, from.caustic, weight);
        append(out.global, from.global, weight);
        append(out.indirect, from.indirect, weight);
    }
    for (std::vector<Photon> Importons::*kind :
         {&Importons::caustic, &Importons::global, &Importons::indirect})
        out.*kind = joined(team, std::move(out.*kind));
    return out;
}

std::vector<GatherRecord> trace_gather_rays(const RenderScene& scene, const RenderOptions& options,
                                            const SampleRange& of_pixel, const GatherPath& trace,
                                            const PilotTeam& team)
{
    const RenderOptions small = importon_options(options);
    const SampleAllocation evenly;
    const PictureJob job{scene, small, kPilotPass - 1, evenly};
    const Part own = team.part(static_cast<std::size_t>(small.height));
    std::vector<std::vector<GatherRecord>> rows(own.size());
    tbb::parallel_for(own.begin, own.end, [&](std::size_t row) {
        const auto y = static_cast<int>(row);
        for (int x = 0; x < small.width; ++x)
            for (std::uint32_t i = of_pixel.begin; i < of_pixel.end; ++i) {
                RandomSequence random =
                    sample_sequence(job, RandomStream::eye_paths, job.index_of(x, y), 0, i);
                trace(pixel_ray(job, x, y, random).ray, random, rows[row - own.begin]);
            }
    });
    std::vector<GatherRecord> out;
    for (const std::vector<GatherRecord>& row : rows)
        out.insert(out.end(), row.begin(), row.end());
    return joined(team, std::move(out));
}

PhotonWorth make_worth(const Importons& importons, const MapSurfaces& surfaces,
                       std::function<std::vector<Photon>(const TracedPhotons&)> weigh)
{
    const MapOptions options{.neighbours = kNeighbours};
    const auto build = [&](const std::vector<Photon>& of) {
        return build_photon_maps(of, surfaces.partition, options);
    };
    return {build(importons.caustic), build(importons.global), build(importons.indirect),
            std::move(weigh)};
}

WorthOfPaths worth_of_paths(const MappedScene& mapped, const PhotonWorth& worth,
                            const TracedPhotons& traced)
{
    const bool known = worth.radii != nullptr;
    const std::vector<PhotonCounts>& ends = traced.after_path;
    WorthOfPaths out;
    out.noise.resize(ends.size());
    std::vector<SumsOfWorth> worths;
    const auto add = [&](const std::vector<Photon>& photons, const PhotonMaps& importons,
                         std::uint64_t PhotonCounts::*kind, RadiusField FirstRadii::*radii,
                         float rays) {
        PhotonValues values = values_of(
            mapped.surfaces, photons, {importons, known ? &(worth.radii->*radii) : nullptr, rays});
        worths.emplace_back(std::move(values.worth), kind, ends);
        add_noise(values.noise, kind, ends, out.noise);
    };
    add(traced.caustic, worth.caustic, &PhotonCounts::caustic, &FirstRadii::caustic, 1);
    add(traced.global, worth.global, &PhotonCounts::global, &FirstRadii::global, worth.rays);
    add(worth.weigh(traced), worth.indirect, &PhotonCounts::bounces, &FirstRadii::indirect, 1);
    const auto start_of = [&](std::uint64_t path) {
        return path == 0 ? PhotonCounts{} : ends[path - 1];
    };
    for (std::size_t path = 0; path < ends.size(); ++path) {
        const PhotonCounts start = start_of(path);
        const double found = between(worths, start, start, ends[path]);
        out.paths.push_back(found);
        if (!known)
            out.noise[path] = found * found;
    }
    for (const PathArrival& arrival : traced.arrivals) {
        const double found = between(worths, start_of(arrival.path), arrival.before, arrival.after);
        if (arrival.power > 0)
            out.arrivals.push_back({arrival.at, static_cast<float>(found / double{arrival.power}),
                                    arrival.power, arrival.splits});
    }
    return out;
}

} // namespace hipmap
