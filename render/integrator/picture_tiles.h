#pragma once

#include "common/stopwatch.h"
#include "render/integrator/coarse_image.h"
#include "render/integrator/pixel_samples.h"

#include <tbb/parallel_for.h>

#include <mutex>

namespace hipmap {

inline constexpr int kTile = 16;

/// The sums that the samples of a tile add to its pixels and to those around it.
template <std::size_t images>
struct TileSums {
    static constexpr int kSide = kTile + 2;

    std::vector<Samples<images>> values = std::vector<Samples<images>>(kSide * kSide);
    std::vector<float> weights = std::vector<float>(kSide * kSide);
    std::uint64_t dropped = 0; ///< samples left out because they were not finite

    /// Adds the samples around pixel x, y of the tile.
    void add(int x, int y, const FilteredSamples<images>& samples)
    {
        for (int i = 0; i < 9; ++i) {
            const auto at = static_cast<std::size_t>((y + i / 3) * kSide + x + i % 3);
            const auto from = static_cast<std::size_t>(i);
            weights[at] += samples.weights[from];
            for (std::size_t image = 0; image < images; ++image)
                values[at][image] += samples.values[from][image];
        }
    }
};

/// The tiles of an image that hold the pixels to render or pixels next to these, whose samples
/// count in them.
struct TileGrid {
    PixelRect rendered; ///< pixels of the image
    PixelRect traced;   ///< these, and those next to them
    PixelRect tiles; ///< of the tiles of the whole image, which do not depend on what is rendered

    int across() const { return tiles.width(); }
    int count() const { return tiles.width() * tiles.height(); }
};

/// Returns the grid; groups of which a pixel is traced are traced whole.
inline TileGrid tile_grid(const PictureJob& job)
{
    const RenderOptions& options = job.options;
    const PixelRect rendered = rendered_pixels(options);
    PixelRect traced = {std::max(0, rendered.x0 - 1), std::max(0, rendered.y0 - 1),
                        std::min(rendered.x1 + 1, options.width),
                        std::min(rendered.y1 + 1, options.height)};
    const PixelRect tiles = {traced.x0 / kTile, traced.y0 / kTile, (traced.x1 + kTile - 1) / kTile,
                             (traced.y1 + kTile - 1) / kTile};
    const PixelGroups& groups = job.groups;
    traced.x0 = std::max(groups.begin_x(traced.x0), tiles.x0 * kTile);
    traced.y0 = std::max(groups.begin_y(traced.y0), tiles.y0 * kTile);
    traced.x1 =
        std::min({groups.begin_x(traced.x1 - 1) + groups.across, tiles.x1 * kTile, options.width});
    traced.y1 =
        std::min({groups.begin_y(traced.y1 - 1) + groups.down, tiles.y1 * kTile, options.height});
    return {rendered, traced, tiles};
}

/// What an integrator does with the samples of a tile: `trace(ray, seen, random, scratch)` returns
/// the Samples of a ray, `finish(rows, scratch)` adds to the samples of whole groups of pixels, and
/// `count(scratch)` receives the counts of each tile, one at a time.
template <typename Trace, typename Finish, typename Count>
struct TileTracer {
    Trace trace;
    Finish finish;
    Count count;
};

/// Traces the samples of the rows' pixels.
template <std::size_t images, typename Scratch, typename Tracer>
void trace_rows(const PictureJob& job, const Tracer& tracer, Scratch& scratch,
                TracedRows<images>& rows)
{
    rows.begins.assign(1, 0);
    rows.samples.clear();
    for (int y = rows.pixels.y0; y < rows.pixels.y1; ++y)
        for (int x = rows.pixels.x0; x < rows.pixels.x1; ++x) {
            trace_pixel(job, {x, y}, tracer.trace, scratch, rows.samples);
            rows.begins.push_back(static_cast<std::uint32_t>(rows.samples.size()));
        }
}

/// Filters the samples into the sums of the tile that begins at `tile`.
template <std::size_t images>
void add_rows(const PictureJob& job, const TracedRows<traced_images<images>>& rows,
              const glm::ivec2& tile, TileSums<images>& sums)
{
    for (int y = rows.pixels.y0; y < rows.pixels.y1; ++y)
        for (int x = rows.pixels.x0; x < rows.pixels.x1; ++x) {
            const Part own = rows.samples_of(x, y);
            const auto filtered = filter_pixel<images>(
                job, x, y, std::span(rows.samples).subspan(own.begin, own.size()));
            sums.dropped += own.size() - filtered.kept;
            sums.add(x - tile.x, y - tile.y, filtered);
        }
}

/// Renders the traced pixels of a tile of 16 x 16; tile: its index in the grid.
template <std::size_t images, typename Scratch, typename Tracer>
TileSums<images> render_tile(const PictureJob& job, const TileGrid& grid, int tile,
                             const Tracer& tracer, Scratch& scratch)
{
    const int x0 = (grid.tiles.x0 + tile % grid.across()) * kTile;
    const int y0 = (grid.tiles.y0 + tile / grid.across()) * kTile;
    const PixelRect part = {std::max(x0, grid.traced.x0), std::max(y0, grid.traced.y0),
                            std::min(x0 + kTile, grid.traced.x1),
                            std::min(y0 + kTile, grid.traced.y1)};
    TileSums<images> sums;
    TracedRows<traced_images<images>> rows;
    for (int y = part.y0; y < part.y1; y = rows.pixels.y1) {
        rows.pixels = {part.x0, y, part.x1,
                       std::min(job.groups.begin_y(y) + job.groups.down, part.y1)};
        trace_rows(job, tracer, scratch, rows);
        tracer.finish(rows, scratch);
        add_rows(job, rows, {x0, y0}, sums);
    }
    return sums;
}

/// Sums the values and weights that all tiles contribute to the rendered pixel x, y, in the order
/// of the tiles.
template <std::size_t images>
Samples<images> gather_tiles(const TileGrid& grid, const std::vector<TileSums<images>>& tiles,
                             int x, int y, float& weight)
{
    Samples<images> sum{};
    weight = 0;
    const PixelRect& traced = grid.traced;
    for (int v = std::max(traced.y0, y - 1) / kTile; v <= std::min(y + 1, traced.y1 - 1) / kTile;
         ++v)
        for (int u = std::max(traced.x0, x - 1) / kTile;
             u <= std::min(x + 1, traced.x1 - 1) / kTile; ++u) {
            const TileSums<images>& tile = tiles[static_cast<std::size_t>(
                (v - grid.tiles.y0) * grid.across() + u - grid.tiles.x0)];
            const auto at = static_cast<std::size_t>((y - v * kTile + 1) * TileSums<images>::kSide +
                                                     x - u * kTile + 1);
            weight += tile.weights[at];
            for (std::size_t i = 0; i < images; ++i)
                sum[i] += tile.values[at][i];
        }
    return sum;
}

/// Makes images from the sums of the tiles, docs/error.md (17).  A pixel without weight, or with
/// values that are not finite, is not kept.
template <std::size_t images>
PassImages images_of(const TileGrid& grid, const std::vector<TileSums<images>>& tiles)
{
    PassImages out;
    const PixelRect& pixels = grid.rendered;
    out.radiance = Image(pixels.width(), pixels.height());
    if (images >= 3)
        out.narrow = out.narrower = out.radiance;
    if (has_cut<images>)
        out.cut = out.radiance;
    out.kept.assign(out.radiance.pixels.size(), 0);
    tbb::parallel_for(0, pixels.height(), [&](int y) {
        for (int x = 0; x < pixels.width(); ++x) {
            float weight = 0;
            Samples<images> mean = gather_tiles(grid, tiles, pixels.x0 + x, pixels.y0 + y, weight);
            for (Rgb& value : mean)
                value /= weight;
            if (!(weight > 0) || !are_finite(mean))
                continue;
            out.radiance.at(x, y) = mean[0];
            if constexpr (images >= 3) {
                out.narrow.at(x, y) = mean[1];
                out.narrower.at(x, y) = mean[2];
            }
            if constexpr (has_cut<images>)
                out.cut.at(x, y) = mean[images - 1];
            out.kept[static_cast<std::size_t>(y) * pixels.width() + x] = 1;
        }
    });
    return out;
}

/// Renders the images of a pass tile by tile, in parallel.  A pixel without a finite sample around
/// it, or in a tile that a stop left out, is not kept. Adds passes, samples dropped and time to the
/// statistics.
template <std::size_t images, typename Scratch, typename Tracer>
RenderedPass render_tiles(const PictureJob& job, const PassControl& control,
                          RenderStatistics& statistics, const Tracer& tracer)
{
    static_assert(images >= 1 && images <= 4);
    const Stopwatch watch;
    RenderedPass out;
    const TileGrid grid = tile_grid(job);
    const int tiles = grid.count();
    std::vector<TileSums<images>> sums(static_cast<std::size_t>(tiles));
    std::mutex mutex;
    int done = 0;
    tbb::parallel_for(0, tiles, [&](int tile) {
        if (control.stop != nullptr && control.stop->load())
            return;
        Scratch scratch;
        TileSums<images>& own = sums[static_cast<std::size_t>(tile)];
        own = render_tile<images>(job, grid, tile, tracer, scratch);
        const std::lock_guard lock(mutex);
        tracer.count(scratch);
        statistics.dropped_samples += own.dropped;
        out.whole = ++done == tiles;
        if (control.progress)
            control.progress(static_cast<double>(done) / tiles);
    });
    out.images = images_of(grid, sums);
    statistics.passes += out.whole ? 1 : 0;
    statistics.seconds_image += watch.seconds();
    statistics.processor_image += watch.processor_seconds();
    return out;
}

/// Renders one pixel of each block of the pixels to render, in parallel.  A pixel without a finite
/// sample, or which a stop left out, is black.  trace: as that of TileTracer.
template <std::size_t images, typename Scratch, typename Trace>
CoarseImage render_coarse(const PictureJob& job, const PilotControl& control, const Trace& trace)
{
    const Stopwatch watch;
    constexpr std::uint32_t kMostSamples = 4;
    RenderOptions options = job.options;
    options.samples = std::min(options.samples, kMostSamples);
    const PictureJob few{job.scene, options, job.pass, job.allocation};
    const PixelRect pixels = rendered_pixels(options);
    CoarseImage out;
    out.block = coarse_block(options);
    out.image = Image((pixels.width() + out.block - 1) / out.block,
                      (pixels.height() + out.block - 1) / out.block);
    tbb::parallel_for(0, out.image.height, [&](int v) {
        Scratch scratch;
        for (int u = 0; u < out.image.width && !control.stopped(); ++u) {
            const int x = std::min(pixels.x0 + u * out.block + out.block / 2, pixels.x1 - 1);
            const int y = std::min(pixels.y0 + v * out.block + out.block / 2, pixels.y1 - 1);
            std::vector<TracedSample<images>> traced;
            trace_pixel(few, {x, y}, trace, scratch, traced);
            const auto samples = filter_pixel<images>(few, x, y, traced);
            const Rgb mean = samples.values[4][0] / samples.weights[4]; // of the pixel itself
            out.image.at(u, v) = is_finite(mean) ? mean : Rgb(0);
        }
    });
    const double work = static_cast<double>(pixels.width()) * pixels.height() *
                        job.options.samples / options.samples;
    out.pass = watch.seconds() * work / static_cast<double>(out.image.pixels.size());
    return out;
}

/// Renders the images of a pass as render_tiles does; clamps the samples if the options say so.
template <std::size_t images, typename Scratch, typename Tracer>
RenderedPass render_clamped_tiles(const PictureJob& job, const PassControl& control,
                                  RenderStatistics& statistics, const Tracer& tracer)
{
    return job.options.clamp > 0
               ? render_tiles<images + 1, Scratch>(job, control, statistics, tracer)
               : render_tiles<images, Scratch>(job, control, statistics, tracer);
}

} // namespace hipmap
