#include "render/settings.h"

#include "common/input_error.h"
#include "common/partition/partition_file.h"
#include "common/report.h"
#include "common/scene/fingerprint.h"
#include "render/dissertation_settings.h"
#include "render/integrator/integrators.h"
#include "render/outputs.h"

#include <CLI/CLI.hpp>

#include <cstdio>

namespace hipmap {

namespace {

constexpr Choice<DirectLight> kDirectLights[] = {{"shadow-rays", DirectLight::shadow_rays},
                                                 {"photons", DirectLight::photons}};
constexpr Choice<Emission> kEmissions[] = {{"guided", Emission::guided},
                                           {"by-power", Emission::by_power}};
constexpr Choice<GatherDirections> kGatherDirections[] = {{"guided", GatherDirections::guided},
                                                          {"by-lobes", GatherDirections::by_lobes}};
constexpr Choice<GatherSharing> kGatherSharings[] = {{"none", GatherSharing::none},
                                                     {"neighbours", GatherSharing::neighbours}};
constexpr Choice<IndirectLight> kIndirectLights[] = {{"auto", IndirectLight::automatic},
                                                     {"photons", IndirectLight::photons},
                                                     {"paths", IndirectLight::paths}};
constexpr Choice<PixelFilter> kFilters[] = {{"b-spline", PixelFilter::b_spline},
                                            {"box", PixelFilter::box}};
constexpr Choice<LookChoice> kLooks[] = {{"auto", LookChoice::automatic},
                                         {"gltf", LookChoice::gltf},
                                         {"blender", LookChoice::blender},
                                         {"blender3", LookChoice::blender3}};

constexpr Choice<ProgressFormat> kProgressFormats[] = {{"text", ProgressFormat::text},
                                                       {"json", ProgressFormat::json}};

constexpr Choice<Quality> kQualities[] = {{"standard", Quality::standard},
                                          {"draft", Quality::draft},
                                          {"good", Quality::good},
                                          {"final", Quality::final}};

/// What the qualities stand for; the limit that is reached first applies.
constexpr std::uint64_t kDraftPasses = 4;
constexpr double kGoodError = 0.05, kFinalError = 0.02;
constexpr double kDraftSeconds = 60, kGoodSeconds = 20 * 60;

constexpr double kMostSamples = 65536;
constexpr double kMostClamp = 1e9;
constexpr double kMostDistance = 1e9;
constexpr double kMostPassesAsked = 1e6;
constexpr double kMostFirstPass = 1e15;
constexpr double kMostSeconds = 1e9;
constexpr double kMostMib = 1e9;
constexpr double kMostGib = 1e6;
constexpr double kLongestShutter = 1000;

constexpr const char* kMethodSection = "Method";
constexpr const char* kEffectsSection = "Effects";
constexpr const char* kEndSection = "When to end";

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

void choose_quality(Quality quality, RenderArguments& arguments)
{
    arguments.quality = quality;
    StopRules& stops = arguments.stops;
    switch (quality) {
    case Quality::standard:
        break;
    case Quality::draft:
        arguments.render.integrator = Integrator::direct;
        stops.passes = kDraftPasses;
        stops.seconds = kDraftSeconds;
        break;
    case Quality::good:
        stops.error = kGoodError;
        stops.seconds = kGoodSeconds;
        break;
    case Quality::final:
        stops.error = kFinalError;
        break;
    }
}

/// Its row must come before those of the options that it sets: the command line runs through the
/// table in order, so what is given by them overrides it.
OptionRow quality_row(RenderArguments& arguments)
{
    OptionField field = choice_field<Quality>(arguments.quality, kQualities);
    field = name_field(
        field.names,
        [&arguments](const std::string& name) {
            choose_quality(value_of<Quality>(kQualities, name), arguments);
        },
        field.value);
    return {.name = "quality",
            .section = kImageSection,
            .field = std::move(field),
            .help = "Settings at once, each overridden by its own option: draft (--integrator "
                    "direct --passes 4 --time 60), good (--error 5% --time 1200), final (--error "
                    "2%) or standard (none)"};
}

OptionRow photons_row(std::optional<std::uint64_t>& photons)
{
    return {.name = "photons",
            .section = kMethodSection,
            .field = number_field(photons, {0, kMostPhotons}),
            .help = "Light paths to emit in each pass",
            .unset = "as many as a pass has samples, within " + grouped(kFewestDefaultPhotons) +
                     " and " + grouped(kMostDefaultPhotons),
            .changes = Changes::passes};
}

OptionRow integrator_row(Integrator& integrator)
{
    static const std::vector<Choice<Integrator>> choices = [] {
        std::vector<Choice<Integrator>> out;
        for (const IntegratorKind& kind : integrator_kinds())
            out.push_back({kind.name, kind.id});
        return out;
    }();
    std::string help;
    for (const IntegratorKind& kind : integrator_kinds())
        help += (help.empty() ? "" : "; ") + std::string(kind.name) + ": " + kind.help;
    return {.name = "integrator",
            .section = kMethodSection,
            .field = choice_field<Integrator>(integrator, choices),
            .help = help,
            .changes = Changes::passes};
}

/// A choice of integrator progressive that its passes depend on.
template <typename T, std::size_t count>
OptionRow progressive_row(const char* name, T& value, const Choice<T> (&choices)[count],
                          const char* help)
{
    return {.name = name,
            .section = kMethodSection,
            .field = choice_field<T>(value, choices),
            .help = help,
            .changes = Changes::passes,
            .only_with = {{"", "integrator", {"progressive"}}}};
}

/// A setting of the integrators that trace photons.
template <typename T, std::size_t count>
OptionRow guide_row(const char* name, T& value, const Choice<T> (&choices)[count], const char* help)
{
    OptionRow row = progressive_row(name, value, choices, help);
    row.only_with = {{"", "integrator", {"progressive", "direct"}}};
    return row;
}

OptionRow emission_row(Emission& emission)
{
    return guide_row(
        "emission", emission, kEmissions,
        "Starts of the light paths: guided, where pilots found that they matter to the image, or "
        "by the power of the lights alone, as always by --integrator direct with methods of the "
        "dissertation");
}

OptionRow gather_row(GatherDirections& gather)
{
    return guide_row(
        "gather", gather, kGatherDirections,
        "Directions of the final-gather rays of --integrator progressive: guided, where "
        "pilots found light, or by the lobes of the surface alone; guided, both integrators with "
        "photons sample the sky where little of it is seen");
}

OptionRow sharing_row(GatherSharing& sharing)
{
    return progressive_row(
        "share-gathers", sharing, kGatherSharings,
        "Which pixels use what a final-gather ray of --integrator progressive finds: neighbours, "
        "eight together, for less noise in about the same time, or none but its own");
}

OptionRow indirect_row(IndirectLight& indirect)
{
    return progressive_row(
        "indirect-by", indirect, kIndirectLights,
        "Where --integrator progressive finds indirect light: photons, in the maps where "
        "final-gather rays end; paths, by rays that go on from there, which is quicker "
        "where light is easy to find; or auto, as a pilot chooses. Caustics are always "
        "photons, and with media all indirect light is");
}

std::vector<OptionRow> method_rows(RenderArguments& arguments)
{
    RenderOptions& render = arguments.render;
    return {integrator_row(render.integrator),
            photons_row(arguments.photons),
            emission_row(render.emission),
            gather_row(render.gather),
            sharing_row(render.sharing),
            indirect_row(render.indirect),
            {.name = "neighbours",
             .section = kMethodSection,
             .field = number_field(render.maps.neighbours, {2, kMostNeighbours}),
             .help = "Photons in an estimate, k",
             .changes = Changes::passes},
            {.name = "alpha",
             .section = kMethodSection,
             .field = number_field(render.alpha, {0.01, 0.99}, "A"),
             .help = "Decay of the radii of --integrator progressive; a smaller value gives less "
                     "bias and more noise",
             .changes = Changes::passes,
             .only_with = {{"", "integrator", {"progressive"}}}},
            {.name = "occlusion-distance",
             .section = kMethodSection,
             .field = number_field(render.occlusion_distance, {0, kMostDistance}, "M"),
             .help = "Distance within which --integrator occlusion looks for faces, in metres; 0: "
                     "an eighth of the scene's diagonal",
             .changes = Changes::passes,
             .only_with = {{"", "integrator", {"occlusion"}}}},
            {.name = "direct",
             .section = kMethodSection,
             .field = choice_field<DirectLight>(render.direct, kDirectLights),
             .help = "Direct light by shadow rays or from the photons",
             .changes = Changes::passes,
             .only_with = {{"photons", "integrator", {"direct"}},
                           {"photons", "maps", {"global", "shared", "thesis", "hierarchical"}}}},
            {.name = "seed",
             .section = kMethodSection,
             .field = seed_field(render.seed),
             .help = "Seed; the same seed gives the same image, bit for bit, at any --threads",
             .changes = Changes::passes}};
}

OptionRow tile_row(std::optional<Tile>& tile)
{
    return {.name = "tile",
            .section = kImageSection,
            .field = tile_field(tile),
            .help = "Render only this tile of the image, counted from 0 at the top left, row by "
                    "row: one of many tasks, whose states render merge puts together, bit for bit",
            .unset = "all of the image"};
}

std::vector<OptionRow> image_rows(RenderArguments& arguments)
{
    RenderOptions& render = arguments.render;
    return {{.name = "size",
             .section = kImageSection,
             .field = size_field(arguments.size),
             .help = "Image size in pixels, or percent of the default; W alone takes the camera's "
                     "aspect",
             .changes = Changes::passes},
            {.name = "crop",
             .section = kImageSection,
             .field = crop_field(arguments.crop),
             .help = "Render only this part of the image, from the left and the top, in pixels or "
                     "percent, up to X1 and Y1 exclusively. Its pixels equal those of the whole "
                     "image, bit for bit",
             .unset = "the whole image",
             .changes = Changes::passes},
            tile_row(arguments.tile),
            {.name = "samples",
             .section = kImageSection,
             .field = number_field(render.samples, {1, kMostSamples}),
             .help = "Mean samples of each pixel in a pass; noisy pixels get more",
             .changes = Changes::passes},
            {.name = "clamp",
             .section = kImageSection,
             .field = number_field(render.clamp, {0, kMostClamp}, "RADIANCE"),
             .help = "Limit samples to this radiance, W/(m2 sr), against fireflies; lights seen "
                     "directly stay. The error counts the light removed as bias; 0: no limit",
             .changes = Changes::passes,
             .only_with = {{"", "integrator", {"progressive", "direct", "path"}}}},
            {.name = "filter",
             .section = kImageSection,
             .field = choice_field<PixelFilter>(render.filter, kFilters),
             .help = "Pixel reconstruction filter: b-spline (3 pixels wide, standard deviation "
                     "half a pixel: less noise) or box (1 pixel: sharp)",
             .changes = Changes::passes}};
}

std::vector<OptionRow> effect_rows(RenderArguments& arguments)
{
    return {
        {.name = "explain",
         .section = kEffectsSection,
         .field = flag_field(arguments.explain),
         .help = "List the effects this scene needs, with reasons and costs, and exit"},
        {.name = "effects",
         .section = kEffectsSection,
         .field = parsed_field(
             [&](const std::string& text) { arguments.effects = parse_effect_switches(text); },
             [&] {
                 return arguments.effects.empty() ? SettingValue()
                                                  : SettingValue(text_of(arguments.effects));
             },
             "LIST"),
         .help =
             "Effects to leave out, such as -caustics,-textures; +NAME cancels an earlier -NAME",
         .changes = Changes::scene},
        {.name = "look",
         .section = kEffectsSection,
         .field = choice_field<LookChoice>(arguments.scene_options.look, kLooks),
         .help = "What materials and lights look like: gltf, as glTF specifies; blender, as in "
                 "Cycles of the Blender that wrote the file (Blender 4 for other files); blender3, "
                 "as before Blender 4; auto, as in the program that wrote the file",
         .changes = Changes::scene},
        {.name = "energy-compensation",
         .section = kEffectsSection,
         .field = flag_field(arguments.energy_compensation),
         .help =
             "Multiple scattering of rough metal: adds the light that its microfacets scatter "
             "more than once, which glTF's model loses (60 % at roughness 1); not for rough glass",
         .changes = Changes::scene}};
}

std::vector<OptionRow> end_rows(RenderArguments& arguments)
{
    StopRules& stops = arguments.stops;
    return {
        {.name = "passes",
         .section = kEndSection,
         .field = number_or_none_field(stops.passes, StopRules().passes, {1, kMostPassesAsked}),
         .help = "End after this many independent passes, whose images are averaged",
         .unset = std::to_string(kDefaultPasses) + ", unless --time or --error is given"},
        {.name = "time",
         .section = kEndSection,
         .field = number_or_none_field(stops.seconds, StopRules().seconds, {0, kMostSeconds}, "S"),
         .help = "End after this many seconds of rendering"},
        {.name = "error",
         .section = kEndSection,
         .field = parsed_field(
             [&](const std::string& text) { stops.error = parse_error(text); },
             [&] { return stops.error > 0 ? SettingValue(stops.error) : SettingValue(); }, "E%"),
         .help = "End when the estimated error (root mean square, relative) is at most this, "
                 "5%"},
        {.name = "quote",
         .section = kEndSection,
         .field = flag_field(arguments.quote),
         .help =
             "Render two to eight passes and print what errors would cost, with other integrators "
             "and without effects too; --state keeps the passes"},
        {.name = "state",
         .section = kEndSection,
         .field = file_field(arguments.files.state),
         .help = "Keep the passes in this file, and resume from it if it exists"},
        {.name = "replace-state",
         .section = kEndSection,
         .field = flag_field(arguments.files.replace_state),
         .help = "Start over if the state is of another scene or other options; the old state "
                 "becomes FILE.old",
         .needs = "state"},
        {.name = "first-pass",
         .section = kEndSection,
         .field = number_field(stops.first_pass, {0, kMostFirstPass}),
         .help = "Number of the first pass, for runs to be merged with others"}};
}

std::vector<OptionRow> speed_rows(RenderArguments& arguments)
{
    return {threads_row(arguments.threads),
            {.name = "memory",
             .section = kRunSection,
             .field = number_field(arguments.memory_gib, {0, kMostGib}, "GIB"),
             .help =
                 "Keep to this many GiB: lowers --photons where a pass would need more, and says "
                 "so; 0: no limit"},
            {.name = "photon-cache",
             .section = kRunSection,
             .field = number_field(arguments.photon_cache_mib, {0, kMostMib}, "MIB"),
             .help = "MiB for photon maps that further frames may reuse"},
            texture_cache_row(arguments.scene_options.texture_cache_mib),
            {.name = "mpi",
             .section = kRunSection,
             .field = flag_field(arguments.mpi),
             .help = "Share the passes with the other processes that mpirun started: mpirun -n N "
                     "render ... --mpi. The image is the same, bit for bit"},
            {.name = "progress",
             .section = kRunSection,
             .field = choice_field<ProgressFormat>(arguments.progress, kProgressFormats, "FORMAT"),
             .help = "text, or json: also lines of JSON on standard output, for a program that "
                     "shows the render"},
            verbose_row(arguments.verbose)};
}

OptionRow shutter_row(RenderArguments& arguments)
{
    return {.name = "shutter",
            .section = kAnimationSection,
            .field = number_field(arguments.shutter, {0, kLongestShutter}, "FRAMES"),
            .help = "Motion blur: shutter time in frames, half of it before the "
                    "frame's moment; Blender's is 0.5",
            .changes = Changes::scene,
            .needs = "frames"};
}

std::string hex(std::uint64_t word)
{
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(word));
    return text;
}

} // namespace

std::vector<OptionRow> option_rows(RenderArguments& arguments)
{
    std::vector<OptionRow> rows = output_rows(arguments.files, false);
    append_rows(rows, layer_option_rows(arguments.files, arguments.layers));
    rows.push_back(quality_row(arguments));
    append_rows(rows, image_rows(arguments));
    append_rows(rows, method_rows(arguments));
    append_rows(rows, end_rows(arguments));
    append_rows(rows, effect_rows(arguments));
    append_rows(rows, scene_rows(arguments.scene_options, arguments.sky));
    append_rows(rows, frame_rows(arguments.frames));
    rows.push_back(shutter_row(arguments));
    append_rows(rows, speed_rows(arguments));
    append_rows(rows, dissertation_rows(arguments.render.dissertation));
    return rows;
}

std::vector<OptionRow> option_rows(MergeArguments& arguments)
{
    std::vector<OptionRow> rows = output_rows(arguments.files, true);
    rows.push_back({.name = "state",
                    .section = kFilesSection,
                    .field = file_field(arguments.files.state),
                    .help = "Write all passes as one state"});
    rows.push_back({.name = "passes",
                    .section = kEndSection,
                    .field = number_field(arguments.passes, {1, kMostPassesAsked}),
                    .help = "Passes that the image should have, from 0; those missing are listed",
                    .unset = "all between the first and the last that some pixel has"});
    return rows;
}

void add_arguments(CLI::App& app, RenderArguments& arguments)
{
    app.add_option("SCENE", arguments.scene, "Scene: .glb, .gltf or .obj")->required();
    app.add_option("PARTITION", arguments.partition,
                   "Partition of that scene (.hpm), by preprocess")
        ->required();
    add_options(app, option_rows(arguments));
}

void add_arguments(CLI::App& app, MergeArguments& arguments)
{
    app.add_option("STATE", arguments.states,
                   "States of renders of one image, or folders of files FILE.state")
        ->required();
    add_options(app, option_rows(arguments));
}

void add_arguments(CLI::App& app, DescribeArguments& arguments)
{
    app.add_option("STATE", arguments.states, "States to describe")->required();
}

std::vector<Setting> values_of(const RenderArguments& arguments)
{
    RenderArguments copy = arguments; // rows are bound to what may be changed
    std::vector<Setting> out;
    for (const OptionRow& row : option_rows(copy))
        if (row.field.value)
            out.push_back({row.name, row.field.value()});
    return out;
}

std::vector<Setting> settings_of(const RenderArguments& arguments, const Scene& scene,
                                 const Partition& partition, const EnvironmentMap& sky)
{
    const Fingerprint content = content_fingerprint(scene);
    std::vector<Setting> out = {{"scene", hex(content.words[0]) + hex(content.words[1])},
                                {"sky", sky.empty() ? "plain" : hex(checksum(sky))},
                                {"partition", hex(partition_checksum(partition))},
                                {"caustics", arguments.render.light.caustic},
                                {"indirect", arguments.render.light.indirect}};
    RenderArguments copy = arguments; // rows are bound to what may be changed
    for (const OptionRow& row : option_rows(copy))
        if (row.changes == Changes::passes)
            out.push_back({row.name, row.field.value()});
    return out;
}

} // namespace hipmap
