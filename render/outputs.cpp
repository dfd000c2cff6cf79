#include "render/outputs.h"

#include "common/command_line/command_line.h"
#include "common/file/output_file.h"
#include "common/image/exposure.h"
#include "common/input_error.h"
#include "common/scene/scene_names.h"
#include "common/stopwatch.h"
#include "render/image_files.h"
#include "render/settings.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <iomanip>
#include <iterator>
#include <sstream>

namespace hipmap {

namespace {

constexpr double kMostExposure = 100;

constexpr Choice<FireflyChoice> kFireflyChoices[] = {{"keep", FireflyChoice::keep},
                                                     {"remove", FireflyChoice::remove}};

/// Returns the exposure of 8-bit images.
float write_each(const OutputFiles& files, const Image& image, const RenderState& state,
                 Report& report)
{
    const float ev = files.exposure_ev ? *files.exposure_ev : auto_exposure(image);
    for (const std::filesystem::path& path : files.images) {
        write_image_of(path, image, state, {ev, files.view});
        std::ostringstream note;
        if (is_exposed(path))
            note << "exposure " << std::showpos << std::fixed << std::setprecision(2) << ev << " EV"
                 << (files.exposure_ev ? "" : ", auto");
        report.wrote(path, note.str());
    }
    return ev;
}

std::vector<LegendedPicture> write_pictures(const OutputFiles& files, const RenderState& state,
                                            Report& report)
{
    std::vector<LegendedPicture> out;
    for (const RequestedPicture& picture : requested_pictures(files.pictures)) {
        if (!picture.row->is_known(state)) {
            report.warn(picture.path.string() + ": not written; " + picture.row->lacking);
            continue;
        }
        out.push_back(write_picture(picture, state));
        report.wrote(picture.path);
    }
    return out;
}

OptionRow picture_row(const PictureRow& row, std::filesystem::path& path)
{
    const auto parse = [&row, &path](const std::string& text) {
        path = text;
        if (image_format(path) != ImageFormat::png)
            throw InputError(text + ": --" + row.option +
                             " must be .png; -o FILE.exr holds what it shows in numbers");
    };
    return {.name = row.option,
            .section = kFilesSection,
            .field = parsed_field(parse, {}, "FILE"),
            .help = row.help};
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

/// How images are shown.
std::vector<OptionRow> shown_rows(OutputFiles& files)
{
    return {{.name = "fireflies",
             .section = kImageSection,
             .field = choice_field<FireflyChoice>(files.fireflies, kFireflyChoices),
             .help = "remove: rare bright samples are taken out of their pixels, and the error "
                     "counts the light removed as bias; keep: they stay in the images. The state "
                     "keeps them"},
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

} // namespace

std::vector<OptionRow> output_rows(OutputFiles& files, bool required)
{
    std::vector<OptionRow> out = {
        {.name = "output",
         .section = kFilesSection,
         .field = files_field(files.images),
         .help = "Image to write; repeatable. .exr, .pfm and .hdr hold radiance, W/(m2 sr), "
                 ".exr its noise, bias and error too; .png and .ppm are exposed sRGB. "
                 "Rewritten after passes",
         .flags = "-o,--output",
         .required = required}};
    for (std::size_t i = 0; i < files.pictures.size(); ++i)
        out.push_back(picture_row(picture_rows()[i], files.pictures[i]));
    out.push_back({.name = "stats",
                   .section = kFilesSection,
                   .field = file_field(files.statistics),
                   .help = "Write statistics as JSON"});
    std::ranges::move(shown_rows(files), std::back_inserter(out));
    return out;
}

std::vector<OptionRow> layer_option_rows(OutputFiles& files, LayerChoice& layers)
{
    return {
        {.name = "layers",
         .section = kFilesSection,
         .field = parsed_field(
             [&](const std::string& text) { parse_layer_file(text, files.layers); }, {}, "FILE"),
         .help = "Write render passes, such as depth and normals, as one multi-layer .exr that "
                 "Blender reads. Rewritten after passes"},
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
    out.pictures = write_pictures(files, state, report);
    out.writing.add(writing);
    out.warnings = report.warnings();
    return out;
}

void write_requested_layers(const RenderArguments& arguments, const RenderedFrame& frame,
                            Report& report)
{
    const std::filesystem::path& path = arguments.files.layers;
    if (path.empty())
        return;
    const WrittenLayers layers =
        write_layers_of(path, arguments.layers, frame.layers, frame.result.image, frame.state);
    if (!layers.unknown.empty())
        report.warn(path.string() + ": written without " + listed(layers.unknown) +
                    ", for which two passes or more are needed");
    report.wrote(path, counted(layers.written, "layer"));
}

void write_statistics(const OutputFiles& files, const std::string& json, Report& report)
{
    if (files.statistics.empty())
        return;
    write_file(files.statistics, json);
    report.wrote(files.statistics);
}

} // namespace hipmap
