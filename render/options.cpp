#include "render/options.h"

#include "common/command_line/scene_arguments.h"
#include "common/image/image_format.h"
#include "common/input_error.h"
#include "render/check_method.h"

#include <map>

namespace hipmap {

namespace {

const std::map<std::string, MapMode> kMapModes = {{"none", MapMode::none},
                                                  {"global", MapMode::global},
                                                  {"shared", MapMode::shared},
                                                  {"thesis", MapMode::thesis},
                                                  {"hierarchical", MapMode::hierarchical}};

const std::map<std::string, TierChoice> kTierChoices = {{"paying", TierChoice::paying},
                                                        {"all", TierChoice::all}};

const std::map<std::string, TreeKind> kTrees = {{"wide", TreeKind::wide},
                                                {"balanced", TreeKind::balanced},
                                                {"unbalanced", TreeKind::unbalanced}};

const std::map<std::string, EstimateForm> kEstimates = {{"clipped", EstimateForm::clipped},
                                                        {"thesis", EstimateForm::thesis}};

const std::map<std::string, Integrator> kIntegrators = {{"direct", Integrator::direct},
                                                        {"path", Integrator::path},
                                                        {"progressive", Integrator::progressive}};

const std::map<std::string, GatheredIrradiance> kIrradiances{
    {"estimated", GatheredIrradiance::estimated}, {"precomputed", GatheredIrradiance::precomputed}};
const std::map<std::string, PixelFilter> kFilters = {{"box", PixelFilter::box},
                                                     {"b-spline", PixelFilter::b_spline}};
const std::map<std::string, DirectLight> kDirectLights = {{"shadow-rays", DirectLight::shadow_rays},
                                                          {"photons", DirectLight::photons}};

const std::map<std::string, std::optional<DiffuseModel>> kDiffuseModels = {
    {"auto", std::nullopt}, {"lambert", DiffuseModel::lambert}, {"burley", DiffuseModel::burley}};

/// The thesis' ratio of the fewest photons of a local map to k.
constexpr std::uint32_t kLocalMinPerNeighbour = 10;

constexpr double kMostPhotons = 4e9;
constexpr double kMostNeighbours = 1e6;
constexpr double kMostExposure = 100;
constexpr double kMostPassesAsked = 1e6;
constexpr double kMostFirstPass = 1e15;
constexpr double kMostSeconds = 1e9;
constexpr double kLongestShutter = 1000;
constexpr std::uint64_t kPasses = 16;

template <typename Value>
void add_choice(CLI::App& app, const std::string& name, Value& into,
                const std::map<std::string, Value>& choices, const std::string& help)
{
    app.add_option_function<std::string>(
           name, [&into, &choices](const std::string& choice) { into = choices.at(choice); }, help)
        ->check(CLI::IsMember(choices))
        ->type_name("NAME");
}

template <typename Value>
void add_count(CLI::App& app, const std::string& name, Value& into, double low, double high,
               const std::string& help)
{
    app.add_option(name, into, help)->check(finite_in(low, high))->type_name("N");
}

/// "5%" and "5" are 0.05.
double parse_error(const std::string& text)
{
    constexpr double kLeastPercent = 1e-3;
    const std::string number = text.ends_with('%') ? text.substr(0, text.size() - 1) : text;
    double percent = 0;
    if (!CLI::detail::lexical_cast(number, percent) ||
        !(percent >= kLeastPercent && percent <= 100))
        throw CLI::ValidationError(
            "--error", "'" + text + "' is not an error; write a percentage from 0.001 to 100");
    return percent / 100;
}

void add_images(CLI::App& app, std::vector<std::filesystem::path>& images)
{
    app.add_option("-o,--output", images,
                   "Image to write; repeatable. .exr, .pfm, .hdr hold radiance, W/(m2 sr), .exr "
                   "its noise, bias and error too; .png, .ppm are exposed sRGB")
        ->allow_extra_args(false)
        ->type_name("FILE");
}

void add_statistics(CLI::App& app, std::filesystem::path& error_image,
                    std::filesystem::path& statistics)
{
    app.add_option_function<std::string>(
           "--error-image",
           [&error_image](const std::string& text) {
               error_image = text;
               if (image_format(error_image) != ImageFormat::png)
                   throw InputError(text + ": the picture of the error is .png; -o FILE.exr holds "
                                           "the error by pixel in numbers");
           },
           "Write a picture of the relative error of each pixel in false colour, .png")
        ->type_name("FILE");
    app.add_option("--stats", statistics, "Write statistics as JSON")->type_name("FILE");
}

void add_exposure(CLI::App& app, std::optional<float>& exposure_ev)
{
    app.add_option_function<std::string>(
           "--exposure",
           [&exposure_ev](const std::string& text) {
               if (text == "auto")
                   exposure_ev.reset();
               else
                   exposure_ev = std::stof(text);
           },
           "Exposure of 8-bit images in stops, or auto [auto]")
        ->check(CLI::IsMember({"auto"}) | finite_in(-kMostExposure, kMostExposure))
        ->type_name("EV|auto");
}

void add_files(CLI::App& app, RenderArguments& arguments)
{
    app.add_option("SCENE", arguments.scene, "Scene: .glb, .gltf or .obj")->required();
    app.add_option("PARTITION", arguments.partition,
                   "Partition of that scene (.hpm), by preprocess")
        ->required();
    add_images(app, arguments.images);
    add_statistics(app, arguments.error_image, arguments.statistics);
}

void add_method(CLI::App& app, RenderArguments& arguments)
{
    RenderOptions& render = arguments.render;
    render.maps.mode = MapMode::hierarchical;
    render.samples = 4;
    add_choice(
        app, "--maps", render.maps.mode, kMapModes,
        "Photon maps: none (direct light and reflections only), global (one map), shared (one "
        "for each shared map of the partition), thesis (and local maps), hierarchical (shared, and "
        "local and group maps where they save time) [hierarchical]");
    add_choice(app, "--tiers", render.maps.tiers, kTierChoices,
               "Local and group maps of --maps hierarchical: paying, or all, to measure them "
               "[paying]");
    add_choice(app, "--tree", render.maps.tree, kTrees,
               "What photons are searched in: wide; or, to compare with, balanced (Jensen's "
               "kd-tree) or unbalanced (a kd-tree made by inserting) [wide]");
    add_choice(
        app, "--estimate", render.maps.estimate, kEstimates,
        "Irradiance from k photons: clipped (k-1 of them over the area seen from the point), "
        "thesis (k over the whole disc, as in the dissertation, to compare with) [clipped]");
    add_choice(app, "--integrator", render.integrator, kIntegrators,
               "progressive: photon maps and a gather ray, by radii that shrink from pass to pass; "
               "direct: the maps are looked at directly; path: path tracing without photons, to "
               "compare with [progressive]");
    add_choice(app, "--direct", render.direct, kDirectLights,
               "Direct light by shadow-rays or from the photons [shadow-rays]");
    add_choice(
        app, "--irradiance", render.irradiance, kIrradiances,
        "Irradiance where gather rays end: estimated there, or precomputed at a quarter of the "
        "photons and read from one near by (Christensen), to compare with: off by some "
        "percent of indirect light, and no faster [estimated]");
    add_choice(
        app, "--diffuse", arguments.diffuse, kDiffuseModels,
        "Diffuse reflection: lambert, as glTF has it; burley, as Blender's Principled BSDF up to "
        "version 3 has it; auto, as the program that wrote the file has it [auto]");
    app.add_flag("--energy-compensation", arguments.energy_compensation,
                 "Give rough metal back the light that its facets pass to one another, which "
                 "glTF's own reflection loses; rough glass still loses it");
    add_count(app, "--photons", arguments.photons, 0, kMostPhotons,
              "Light paths to emit in each pass [as many as it has samples, within 200000 and "
              "2000000]");
    add_count(app, "--neighbours", render.maps.neighbours, 2, kMostNeighbours,
              "Photons in an estimate, k [50]");
    add_count(app, "--local-min", render.maps.local_min, 1, kMostPhotons,
              "Fewest photons of a local map, M [10 k]");
    app.add_option("--alpha", render.alpha,
                   "How slowly the radii of --integrator progressive shrink, between 0 and 1: less "
                   "leaves less bias and more noise [2/3]")
        ->check(finite_in(0.01, 0.99))
        ->type_name("A");
    add_count(app, "--samples", render.samples, 1, 65536, "Samples of each pixel in a pass [4]");
    add_choice(app, "--filter", render.filter, kFilters,
               "What a sample counts in the pixels around: box (in its own alone: sharp) or "
               "b-spline (3 pixels wide: soft as a Gaussian of half a pixel, with less noise) "
               "[b-spline]");
    app.add_option_function<std::string>(
           "--effects",
           [&arguments](const std::string& text) {
               arguments.effects = parse_effect_switches(text);
           },
           "Effects to leave out, as -caustics,-textures; +NAME takes back an earlier -NAME")
        ->type_name("LIST");
    app.add_flag("--explain", arguments.explain,
                 "Only say which effects the scene calls for, why, and what they cost");
    app.add_option("--seed", render.seed, "Seed; the same seed gives the same image [0]")
        ->type_name("N");
}

void add_stops(CLI::App& app, RenderArguments& arguments)
{
    StopRules& stops = arguments.stops;
    add_count(app, "--passes", stops.passes, 1, kMostPassesAsked,
              "End after so many independent passes, whose images are averaged [16, if nothing "
              "else is to end it]");
    app.add_option("--time", stops.seconds, "End after so many seconds of rendering")
        ->check(finite_in(0, kMostSeconds))
        ->type_name("S");
    app.add_option_function<std::string>(
           "--error", [&stops](const std::string& text) { stops.error = parse_error(text); },
           "End when the error (root of the mean relative square) is so small, as 5%")
        ->type_name("E%");
    app.add_flag("--quote", arguments.quote,
                 "Only render a few passes and say what errors would cost");
    app.add_option("--state", arguments.state,
                   "Keep the passes in this file, and go on with those it holds")
        ->type_name("FILE");
    add_count(app, "--first-pass", stops.first_pass, 0, kMostFirstPass,
              "Take passes from this number on, to be merged with others [0]");
}

void add_picture(CLI::App& app, RenderArguments& arguments)
{
    app.add_option_function<std::string>(
           "--size",
           [&arguments](const std::string& text) { arguments.size = parse_picture_size(text); },
           "Picture size in pixels; W alone takes the camera's aspect [512]")
        ->type_name("WxH");
    add_exposure(app, arguments.exposure_ev);
    add_count(app, "--threads", arguments.threads, 0, 4096, "Threads; 0: all cores [0]");
}

} // namespace

void add_render_arguments(CLI::App& app, RenderArguments& arguments)
{
    add_files(app, arguments);
    add_method(app, arguments);
    add_stops(app, arguments);
    add_picture(app, arguments);
    add_scene_arguments(app, arguments.scene_options, arguments.sky);
    add_frame_arguments(app, arguments.frames);
    add_count(app, "--photon-cache", arguments.photon_cache_mib, 0, 1e9,
              "MiB for photon maps that further frames use while only the camera moves [1024]");
    app.add_option("--shutter", arguments.shutter,
                   "Motion blur: frames that the shutter is open, half of them before the frame's "
                   "moment; Blender's is 0.5 [0]")
        ->check(finite_in(0, kLongestShutter))
        ->needs("--frames")
        ->type_name("FRAMES");
}

RenderArguments arguments_of_frame(const RenderArguments& all, int frame)
{
    RenderArguments out = all;
    set_frame(out.scene_options, out.frames, frame);
    for (std::filesystem::path* file :
         {&out.partition, &out.error_image, &out.statistics, &out.state})
        *file = frame_path(*file, frame);
    for (std::filesystem::path& image : out.images)
        image = frame_path(image, frame);
    return out;
}

void add_merge_arguments(CLI::App& app, MergeArguments& arguments)
{
    app.add_option("STATE", arguments.states, "States of renders of one image")->required();
    add_images(app, arguments.images);
    app.get_option("--output")->required();
    add_exposure(app, arguments.exposure_ev);
    add_statistics(app, arguments.error_image, arguments.statistics);
    app.add_option("--state", arguments.state, "Write all passes as one state")->type_name("FILE");
}

void complete_arguments(const CLI::App& app, RenderArguments& arguments)
{
    for (const std::filesystem::path& image : arguments.images)
        image_format(image); // refuses an unknown suffix
    if (arguments.images.empty() && !arguments.quote && !arguments.explain)
        throw InputError(
            "--output is required; give an image to write with -o, --quote or --explain");
    if (arguments.quote && !arguments.state.empty())
        throw InputError("--quote keeps no passes; leave out --state");
    if (app.count("--passes") + app.count("--time") + app.count("--error") == 0)
        arguments.stops.passes = kPasses;
    if (arguments.quote)
        arguments.stops.passes = std::min(arguments.stops.passes, kBatches);
    MapOptions& maps = arguments.render.maps;
    if (app.count("--local-min") == 0)
        maps.local_min = kLocalMinPerNeighbour * maps.neighbours;
    check_method(arguments.render);
}

} // namespace hipmap
