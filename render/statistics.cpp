#include "render/statistics.h"

#include "common/image/picture_json.h"
#include "common/scene/named_lights.h"
#include "render/describe_error.h"
#include "render/settings.h"

namespace hipmap {

namespace {

using Json = nlohmann::ordered_json;

Json searches_json(const LevelSearches& searches)
{
    return {{"searches", searches.begun},
            {"searches_skipped", searches.skipped},
            {"searches_abandoned", searches.abandoned}};
}

Json level_json(const LevelPlan& plan, const LevelSearches& searches)
{
    Json json = {{"used", plan.used},
                 {"decision", describe_plan(plan)},
                 {"asking", plan.asking},
                 {"most", plan.most}};
    if (plan.counted) {
        json["candidates"] = plan.candidates;
        json["photons"] = plan.photons;
        json["asked"] = plan.asked;
        json["answered"] = plan.answered;
        json["saving"] = plan.saving;
    }
    json.update(searches_json(searches));
    return json;
}

Json kind_json(const KindStatistics& kind, MapMode mode)
{
    Json json = {{"stored", kind.stored},
                 {"shared_maps", kind.shared_maps},
                 {"local_maps", kind.levels.local_maps},
                 {"group_maps", kind.levels.group_maps},
                 {"largest_map", kind.largest_map},
                 {"queries", kind.searches.queries},
                 {"photons_found", kind.searches.photons_found}};
    if (kind.levels.local_plan.asking > 0) { // planned
        json["local"] = level_json(kind.levels.local_plan, kind.level_searches.local);
        json["group"] = level_json(kind.levels.group_plan, kind.level_searches.group);
    } else if (mode == MapMode::thesis || mode == MapMode::hierarchical) {
        json["local"] = searches_json(kind.level_searches.local);
        json["group"] = searches_json(kind.level_searches.group);
    }
    return json;
}

Json rgb_json(const glm::dvec3& value)
{
    return {value.x, value.y, value.z};
}

/// A number, a text or null.
struct JsonOf {
    Json operator()(std::monostate) const { return {}; }
    template <typename Value>
    Json operator()(const Value& value) const
    {
        return value;
    }
};

/// By name; in statistics an underscore stands for the hyphen of the command line.
Json settings_json(const std::vector<Setting>& settings)
{
    Json json = Json::object();
    for (const Setting& setting : settings) {
        std::string name = setting.name;
        std::replace(name.begin(), name.end(), '-', '_');
        json[name] = std::visit(JsonOf(), setting.value);
    }
    return json;
}

Json seconds_json(const PreparedFrame& frame, const RenderedFrame& rendered,
                  const WrittenFiles& written)
{
    const RenderStatistics& render = rendered.statistics;
    const RunCosts& costs = rendered.result.costs;
    Json json = {{"scene", frame.reading.seconds},
                 {"rays", rendered.rays.seconds},
                 {"pilots", rendered.pilots.seconds},
                 {"photons", render.seconds_photons},
                 {"maps", render.seconds_maps},
                 {"image", render.seconds_image},
                 {"film", costs.film.seconds},
                 {"previews", costs.previews.seconds},
                 {"state", frame.reading_state.seconds + costs.state.seconds},
                 {"write", written.writing.seconds}};
    if (costs.rounds > 0) {
        json["wait"] = costs.wait.seconds;
        json["add"] = costs.add.seconds;
    }
    return json;
}

Json processor_seconds_json(const PreparedFrame& frame, const RenderedFrame& rendered,
                            const WrittenFiles& written)
{
    const RenderStatistics& render = rendered.statistics;
    const RunCosts& costs = rendered.result.costs;
    Json json = {{"scene", frame.reading.processor},
                 {"rays", rendered.rays.processor},
                 {"pilots", rendered.pilots.processor},
                 {"photons", render.processor_photons},
                 {"maps", render.processor_maps},
                 {"image", render.processor_image},
                 {"film", costs.film.processor},
                 {"previews", costs.previews.processor},
                 {"state", frame.reading_state.processor + costs.state.processor},
                 {"write", written.writing.processor},
                 {"process", Stopwatch::processor_seconds_of_process()}};
    if (costs.rounds > 0)
        json["add"] = costs.add.processor;
    return json;
}

Json scene_json(const RenderArguments& arguments, const Scene& scene)
{
    return {{"file", arguments.scene.string()},
            {"faces", scene.mesh.all_face_count()},
            {"materials", scene.materials.size()},
            {"lights", named_lights(scene.lights).size()},
            {"camera", scene.cameras[scene.camera].name},
            {"metres_per_unit", scene.frame.metres_per_unit}};
}

Json power_json(const PowerBalance& power, const Scene& scene)
{
    const double unit2 = scene.frame.metres_per_unit * scene.frame.metres_per_unit;
    return {{"emitted", rgb_json(power.emitted * unit2)},
            {"absorbed", rgb_json(power.absorbed * unit2)},
            {"escaped", rgb_json(power.escaped * unit2)}};
}

Json effects_json(const EffectPlan& plan)
{
    Json out = Json::array();
    for (const PlannedEffect& effect : plan.effects)
        out.push_back({{"name", name_of(effect.effect)},
                       {"on", effect.on},
                       {"reason", effect.reason},
                       {"cost", effect.cost}});
    return out;
}

Json check_json(const ErrorCheck& check)
{
    const ImageError& error = check.error;
    Json json = {{"passes", check.passes},
                 {"seconds", check.seconds},
                 {"error", error.error},
                 {"low", error.low},
                 {"high", error.high}, // null if infinite
                 {"noise", std::sqrt(error.noise2)}};
    if (error.bias == BiasKnowledge::from_radii) {
        json["photon_noise"] = std::sqrt(error.photon2);
        json["bias2"] = error.bias2;
        json["bias_order"] = error.order;
    }
    if (error.clamp2 > 0)
        json["clamp"] = std::sqrt(error.clamp2);
    if (error.removed2 > 0)
        json["removed"] = std::sqrt(error.removed2);
    if (error.missing2 > 0)
        json["missing"] = std::sqrt(error.missing2);
    return json;
}

/// Null if there are none.
Json fireflies_json(const std::optional<Fireflies>& found)
{
    if (!found)
        return {};
    return {{"pixels", found->pixels},
            {"share", found->share},
            {"error_without", found->error_without}};
}

/// Null if they were to be kept.
Json removed_json(const std::optional<RemovedFireflies>& removed)
{
    if (!removed)
        return {};
    return {{"pixels", removed->pixels},
            {"light", removed->light},
            {"error", std::sqrt(removed->bias2)}};
}

Json cost_json(const ErrorCost& cost)
{
    Json json = {{"error", cost.error},
                 {"passes", cost.passes},
                 {"seconds", cost.seconds},
                 {"photons", cost.photons}};
    if (cost.is_range()) {
        json["most_passes"] = cost.most_passes;
        json["most_seconds"] = cost.most_seconds;
    }
    return json;
}

const char* name_of_bias(BiasKnowledge bias)
{
    static constexpr const char* kNames[] = {"none", "unknown", "from radii"};
    return kNames[static_cast<int>(bias)];
}

/// target: of the error; 0 for none.  before: s before the first pass.
Json error_json(const RenderState& state, const ShownFireflies& fireflies, double target,
                double before)
{
    Json checks = Json::array(), costs = Json::array();
    for (const ErrorCheck& check : state.checks)
        checks.push_back(check_json(check));
    for (const ErrorCost& cost : error_costs(state, target, before))
        costs.push_back(cost_json(cost));
    const ErrorLaw law = error_law(state.checks, state.radius_decay);
    return {{"bias", name_of_bias(state.film.bias)},
            {"seconds_before", before},
            {"checks", checks},
            {"fireflies", fireflies_json(fireflies.kept)},
            {"removed_fireflies", removed_json(fireflies.removed)},
            {"law",
             {{"by_pass", law.by_pass},
              {"by_photon", law.by_photon},
              {"photon_power", law.photon_power},
              {"by_bias", law.by_bias},
              {"by_clamp", law.by_clamp},
              {"bias_power", law.bias_power}}},
            {"prices", costs},
            {"memory", peak_memory()}};
}

Json quote_json(const Quote& quote)
{
    Json integrators = Json::array(), effects = Json::array();
    for (const QuotedIntegrator& other : quote.integrators) {
        integrators.push_back({{"option", other.option}, {"bias", name_of_bias(other.bias)}});
        integrators.back().update(cost_json(other.cost));
    }
    for (const QuotedEffect& effect : quote.effects)
        effects.push_back({{"option", effect.option},
                           {"saved", effect.saved},
                           {"seconds_saved", effect.seconds_saved},
                           {"error2_added", effect.added.square},
                           {"error2_spread", effect.added.spread}});
    return {{"error", quote.error},
            {"integrators", integrators},
            {"effects", effects},
            {"not_compared", quote.not_compared},
            {"seconds", quote.seconds}};
}

Json audit_json(const SceneAudit& audit)
{
    return {{"found", audit.found}, {"assumed", audit.assumed}, {"lost", audit.warnings}};
}

Json photons_json(const RenderStatistics& render, const RenderOptions& options)
{
    Json json = {{"emitted", render.emitted},
                 {"aimed", render.aimed},
                 {"indirect_by_paths", render.indirect_by == IndirectLight::paths},
                 {"guided_variance", render.guided_variance},
                 {"guided_variance_aimed", render.guided_variance_aimed},
                 {"stored", render.caustic.stored + render.global.stored},
                 {"in_media", render.volume_photons},
                 {"dropped", render.dropped_photons},
                 {"paths_cut", render.cut_paths},
                 {"caustic", kind_json(render.caustic, options.dissertation.mode)},
                 {"global", kind_json(render.global, options.dissertation.mode)}};
    if (render.indirect.stored > 0)
        json["indirect"] = kind_json(render.indirect, options.dissertation.mode);
    if (render.glossy.stored > 0)
        json["glossy"] = kind_json(render.glossy, options.dissertation.mode);
    return json;
}

/// Null if light paths were not counted.
Json unseen_json(const std::optional<UnseenLight>& unseen)
{
    if (!unseen)
        return {};
    return {{"passes", unseen->passes},
            {"paths", unseen->paths},
            {"classes_once", unseen->classes_once},
            {"lights_never", unseen->lights_never},
            {"share", unseen->share},
            {"most", unseen->most}}; // null if infinite
}

Json lost_json(const LostLight& lost)
{
    return {{"photons", lost.photons}, {"samples", std::sqrt(lost.samples2)}};
}

Json missing_json(const std::vector<FilmPart>& missing)
{
    Json out = Json::array();
    for (const FilmPart& part : missing) {
        const PixelRect& pixels = part.pixels;
        Json passes = Json::array();
        for (const PassRange& range : part.passes.ranges)
            passes.push_back({range.first, range.end});
        out.push_back(
            {{"pixels", {pixels.x0, pixels.y0, pixels.x1, pixels.y1}}, {"passes", passes}});
    }
    return out;
}

const char* ended_by(StopReason reason)
{
    static const char* const kNames[] = {"passes", "time", "error", "signal"};
    return kNames[static_cast<int>(reason)];
}

Json image_json(int width, int height, const std::vector<std::filesystem::path>& files,
                float exposure_ev)
{
    Json names = Json::array();
    for (const std::filesystem::path& file : files)
        names.push_back(file.string());
    return {{"width", width}, {"height", height}, {"exposure_ev", exposure_ev}, {"files", names}};
}

Json pictures_json(const WrittenFiles& written)
{
    Json out = Json::array();
    for (const LegendedPicture& picture : written.pictures)
        out.push_back(picture_json(picture));
    return out;
}

std::string text_of(const Json& json)
{
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace

std::string statistics_json(const PreparedFrame& frame, const RenderedFrame& rendered,
                            const WrittenFiles& written)
{
    const RenderArguments& arguments = frame.arguments;
    const Scene& scene = frame.loaded.scene;
    const RenderStatistics& render = rendered.statistics;
    const RenderState& state = rendered.state;
    Json json;
    json["command"] = arguments.command;
    json["version"] = HIPMAP_VERSION;
    json["scene"] = scene_json(arguments, scene);
    json["partition"] = {{"file", arguments.partition.string()},
                         {"shared_maps", frame.partition.all_map_count()}};
    json["audit"] = audit_json(frame.loaded.audit);
    json["image"] = image_json(state.film.width, state.film.height, arguments.files.images,
                               written.exposure_ev);
    json["pictures"] = pictures_json(written);
    json["options"] = settings_json(values_of(arguments));
    json["effects"] = effects_json(frame.effects);
    json["passes_done"] = count(state.film.passes);
    json["ended_by"] = ended_by(rendered.result.reason);
    json["error"] = error_json(state, rendered.fireflies, arguments.stops.error,
                               seconds_before_passes(rendered));
    if (rendered.quote)
        json["quote"] = quote_json(*rendered.quote);
    json["unseen_light"] = unseen_json(rendered.missed.unseen);
    json["lost_light"] = lost_json(rendered.missed.lost);
    json["saturated"] = state.film.saturated;
    json["seconds"] = seconds_json(frame, rendered, written);
    json["processor_seconds"] = processor_seconds_json(frame, rendered, written);
    if (rendered.result.costs.rounds > 0)
        json["rounds"] = rendered.result.costs.rounds;
    json["photons"] = photons_json(render, arguments.render);
    json["power_W"] = power_json(render.power, scene);
    json["dropped_samples"] = render.dropped_samples;
    json["warnings"] = written.warnings;
    return text_of(json);
}

std::string merged_statistics_json(const MergeArguments& arguments, const MergedFiles& merged,
                                   const std::vector<FilmPart>& missing,
                                   const ShownFireflies& fireflies, const WrittenFiles& written)
{
    const RenderState& state = merged.state;
    Json json;
    json["command"] = arguments.command;
    json["version"] = HIPMAP_VERSION;
    json["label"] = state.label;
    for (const std::filesystem::path& file : merged.files)
        json["states"].push_back(file.string());
    json["left_out"] = merged.left_out;
    json["missing"] = missing_json(missing);
    json["settings"] = settings_json(state.settings);
    json["image"] = image_json(state.film.width, state.film.height, arguments.files.images,
                               written.exposure_ev);
    json["pictures"] = pictures_json(written);
    json["passes_done"] = count(state.film.passes);
    json["error"] = error_json(state, fireflies, 0, 0);
    json["saturated"] = state.film.saturated;
    json["seconds"] = {{"passes", state.seconds}, {"write", written.writing.seconds}};
    json["warnings"] = written.warnings;
    return text_of(json);
}

} // namespace hipmap
