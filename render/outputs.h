#pragma once

#include "common/image/legend.h"
#include "common/report.h"
#include "render/film/price.h"
#include "render/film/render_state.h"
#include "render/options.h"

#include <filesystem>
#include <optional>
#include <string>

namespace hipmap {

/// What became of the images that were asked for.
struct WrittenFiles {
    float exposure_ev = 0; ///< of 8-bit images
    std::optional<LegendedPicture> error_image;
    double seconds = 0;       ///< writing them
    std::size_t warnings = 0; ///< of the whole run until then
};

/// Throws InputError unless every file could be written and every image has a known suffix.
/// Changes no file.
void check_outputs(const OutputFiles& files);

/// Whether the format of this file is 8-bit, which has an exposure.
bool is_exposed(const std::filesystem::path& image);

/// Writes `image` and the picture of its errors to the files that were asked for, and prints so.
/// .exr files hold the layers of error_layers besides, where the film of `state` knows its error.
/// With less than two passes no error is known: a warning instead of its picture.  Throws
/// InputError if a file cannot be written.
WrittenFiles write_images(const OutputFiles& files, const Image& image, const RenderState& state,
                          Report& report);

/// Writes the statistics if they were asked for, and prints so.  json: their text.
void write_statistics(const OutputFiles& files, const std::string& json, Report& report);

/// "3.2 %", of 0.032.
std::string percent(double share);

/// What is known of an image's error, in words.
std::string describe_error(const ErrorCheck& check);

/// What half the error would cost: of that asked for while it is to be reached, else of that there
/// is.  target: what was asked for, 0 for none.
std::string describe_price(const RenderState& state, double target);

/// The errors of a price list: half of what there is now, round ones, and the target and half of
/// it.  target: 0 for none.
std::vector<Price> price_list(const RenderState& state, double target);

/// The most memory that this process has held, bytes; 0: not known.
std::uint64_t peak_memory();

} // namespace hipmap
