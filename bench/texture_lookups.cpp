// What a pixel of a texture costs that memory need not hold: by TextureCache, and by OpenImageIO's
// ImageCache from a TIFF file of tiles of the same size, uncompressed.
//
//     texture_lookups [--side PIXELS] [--lookups N]

#include "common/command_line/command_line.h"
#include "common/input_error.h"
#include "common/math/random.h"
#include "common/scene/texture_cache.h"

#include <OpenImageIO/imagecache.h>
#include <OpenImageIO/imageio.h>

#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <functional>
#include <string>
#include <thread>
#include <vector>

namespace hipmap {

namespace {

constexpr int kTile = TextureCache::kTileSide;
constexpr double kMib = 1 << 20;

struct Pixel {
    int x, y;
};

/// Returns the pixels to look up, in order: neighbours one after another along rows, or random ones
/// (`scattered`).
std::vector<Pixel> make_order(int side, std::size_t count, bool scattered)
{
    constexpr int kRow = 256;
    std::vector<Pixel> out(count);
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint64_t bits = mix_bits(scattered ? i : i / kRow);
        const auto size = static_cast<std::uint64_t>(side);
        out[i] = {static_cast<int>(bits % size), static_cast<int>((bits >> 32) % size)};
        if (!scattered)
            out[i].x = (out[i].x + static_cast<int>(i % kRow)) % side;
    }
    return out;
}

/// Nanoseconds of a lookup by each of the threads, all of which look up all pixels.
double time_lookups(unsigned threads, std::size_t count, const std::function<std::uint64_t()>& look)
{
    const auto begun = std::chrono::steady_clock::now();
    {
        std::vector<std::jthread> all;
        for (unsigned i = 0; i < threads; ++i)
            all.emplace_back([&] {
                if (look() == 0)
                    std::puts("all pixels are black");
            });
    }
    const std::chrono::duration<double, std::nano> spent = std::chrono::steady_clock::now() - begun;
    return spent.count() / static_cast<double>(count);
}

std::uint64_t look_in_cache(TextureCache& cache, int side, const std::vector<Pixel>& order)
{
    std::uint64_t sum = 0;
    for (const Pixel& at : order)
        sum += cache.pixel(0, side, at.x, at.y) & 0xff;
    return sum;
}

std::uint64_t look_in_openimageio(OIIO::ImageCache& cache, const std::string& path,
                                  const std::vector<Pixel>& order)
{
    OIIO::ImageCache::Perthread* const thread = cache.get_perthread_info();
    OIIO::ImageCache::ImageHandle* const image =
        cache.get_image_handle(OIIO::ustring(path), thread);
    std::uint64_t sum = 0;
    for (const Pixel& at : order) {
        OIIO::ImageCache::Tile* const tile = cache.get_tile(image, thread, 0, 0, at.x, at.y, 0);
        OIIO::TypeDesc format;
        const auto* const pixels =
            static_cast<const std::uint8_t*>(cache.tile_pixels(tile, format));
        sum += pixels[4 * (at.y % kTile * kTile + at.x % kTile)];
        cache.release_tile(tile);
    }
    return sum;
}

void write_tiff(const std::string& path, int side, const std::vector<std::uint8_t>& rgba)
{
    OIIO::ImageSpec spec(side, side, 4, OIIO::TypeDesc::UINT8);
    spec.tile_width = spec.tile_height = kTile;
    spec.attribute("compression", "none");
    const auto out = OIIO::ImageOutput::create(path);
    if (!out || !out->open(path, spec) || !out->write_image(OIIO::TypeDesc::UINT8, rgba.data()))
        throw InputError(path + ": OpenImageIO cannot write it (" + OIIO::geterror() + ")");
    out->close();
}

void compare(int side, std::size_t lookups)
{
    std::vector<std::uint8_t> rgba(4 * static_cast<std::size_t>(side) * side);
    for (std::size_t i = 0; i < rgba.size(); ++i)
        rgba[i] = static_cast<std::uint8_t>(mix_bits(i));
    const std::filesystem::path tiff =
        std::filesystem::temp_directory_path() / "hipmap_texture_lookups.tif";
    write_tiff(tiff, side, rgba);
    std::printf("| pixels | in memory | threads | TextureCache, ns | OpenImageIO, ns | ratio |\n"
                "|---|---|---|---|---|---|\n");
    for (const bool scattered : {false, true})
        for (const double share : {1.1, 0.0625})
            for (const unsigned threads : {1u, 2u}) {
                const std::vector<Pixel> order = make_order(side, lookups, scattered);
                const double bytes = share * static_cast<double>(rgba.size());
                TextureCache own(static_cast<std::uint64_t>(bytes));
                own.add(rgba, side, side);
                OIIO::ImageCache* const other = OIIO::ImageCache::create(false);
                other->attribute("max_memory_MB", static_cast<float>(bytes / kMib));
                const double ns =
                    time_lookups(threads, lookups, [&] { return look_in_cache(own, side, order); });
                const double of_other = time_lookups(
                    threads, lookups, [&] { return look_in_openimageio(*other, tiff, order); });
                OIIO::ImageCache::destroy(other);
                std::printf("| %s | %s | %u | %.0f | %.0f | %.1f |\n",
                            scattered ? "at random" : "along rows", share > 1 ? "all" : "1/16",
                            threads, ns, of_other, of_other / ns);
            }
    std::filesystem::remove(tiff);
}

} // namespace

} // namespace hipmap

int main(int argc, char** argv)
{
    return hipmap::run_tool([&] {
        int side = 4096;
        std::size_t lookups = 2'000'000;
        CLI::App app("Times lookups of single pixels of a texture.", "texture_lookups");
        app.add_option("--side", side, "Pixels across")->check(hipmap::finite_in(32, 16384));
        app.add_option("--lookups", lookups, "Of each thread")->check(hipmap::finite_in(1, 1e9));
        if (const std::optional<int> code = hipmap::parse_arguments(app, argc, argv))
            return *code;
        hipmap::compare(side, lookups);
        return hipmap::kExitDone;
    });
}
