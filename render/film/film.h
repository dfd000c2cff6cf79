#pragma once

#include "render/film/expected_light.h"
#include "render/film/film_parts.h"
#include "render/film/pass_images.h"

#include <array>
#include <map>

namespace hipmap {

/// The number of batches.  Passes are assigned to batches by their number; the noise is estimated
/// from the differences between batches.
inline constexpr std::uint64_t kBatches = 8;
/// The number of batches with passes from which on the interval of an error is known.
inline constexpr std::uint64_t kFewestBatches = 4;
/// The number of batches of the images by narrower radii; a divisor of kBatches.
inline constexpr std::uint64_t kNarrowBatches = 4;

/// The most passes of a film: this many of the largest value do not overflow a sum.
inline constexpr std::uint64_t kMostPasses = std::uint64_t{1} << 20;

/// Pixels of a film that a thread takes at a time, at least.
inline constexpr std::size_t kPixelsOfTask = 4096;

/// What is known about the bias of the passes.
enum class BiasKnowledge : std::uint8_t {
    unbiased,
    unknown,    ///< an error that is told is that of noise alone
    from_radii, ///< passes have images by narrower radii
};

/// Sums of passes, in integers, so that the same passes give the same bits in any order of adding
/// and merging.  Copyable.  192 bytes a pixel, 384 with images by narrower radii.
struct Film {
    int width = 0;
    int height = 0;
    ImagePlace place; ///< of its pixels
    int scale = 0;    ///< values are counted in units of 2^-scale W/(m2 sr), docs/error.md (2)
    std::uint64_t allocation = 0; ///< checksum of its sample allocation, docs/error.md (14)
    ExpectedLight expected;       ///< of the whole image
    BiasKnowledge bias = BiasKnowledge::unknown;
    PassSet passes; ///< that some pixel holds
    /// What the pixels hold, as joined_parts returns it; a pixel of no part holds nothing.  Empty:
    /// each pixel holds all of `passes`.
    std::vector<FilmPart> parts;

    std::vector<std::int64_t> radiance; ///< [kBatches][pixels][3]
    std::vector<std::int64_t> narrow;   ///< [kNarrowBatches][pixels][3]; empty unless from_radii
    std::vector<std::int64_t> narrower; ///< the same
    std::vector<std::int64_t> cut;      ///< [kNarrowBatches][pixels][3] of what clamping took from
                                        ///< `radiance`; empty: samples were not clamped
    /// By pixel * kBatches + batch: passes of the batch that kept no sample of the pixel; rare.
    std::map<std::uint64_t, std::uint32_t> lost;
    std::uint64_t saturated = 0; ///< values that were beyond the largest and count as that

    std::size_t pixel_count() const { return static_cast<std::size_t>(width) * height; }
    bool operator==(const Film&) const = default;
};

/// Returns the scale of a film: see make_film.
int film_scale(double mean);

/// Makes an empty film.  mean: of the channels of some image of the scene, which fixes the unit; an
/// estimate will do, but films can be merged only if it was the same.  A mean of zero or less
/// counts as one.  clamped: passes say what clamping took.
Film make_film(int width, int height, double mean, BiasKnowledge bias, bool clamped = false);

/// Makes an empty film of another size for passes of the same whole image as those of `film`, whose
/// place it has.
Film empty_like(const Film& film, int width, int height);

/// Adds a pass, which must not be in the film yet; images of the film's size.  The film has no
/// parts.  Parallel.
void add_pass(Film& film, std::uint64_t pass, const PassImages& images);

/// Returns the pixels of a film in the whole image.
PixelRect pixels_of(const Film& film);

/// Returns what the pixels of a film hold, in pixels of the film; none for a film without passes.
std::vector<FilmPart> parts_of(const Film& film);

/// Returns `parts` moved by x and y pixels.
std::vector<FilmPart> moved(std::vector<FilmPart> parts, int x, int y);

/// Adds the passes of another film of the same whole image, scale, sample allocation and bias
/// knowledge, whose pixels are among those of `into`; no pixel may have a pass in both.  Parallel.
void merge_film(Film& into, const Film& from);

/// Counts the passes that kept a sample of a pixel.  Borrows the film.  Thread-safe.
class KeptPasses {
  public:
    explicit KeptPasses(const Film& film);
    std::uint64_t of_batch(std::size_t pixel, std::uint64_t batch) const;

  private:
    const Film& film_;
    std::vector<std::array<std::uint64_t, kBatches>> held_; ///< by part; first: of no part
    std::vector<std::uint16_t> part_of_; ///< [pixels] into held_; empty: all the last
};

/// The most parts of a film.
inline constexpr std::size_t kMostFilmParts = 4096;

/// Returns the largest value that a channel of one pass can have in a film, in its units.
std::int64_t largest_value();

/// Returns the mean of all passes, radiance, W/(m2 sr); a pixel without a kept sample is black.
Image film_image(const Film& film);

} // namespace hipmap
