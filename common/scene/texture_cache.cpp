#include "common/scene/texture_cache.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

namespace hipmap {

namespace {

constexpr auto kSide = static_cast<std::size_t>(TextureCache::kTileSide);
constexpr std::size_t kTileBytes = TextureCache::kTilePixels * sizeof(std::uint32_t);
using TilePixels = std::array<std::uint32_t, TextureCache::kTilePixels>;

static_assert(std::endian::native == std::endian::little, "pixels are read as numbers");
static_assert(std::atomic_ref<std::uint32_t>::is_always_lock_free);

std::size_t tiles_across(int pixels)
{
    return (static_cast<std::size_t>(pixels) + kSide - 1) / kSide;
}

/// The part of a row of an image that lies in a column of tiles: its first pixel and their number.
struct RowPart {
    std::size_t first, count;
};

RowPart part_of_row(int width, std::size_t column, std::size_t y)
{
    const auto across = static_cast<std::size_t>(width);
    return {y * across + column * kSide, std::min(kSide, across - column * kSide)};
}

std::size_t rows_of_band(int height, std::size_t band)
{
    return std::min(kSide, static_cast<std::size_t>(height) - band * kSide);
}

} // namespace

TextureCache::TextureCache(std::uint64_t bytes)
    : slots_(std::clamp<std::uint64_t>(bytes / kTileBytes, 1, kNoSlot)),
      pixels_(std::make_unique_for_overwrite<std::uint32_t[]>(slots_.size() * kTilePixels))
{
}

std::uint32_t TextureCache::add(std::span<const std::uint8_t> rgba, int width, int height)
{
    const auto first = static_cast<std::uint32_t>(slot_of_.size());
    const std::size_t columns = tiles_across(width);
    std::vector<std::uint32_t> band(columns * kTilePixels);
    for (std::size_t j = 0; j < tiles_across(height); ++j) {
        for (std::size_t i = 0; i < columns; ++i)
            for (std::size_t row = 0; row < rows_of_band(height, j); ++row) {
                const RowPart part = part_of_row(width, i, j * kSide + row);
                std::memcpy(&band[i * kTilePixels + row * kSide], &rgba[4 * part.first],
                            4 * part.count);
            }
        file_.append(std::as_bytes(std::span(band)));
    }
    slot_of_.resize(first + columns * tiles_across(height), kNoSlot);
    return first;
}

std::uint32_t TextureCache::pixel(std::uint32_t first, int width, int x, int y)
{
    const auto i = static_cast<std::size_t>(x), j = static_cast<std::size_t>(y);
    const auto tile =
        static_cast<std::uint32_t>(first + j / kSide * tiles_across(width) + i / kSide);
    const std::size_t at = j % kSide * kSide + i % kSide;
    const std::uint32_t number = std::atomic_ref(slot_of_[tile]).load(std::memory_order_acquire);
    if (number == kNoSlot)
        return load(tile, at);
    Slot& slot = slots_[number];
    const std::uint32_t version = slot.version.load(std::memory_order_acquire);
    const bool holds_it = version % 2 == 0 && slot.tile.load(std::memory_order_relaxed) == tile;
    const std::uint32_t found =
        std::atomic_ref(pixels_[number * kTilePixels + at]).load(std::memory_order_relaxed);
    std::atomic_thread_fence(std::memory_order_acquire);
    if (!holds_it || slot.version.load(std::memory_order_relaxed) != version)
        return load(tile, at);
    if (!slot.used.load(std::memory_order_relaxed)) // so that hot tiles are not written to
        slot.used.store(true, std::memory_order_relaxed);
    return found;
}

std::vector<std::uint8_t> TextureCache::image(std::uint32_t first, int width, int height) const
{
    std::vector<std::uint8_t> rgba(4 * static_cast<std::size_t>(width) *
                                   static_cast<std::size_t>(height));
    TilePixels pixels;
    for (std::size_t j = 0; j < tiles_across(height); ++j)
        for (std::size_t i = 0; i < tiles_across(width); ++i) {
            read_tile(static_cast<std::uint32_t>(first + j * tiles_across(width) + i), pixels);
            for (std::size_t row = 0; row < rows_of_band(height, j); ++row) {
                const RowPart part = part_of_row(width, i, j * kSide + row);
                std::memcpy(&rgba[4 * part.first], &pixels[row * kSide], 4 * part.count);
            }
        }
    return rgba;
}

void TextureCache::read_tile(std::uint32_t tile, std::span<std::uint32_t> pixels) const
{
    file_.read(std::uint64_t{tile} * kTileBytes, std::as_writable_bytes(pixels));
}

/// Reads outside of the lock: two threads may read the same tile, of which one is kept.
std::uint32_t TextureCache::load(std::uint32_t tile, std::size_t at)
{
    TilePixels pixels;
    read_tile(tile, pixels);
    const std::lock_guard lock(changing_);
    if (std::atomic_ref(slot_of_[tile]).load(std::memory_order_relaxed) == kNoSlot)
        keep(tile, pixels);
    return pixels[at];
}

void TextureCache::keep(std::uint32_t tile, std::span<const std::uint32_t> pixels)
{
    const std::uint32_t number = free_slot();
    Slot& slot = slots_[number];
    const std::uint32_t left = slot.tile.load(std::memory_order_relaxed);
    if (left != kNoTile)
        std::atomic_ref(slot_of_[left]).store(kNoSlot, std::memory_order_relaxed);
    const std::uint32_t version = slot.version.load(std::memory_order_relaxed);
    slot.version.store(version + 1, std::memory_order_relaxed);
    std::atomic_thread_fence(std::memory_order_release);
    slot.tile.store(tile, std::memory_order_relaxed);
    for (std::size_t i = 0; i < kTilePixels; ++i)
        std::atomic_ref(pixels_[number * kTilePixels + i])
            .store(pixels[i], std::memory_order_relaxed);
    slot.version.store(version + 2, std::memory_order_release);
    std::atomic_ref(slot_of_[tile]).store(number, std::memory_order_release);
}

/// The next slot that was not used since the hand came by; after two rounds, however busy the
/// others are, the one where it stands.
std::uint32_t TextureCache::free_slot()
{
    const auto count = static_cast<std::uint32_t>(slots_.size());
    for (std::uint64_t step = 0; step < 2 * std::uint64_t{count}; ++step) {
        const std::uint32_t here = hand_;
        hand_ = here + 1 == count ? 0 : here + 1;
        if (!slots_[here].used.exchange(false, std::memory_order_relaxed))
            return here;
    }
    return hand_;
}

} // namespace hipmap
