#include "render/outputs.h"

#include "common/file/output_file.h"
#include "common/image/exposure.h"
#include "common/image/exr_file.h"
#include "common/image/write_image.h"
#include "common/input_error.h"
#include "common/scene/scene_names.h"
#include "common/stopwatch.h"
#include "render/film/error_picture.h"
#include "render/film/image_error.h"
#include "render/settings.h"

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace hipmap {

namespace {

constexpr double kMostExposure = 100;

void write_exr_with_error(const std::filesystem::path& path, const Image& image, const Film& film,
                          const std::vector<ErrorCheck>& checks)
{
    if (checks.empty()) {
        write_exr(path, image, {}, film.place);
        return;
    }
    const ErrorLayers layers = error_layers(film);
    std::vector<Layer> named = {{"noise", &layers.noise}, {"error", &layers.error}};
    if (!layers.bias.pixels.empty())
        named.push_back({"bias", &layers.bias});
    write_exr(path, image, named, film.place);
}

/// Returns the exposure of 8-bit images.
float write_each(const OutputFiles& files, const Image& image, const RenderState& state,
                 Report& report)
{
    const float ev = files.exposure_ev ? *files.exposure_ev : auto_exposure(image);
    for (const std::filesystem::path& path : files.images) {
        if (image_format(path) == ImageFormat::exr)
            write_exr_with_error(path, image, state.film, state.checks);
        else
            write_image(path, image, {ev, files.view});
        std::ostringstream note;
        if (is_exposed(path))
            note << "exposure " << std::showpos << std::fixed << std::setprecision(2) << ev << " EV"
                 << (files.exposure_ev ? "" : ", auto");
        report.wrote(path, note.str());
    }
    return ev;
}

std::optional<LegendedPicture> write_error_image(const std::filesystem::path& path,
                                                 const Film& film,
                                                 const std::vector<ErrorCheck>& checks,
                                                 Report& report)
{
    if (checks.empty()) {
        report.warn(path.string() + ": not written; an error image needs two passes or more");
        return std::nullopt;
    }
    const std::vector<double> errors = relative_errors(film);
    const LegendedPicture written =
        write_with_legend(path, error_picture(film.width, film.height, errors), legend_of_errors());
    report.wrote(path);
    return written;
}

void parse_error_image(const std::string& text, std::filesystem::path& error_image)
{
    error_image = text;
    if (image_format(error_image) != ImageFormat::png)
        throw InputError(text + ": the error image must be .png; -o FILE.exr holds the error "
                                "by pixel in numbers");
}

OptionField exposure_field(std::optional<float>& exposure_ev)
{
    OptionField out = parsed_field(
        [&](const std::string& text) {
            if (text == "auto")
                exposure_ev.reset();
            else
                exposure_ev = std::stof(text);
        },
        [&] { return number_value(exposure_ev); }, "EV|auto");
    out.add = [add = out.add](CLI::App& app, const std::string& flags) {
        return add(app, flags)
            ->check(CLI::IsMember({"auto"}) | finite_in(-kMostExposure, kMostExposure));
    };
    out.values = text_of(NumberRange{-kMostExposure, kMostExposure}) + ", auto";
    return out;
}

void parse_layer_file(const std::string& text, std::filesystem::path& layers)
{
    layers = text;
    if (image_format(layers) != ImageFormat::exr)
        throw InputError(text + ": layers must be .exr, which alone holds several");
}

/// "combined, depth": in a list without spaces manual pages could not break the line.
std::string listed(std::span<const LayerRow* const> rows)
{
    std::vector<std::string> names;
    for (const LayerRow* row : rows)
        names.emplace_back(row->name);
    return joined(names);
}

OptionField layer_names_field(std::vector<const LayerRow*>& rows)
{
    return parsed_field([&](const std::string& text) { rows = parse_layers(text); },
                        [&] { return rows.empty() ? SettingValue() : SettingValue(text_of(rows)); },
                        "LIST");
}

/// Whether a layer shows an error that is not known yet.
bool lacks_error(const LayerRow* row, const RenderState& state)
{
    const auto* const of = std::get_if<OfFilm>(&row->read);
    return of != nullptr && of->needs_error && state.checks.empty();
}

} // namespace

std::vector<OptionRow> output_rows(OutputFiles& files, bool required)
{
    return {{.name = "output",
             .section = kFilesSection,
             .field = files_field(files.images),
             .help = "Image to write; repeatable. .exr, .pfm and .hdr hold radiance, W/(m2 sr), "
                     ".exr its noise, bias and error too; .png and .ppm are exposed sRGB. "
                     "Rewritten after passes",
             .flags = "-o,--output",
             .required = required},
            {.name = "error-image",
             .section = kFilesSection,
             .field = parsed_field(
                 [&](const std::string& text) { parse_error_image(text, files.error_image); }, {},
                 "FILE"),
             .help = "Write an image of the relative error of each pixel in false colour, .png"},
            {.name = "stats",
             .section = kFilesSection,
             .field = file_field(files.statistics),
             .help = "Write statistics as JSON"},
            {.name = "exposure",
             .section = kImageSection,
             .field = exposure_field(files.exposure_ev),
             .help = "Exposure of 8-bit images in stops",
             .unset = "auto"},
            {.name = "ocio",
             .section = kImageSection,
             .field = text_field(files.view_choice.config, "CONFIG|blender"),
             .help = "Show 8-bit images through a view of this OpenColorIO configuration file; "
                     "blender: that of the installed Blender",
             .unset = "none: sRGB"},
            {.name = "view",
             .section = kImageSection,
             .field = text_field(files.view_choice.view, "NAME"),
             .help = "View of the configuration, such as Filmic or AgX",
             .unset = "the configuration's default",
             .needs = "ocio"}};
}

std::vector<OptionRow> layer_option_rows(OutputFiles& files, LayerChoice& layers)
{
    return {
        {.name = "layers",
         .section = kFilesSection,
         .field = parsed_field(
             [&](const std::string& text) { parse_layer_file(text, files.layers); }, {}, "FILE"),
         .help = "Write render passes, such as depth and normals, as one multi-layer .exr that "
                 "Blender reads"},
        {.name = "layer-names",
         .section = kImageSection,
         .field = layer_names_field(layers.rows),
         .help = "Layers that --layers writes: " + listed(chosen_layers({})),
         .unset = "all",
         .needs = "layers"},
        {.name = "view-layer",
         .section = kImageSection,
         .field = text_field(layers.view_layer, "NAME"),
         .help = "View layer of Blender that the layers of --layers belong to",
         .needs = "layers"}};
}

void check_outputs(const OutputFiles& files)
{
    for (const std::filesystem::path& image : files.images) {
        image_format(image); // refuses an unknown suffix
        check_writable(image);
    }
    OutputFiles copy = files;
    for (const std::filesystem::path* file : copy.single_files())
        if (!file->empty())
            check_writable(*file);
}

bool is_exposed(const std::filesystem::path& image)
{
    const ImageFormat format = image_format(image);
    return format == ImageFormat::png || format == ImageFormat::ppm;
}

WrittenFiles write_images(const OutputFiles& files, const Image& image, const RenderState& state,
                          Report& report)
{
    const Stopwatch writing;
    WrittenFiles out;
    out.exposure_ev = write_each(files, image, state, report);
    if (!files.error_image.empty())
        out.error_image = write_error_image(files.error_image, state.film, state.checks, report);
    out.seconds = writing.seconds();
    out.warnings = report.warnings();
    return out;
}

void write_requested_layers(const RenderArguments& arguments, const RenderedFrame& frame,
                            Report& report)
{
    const std::filesystem::path& path = arguments.files.layers;
    if (path.empty())
        return;
    std::vector<const LayerRow*> rows = chosen_layers(arguments.layers);
    const auto unknown = std::stable_partition(rows.begin(), rows.end(), [&](const LayerRow* row) {
        return !lacks_error(row, frame.state);
    });
    if (unknown != rows.end())
        report.warn(path.string() + ": written without " + listed(std::span(unknown, rows.end())) +
                    ", for which two passes or more are needed");
    rows.erase(unknown, rows.end());
    std::vector<LayerImage> layers = frame.layers;
    for (const LayerRow* row : rows)
        if (std::holds_alternative<OfFilm>(row->read))
            layers.push_back(film_layer(*row, frame.result.image, frame.state.film));
    const Image& image = frame.result.image;
    write_layers(path, arguments.layers.view_layer,
                 {image.width, image.height, frame.state.film.place}, layers);
    report.wrote(path, counted(layers.size(), "layer"));
}

void write_statistics(const OutputFiles& files, const std::string& json, Report& report)
{
    if (files.statistics.empty())
        return;
    write_file(files.statistics, json);
    report.wrote(files.statistics);
}

} // namespace hipmap
