#pragma once

#include "common/command_line/option_table.h"
#include "common/image/legend.h"
#include "common/report.h"
#include "render/options.h"
#include "render/previous_frame.h"

#include <filesystem>
#include <string>
#include <vector>

namespace hipmap {

/// The images that were written.
struct WrittenFiles {
    float exposure_ev = 0; ///< of 8-bit images
    std::vector<LegendedPicture> pictures;
    Spent writing;
    std::size_t warnings = 0; ///< of the whole run until then
};

/// Returns the options that say which files `render` and `render merge` write, and how 8-bit images
/// are exposed.
std::vector<OptionRow> output_rows(OutputFiles& files, bool required);

/// Returns the options of the file of layers.
std::vector<OptionRow> layer_option_rows(OutputFiles& files, LayerChoice& layers);

/// Throws InputError unless every file could be written and every image has a known suffix.
/// Changes no file.
void check_outputs(const OutputFiles& files);

/// Returns whether the format of this file is 8-bit, which has an exposure.
bool is_exposed(const std::filesystem::path& image);

/// Writes `image` and its pictures to the requested files, and reports them. .exr files also hold
/// the layers of error_layers, where the film of `state` knows its error.  A warning replaces a
/// picture of what is not known.  Throws InputError if a file cannot be written.
WrittenFiles write_images(const OutputFiles& files, const Image& image, const RenderState& state,
                          Report& report);

/// Writes the layers of a frame if they were requested, and reports the file.  With less than two
/// passes those that show errors are left out, with a warning.  Throws InputError if the file
/// cannot be written.
void write_requested_layers(const RenderArguments& arguments, const RenderedFrame& frame,
                            Report& report);

/// Writes the statistics if they were requested, and reports the file.  json: their text.
void write_statistics(const OutputFiles& files, const std::string& json, Report& report);

} // namespace hipmap
