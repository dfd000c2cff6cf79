#pragma once

#include "common/image/legend.h"
#include "common/report.h"
#include "render/film/error_cost.h"
#include "render/film/render_state.h"
#include "render/options.h"

#include <filesystem>
#include <optional>
#include <string>

namespace hipmap {

/// The images that were written.
struct WrittenFiles {
    float exposure_ev = 0; ///< of 8-bit images
    std::optional<LegendedPicture> error_image;
    double seconds = 0;       ///< writing them
    std::size_t warnings = 0; ///< of the whole run until then
};

/// Throws InputError unless every file could be written and every image has a known suffix.
/// Changes no file.
void check_outputs(const OutputFiles& files);

/// Returns whether the format of this file is 8-bit, which has an exposure.
bool is_exposed(const std::filesystem::path& image);

/// Writes `image` and the image of its errors to the requested files, and reports them. .exr files
/// also hold the layers of error_layers, where the film of `state` knows its error. With less than
/// two passes no error is known: a warning replaces the error image.  Throws InputError if a file
/// cannot be written.
WrittenFiles write_images(const OutputFiles& files, const Image& image, const RenderState& state,
                          Report& report);

/// Writes the statistics if they were requested, and reports the file.  json: their text.
void write_statistics(const OutputFiles& files, const std::string& json, Report& report);

/// Formats a share as a percentage: "3.2 %" of 0.032.
std::string percent(double share);

/// Describes the estimated error of an image in words.
std::string describe_error(const ErrorCheck& check);

/// Describes what an error takes: "would take about 23 passes, 46 s"; beyond a day: "is not
/// practical (more than a day)".
std::string describe_need(const ErrorCost& cost);

/// Describes the cost of halving the error: of the target while it is to be reached, else of the
/// current error.  target: the requested error, 0 for none.
std::string describe_cost(const RenderState& state, double target);

/// Returns the errors of a cost table: half of the current error, round ones, and the target and
/// half of it.  target: 0 for none.
std::vector<ErrorCost> error_costs(const RenderState& state, double target);

/// Returns the most memory that this process has held, bytes; 0: unknown.
std::uint64_t peak_memory();

} // namespace hipmap
