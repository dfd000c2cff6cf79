#pragma once

#include "render/film/image_error.h"

#include <array>
#include <vector>

namespace hipmap {

/// What becomes of fireflies in an image.
enum class FireflyChoice : std::uint8_t { keep, remove };

/// Few pixels that carry much of the estimated error, each mostly by one rare bright sample.
struct Fireflies {
    std::uint64_t pixels = 0;
    double share = 0;         ///< of the square of the estimated error
    double error_without = 0; ///< estimated, of the other pixels

    bool operator==(const Fireflies&) const = default;
};

/// Returns the fireflies of a film by docs/error.md (19); none: no such pixels, or they carry less
/// than a quarter of the square of the error.  error: estimate_error(film).  Costs about as much as
/// that.
std::optional<Fireflies> find_fireflies(const Film& film, const ImageError& error);

/// What the removal of fireflies took from an image.
struct RemovedFireflies {
    std::uint64_t pixels = 0;
    double light = 0; ///< share of the sum of all channels that they carried
    double bias2 = 0; ///< relMSE of the light that is missing now, docs/error.md (25)
    double most2 = 0; ///< 95 % upper limit of that
};

/// The sums of a pixel that share the photons of one batch, set aside.
struct PixelSums {
    struct Batch {
        std::uint64_t number;
        std::uint32_t lost; ///< passes that had kept no sample of the pixel
        std::array<std::int64_t, 3> radiance{};
    };
    std::size_t pixel = 0;
    std::vector<Batch> wide;
    std::uint64_t narrow_batch = 0;
    std::array<std::array<std::int64_t, 3>, 3> narrow{}; ///< of narrow, narrower and cut
};

/// Takes the batches that hold fireflies out of their pixels, as if their passes had kept no sample
/// there, docs/error.md (24).  What two batches or more have found is no firefly and stays, and so
/// does what is too often found.  A film with passes in fewer than kFewestBatches batches loses
/// nothing.  The film is then one to show: write its state before.  aside: takes what it loses;
/// null: nobody asks.  Costs about as much as find_fireflies.
RemovedFireflies remove_fireflies(Film& film, std::vector<PixelSums>* aside = nullptr);

/// Keeps the fireflies of a film out of it while it lives, if they are to be removed.
class HiddenFireflies {
  public:
    HiddenFireflies(FireflyChoice choice, Film& film);
    ~HiddenFireflies();
    HiddenFireflies(const HiddenFireflies&) = delete;
    HiddenFireflies& operator=(const HiddenFireflies&) = delete;

    const RemovedFireflies& removed() const { return removed_; }

  private:
    Film& film_;
    std::vector<PixelSums> aside_;
    RemovedFireflies removed_;
};

/// The fireflies of an image to show.
struct ShownFireflies {
    std::optional<Fireflies> kept;
    std::optional<RemovedFireflies> removed; ///< none: they were to be kept
};

/// Returns the error of the film that is left, as estimate_error does, with that of the light that
/// is missing.
std::optional<ImageError> estimate_error(const Film& film, const RemovedFireflies& removed);

/// Returns the error of the image that a film shows; the film stays as it is.
std::optional<ImageError> error_of_shown(FireflyChoice choice, Film& film);

} // namespace hipmap
