#pragma once

#include "common/file/scratch_file.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

namespace hipmap {

/// Pixels of textures that memory does not hold: square tiles of them in a file, and a limited
/// number of tiles in memory, of which those that were not used for longest give way (clock
/// algorithm, Corbato 1968).
class TextureCache {
  public:
    static constexpr int kTileSide = 32;
    static constexpr std::size_t kTilePixels = std::size_t{kTileSide} * kTileSide;

    /// bytes: of the tiles in memory, at least one tile.  Throws InputError as ScratchFile does.
    explicit TextureCache(std::uint64_t bytes);

    /// Writes an image of 8-bit RGBA, rows from the top, and returns the number of its first tile.
    /// Throws InputError as ScratchFile does.  One thread, before any other asks for pixels.
    std::uint32_t add(std::span<const std::uint8_t> rgba, int width, int height);

    /// Returns the pixel (x, y) of the image that begins with tile `first` and is so wide: R in the
    /// lowest byte, A in the highest.  Throws InputError if the file cannot be read.  Thread-safe
    /// and without locks where the tile is in memory; else one read of 4 KiB.
    std::uint32_t pixel(std::uint32_t first, int width, int x, int y);

    /// Returns all pixels of an image, [4 * width * height], as add() was given them.
    std::vector<std::uint8_t> image(std::uint32_t first, int width, int height) const;

    /// Returns the bytes of the tiles that memory may hold.
    std::uint64_t capacity() const { return slots_.size() * kTilePixels * sizeof(std::uint32_t); }

  private:
    /// A place for a tile in memory.  version: odd while its pixels are changed, so that whoever
    /// reads them meanwhile can tell (a seqlock; Boehm 2012).
    struct Slot {
        std::atomic<std::uint32_t> version{0}, tile{kNoTile};
        std::atomic<bool> used{false}; ///< since the hand was here
    };
    static constexpr std::uint32_t kNoTile = 0xffffffff, kNoSlot = 0xffffffff;

    void read_tile(std::uint32_t tile, std::span<std::uint32_t> pixels) const;
    std::uint32_t load(std::uint32_t tile, std::size_t at);
    void keep(std::uint32_t tile, std::span<const std::uint32_t> pixels);
    std::uint32_t free_slot();

    ScratchFile file_;
    std::vector<std::uint32_t> slot_of_; ///< by tile; read and written as atomics
    std::vector<Slot> slots_;
    std::unique_ptr<std::uint32_t[]> pixels_; ///< of the slots; read and written as atomics
    std::mutex changing_;
    std::uint32_t hand_ = 0; ///< guarded by changing_
};

} // namespace hipmap
