#pragma once

#include "common/image/legend.h"
#include "common/report.h"
#include "render/film/price.h"
#include "render/film/render_state.h"

#include <filesystem>
#include <optional>
#include <string>

namespace hipmap {

/// Writes the mean of a film, or `image` in its place while it is empty, and says so.  .exr files
/// hold the layers of error_layers besides, where the film knows its error.  exposure_ev: none:
/// auto.  Returns the exposure.  Throws InputError if a file cannot be written.
float write_images(const std::vector<std::filesystem::path>& paths, const Image& image,
                   const Film& film, const std::vector<ErrorCheck>& checks,
                   std::optional<float> exposure_ev, Report& report);

/// Writes the picture of errors, with its legend, and says so; warns instead if the film has less
/// than two passes, of which no error is known.  Throws InputError if it cannot be written.
std::optional<LegendedPicture> write_error_image(const std::filesystem::path& path,
                                                 const Film& film,
                                                 const std::vector<ErrorCheck>& checks,
                                                 Report& report);

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
