// What photon maps cost to build and to search, by mode, tree and estimate: the images that `render
// --integrator direct --direct photons` makes of one set of photons, in one process and in turn, so
// that what else the machine does falls on all alike.

#include "bench/gathered_image.h"
#include "common/command_line/command_line.h"
#include "common/input_error.h"
#include "common/scene/load_scene.h"
#include "preprocess/partition/build_partition.h"
#include "render/dissertation_settings.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iostream>
#include <map>
#include <memory>
#include <numbers>
#include <numeric>
#include <random>

namespace hipmap {

namespace {

using Json = nlohmann::ordered_json;

struct Arguments {
    std::string scene;
    std::uint64_t paths = 100'000;
    std::uint64_t reference_paths = 0;
    std::uint32_t neighbours = 50;
    double angle_deg = 90; ///< the dissertation's
    int width = 256;
    int every = 1;
    int rounds = 5;
    std::vector<std::string> settings;
};

/// Reads "--maps NAME --tree NAME ... [--together]", by the names that `render` has.
MapSetting parse_setting(const std::string& text, std::uint32_t neighbours)
{
    MapSetting out;
    out.options.local_min = 10 * neighbours;
    CLI::App app;
    add_options(app, dissertation_rows(out.options));
    app.add_flag("--together", out.together);
    try {
        app.parse(text, false);
    } catch (const CLI::ParseError& error) {
        throw InputError("--setting \"" + text + "\": " + error.what());
    }
    return out;
}

/// The indices 0 to count - 1 in an order that depends on the seed.
std::vector<std::size_t> shuffled(std::size_t count, std::size_t seed)
{
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::shuffle(order.begin(), order.end(), std::minstd_rand(static_cast<unsigned>(seed + 1)));
    return order;
}

Json kind_json(KindStatistics kind, const ChosenScratch& scratch)
{
    kind.add_searches(scratch);
    const LevelSearches& local = kind.level_searches.local;
    return {{"stored", kind.stored},
            {"shared_maps", kind.shared_maps},
            {"local_maps", kind.levels.local_maps},
            {"group_maps", kind.levels.group_maps},
            {"queries", kind.searches.queries},
            {"local", {{"searches", local.begun}, {"searches_abandoned", local.abandoned}}}};
}

Json row_json(const GatheredImage& image, const GatheredImage& empty)
{
    return {{"build_s", image.build_s},
            {"image_s", image.image_s},
            {"empty_s", empty.image_s},
            {"kinds",
             {{"caustic", kind_json(image.caustic_kind, image.scratch.caustic)},
              {"global", kind_json(image.global_kind, image.scratch.global)}}}};
}

/// Builds the maps of some settings and renders by them, band by band in turn; with empty maps too.
/// Fills the rows of these settings.
void measure_together(const PhotonStudy& study, const std::vector<MapSetting>& settings,
                      const std::vector<std::size_t>& chosen, std::size_t round,
                      std::vector<Json>& rows)
{
    std::vector<std::unique_ptr<GatheredImage>> images(chosen.size());
    for (const std::size_t i : shuffled(chosen.size(), round))
        images[i] = std::make_unique<GatheredImage>(build_maps(study, settings[chosen[i]]));
    images.push_back(std::make_unique<GatheredImage>(without_photons(study)));
    for (int band = 0; band < study.bands(); band += study.every)
        for (const std::size_t i :
             shuffled(images.size(), 100 * round + static_cast<std::size_t>(band)))
            render_band(study, band, *images[i]);
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        rows[chosen[i]] = row_json(*images[i], *images.back());
        if (!study.reference.empty())
            rows[chosen[i]]["errors"] = relative_errors(study, *images[i]);
    }
}

/// Settings with the same tree share their turns, so that no more maps are kept than these need.
std::vector<std::vector<std::size_t>> by_tree(const std::vector<MapSetting>& settings)
{
    std::map<TreeKind, std::vector<std::size_t>> found;
    for (std::size_t i = 0; i < settings.size(); ++i)
        found[settings[i].options.tree].push_back(i);
    std::vector<std::vector<std::size_t>> out;
    for (auto& [tree, indices] : found)
        out.push_back(std::move(indices));
    return out;
}

/// Prints a line of JSON about the photons, and one for each round as soon as it is done.
void measure(const Arguments& arguments)
{
    SceneOptions as_gltf;
    as_gltf.look = LookChoice::gltf;
    const LoadedScene loaded = load_scene(arguments.scene, as_gltf);
    const double angle = arguments.angle_deg * std::numbers::pi / 180;
    const Partition partition = build_partition(loaded.scene, {.angle_threshold = angle}).partition;
    const RenderScene scene(loaded.scene, partition);
    std::vector<MapSetting> settings;
    for (const std::string& text : arguments.settings)
        settings.push_back(parse_setting(text, arguments.neighbours));
    PhotonStudy study(scene, {arguments.width, arguments.every, arguments.neighbours});
    if (arguments.reference_paths > 0)
        make_reference(study, arguments.reference_paths);
    study.trace(arguments.paths);
    if (std::ranges::any_of(settings, &MapSetting::together))
        study.join();
    std::cout << Json({{"emitted", study.traced.emitted},
                       {"aimed", study.traced.aimed},
                       {"share", study.share()}})
              << std::endl;
    build_maps(study, settings[0]); // the first build of a process takes longer
    const std::vector<std::vector<std::size_t>> groups = by_tree(settings);
    for (int round = 0; round < arguments.rounds; ++round) {
        std::vector<Json> rows(settings.size());
        const auto seed = static_cast<std::size_t>(round);
        for (const std::size_t group : shuffled(groups.size(), seed))
            measure_together(study, settings, groups[group], seed, rows);
        std::cout << Json(rows) << std::endl;
    }
}

void add_arguments(CLI::App& app, Arguments& into)
{
    app.add_option("SCENE", into.scene, "Scene: .glb, .gltf or .obj")->required();
    app.add_option("--photons", into.paths, "Light paths [100000]")
        ->check(CLI::Range(1, 100'000'000));
    app.add_option("--neighbours", into.neighbours, "k [50]")->check(CLI::Range(2, 10'000));
    app.add_option("--angle", into.angle_deg, "Angle threshold, degrees [90]")
        ->check(CLI::Range(0, 180));
    app.add_option("--size", into.width, "Pixels across the image [256]")
        ->check(CLI::Range(1, 65536));
    app.add_option("--every", into.every, "Render one band of eight rows of so many [1]")
        ->check(CLI::Range(1, 1000));
    app.add_option("--rounds", into.rounds, "Times to measure all settings [5]")
        ->check(CLI::Range(1, 1000));
    app.add_option("--reference", into.reference_paths,
                   "Light paths of a reference, to print errors against [none]")
        ->check(CLI::Range(1, 100'000'000));
    app.add_option("--setting", into.settings,
                   "Maps, by options of render and --together (caustic photons with the others): "
                   "\"--maps thesis --tree balanced\"")
        ->required()
        ->allow_extra_args(false);
}

} // namespace

} // namespace hipmap

int main(int argc, char** argv)
{
    return hipmap::run_tool([&] {
        CLI::App app(
            "What photon maps cost to build and to search: a line of JSON about the photons, "
            "and one for each round with a row for each setting.",
            "map_costs");
        hipmap::Arguments arguments;
        hipmap::add_arguments(app, arguments);
        if (const std::optional<int> code = hipmap::parse_arguments(app, argc, argv))
            return *code;
        hipmap::measure(arguments);
        return hipmap::kExitDone;
    });
}
