// How well rules predict the radius of a search in a local map of mode thesis, and what searches
// cost by each rule: which begin in vain, which could have ended there but were not begun.

#include "common/command_line/command_line.h"
#include "common/command_line/picture_size.h"
#include "common/file/output_file.h"
#include "common/rays/camera_ray.h"
#include "common/scene/load_scene.h"
#include "preprocess/partition/build_partition.h"
#include "render/dissertation/level_search.h"
#include "render/photons/trace_photons.h"
#include "render/shading/interaction.h"

#include <cmath>
#include <cstdio>
#include <ctime>
#include <numbers>
#include <sstream>

namespace hipmap {

namespace {

constexpr int kRuns = 9;
constexpr float kNever = std::numeric_limits<float>::infinity();

struct Arguments {
    std::string scene, csv;
    std::uint64_t paths = 500'000;
    std::uint32_t neighbours = 50;
    double angle_deg = 90; ///< the dissertation's
    int width = 256;
};

/// A search on a face that has a local map.
struct LocalQuery {
    PhotonQuery query;
    const LocalMap* local;
    float limit;  ///< docs/photon_maps.md (6)
    float radius; ///< of the k-th photon
};

/// A rule and the radius that it predicts for each search.
struct Rule {
    std::string name;
    std::vector<float> radius;
};

/// What is looked at by the pixels, row by row, where it has a local map.
std::vector<LocalQuery> make_queries(const RenderScene& scene, const DissertationMaps& maps,
                                     int width)
{
    const Camera& camera = scene.scene.cameras[scene.scene.camera];
    const int height = complete_size({width, 0}, camera.aspect).height;
    const float aspect = static_cast<float>(width) / static_cast<float>(height);
    std::vector<LocalQuery> queries;
    TreeScratch wide;
    KdScratch kd;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const glm::vec2 picture = (glm::vec2(x, y) + 0.5f) / glm::vec2(width, height);
            const Ray ray = camera_ray(camera, picture, aspect);
            const std::optional<RayHit> hit = scene.rays.nearest(ray);
            if (!hit)
                continue;
            const Interaction at = interact(scene, ray, *hit);
            const std::uint32_t index = maps.locals.of_face[maps.index_by_side(hit->face, at.side)];
            if (index == kNone)
                continue;
            const PhotonQuery query{at.point.position, at.normal, hit->face, at.side};
            const FoundPhotons found = find_in_shared(
                maps, scene.partition, {query, maps.shared.options.neighbours}, {wide, kd});
            queries.push_back(
                {query, &maps.locals.maps[index],
                 limiting_radius(scene.mesh(), scene.partition, hit->face, query.position),
                 std::sqrt(found.farthest2)});
        }
    return queries;
}

std::vector<Rule> make_rules(const std::vector<LocalQuery>& queries)
{
    const auto rule = [&](const std::string& name, const auto& predict) {
        Rule out{name, {}};
        for (std::size_t i = 0; i < queries.size(); ++i)
            out.radius.push_back(predict(i));
        return out;
    };
    const auto even = [&](float factor) {
        return [&, factor](std::size_t i) { return factor * queries[i].local->filter_radius; };
    };
    const auto last = [&](std::size_t i) {
        if (i == 0 || queries[i - 1].local != queries[i].local)
            return queries[i].local->filter_radius;
        return queries[i - 1].radius +
               glm::distance(queries[i - 1].query.position, queries[i].query.position);
    };
    return {rule("shared map alone", [](std::size_t) { return kNever; }),
            rule("r' of the dissertation", even(1)),
            rule("0.8 r'", even(0.8f)),
            rule("1.25 r'", even(1.25f)),
            rule("begin always", [](std::size_t) { return 0.0f; }),
            rule("the last search's, and the step", last),
            rule("the right one", [&](std::size_t i) { return queries[i].radius; })};
}

/// Searches once by a rule.
void search_all(const RenderScene& scene, const DissertationMaps& maps,
                const std::vector<LocalQuery>& queries, const Rule& rule)
{
    TreeScratch local, shared;
    KdScratch kd;
    const std::uint32_t k = maps.shared.options.neighbours;
    const bool kd_trees = !maps.kd_trees.empty();
    for (std::size_t i = 0; i < queries.size(); ++i) {
        const LocalQuery& at = queries[i];
        if (rule.radius[i] <= at.limit) {
            const float below = std::nextafter(at.limit * at.limit, 0.0f);
            const TreeQuery wanted{at.query.position, k, below};
            const KdTree* const tree = kd_trees ? &at.local->kd_tree : nullptr;
            if (find_in_map(tree, at.local->tree, wanted, {local, kd}).slots.size() == k)
                continue;
        }
        find_in_shared(maps, scene.partition, {at.query, k}, {shared, kd});
    }
}

/// Processor time of a search by each rule, ns, the least of some runs; in turn, so that what else
/// the machine does falls on all alike.
std::vector<double> measure(const RenderScene& scene, const DissertationMaps& maps,
                            const std::vector<LocalQuery>& queries, const std::vector<Rule>& rules)
{
    std::vector<double> best(rules.size(), std::numeric_limits<double>::infinity());
    for (int run = 0; run < kRuns; ++run)
        for (std::size_t i = 0; i < rules.size(); ++i) {
            const std::clock_t start = std::clock();
            search_all(scene, maps, queries, rules[i]);
            const double seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
            best[i] =
                std::min(best[i], 1e9 * seconds / double(std::max<std::size_t>(1, queries.size())));
        }
    return best;
}

/// A line of the table for each rule, without its times.
std::vector<std::string> describe(const std::vector<LocalQuery>& queries,
                                  const std::vector<Rule>& rules)
{
    std::vector<std::string> lines;
    for (const Rule& rule : rules) {
        std::size_t answered = 0, vain = 0, missed = 0;
        for (std::size_t i = 0; i < queries.size(); ++i) {
            const bool begun = rule.radius[i] <= queries[i].limit;
            const bool ends = queries[i].radius < queries[i].limit;
            answered += begun && ends;
            vain += begun && !ends;
            missed += !begun && ends;
        }
        std::ostringstream line;
        line << rule.name;
        for (const std::size_t count : {answered, vain, missed})
            line << ';' << double(count) / double(std::max<std::size_t>(1, queries.size()));
        lines.push_back(line.str());
    }
    return lines;
}

std::string compare_rules(const Arguments& arguments)
{
    SceneOptions as_gltf;
    as_gltf.look = LookChoice::gltf; // as in docs/experiments.md
    const LoadedScene loaded = load_scene(arguments.scene, as_gltf);
    const double angle = arguments.angle_deg * std::numbers::pi / 180;
    const Partition partition = build_partition(loaded.scene, {.angle_threshold = angle}).partition;
    const RenderScene scene(loaded.scene, partition);
    const MapSurfaces surfaces(loaded.scene.mesh, partition);
    const TracedPhotons traced =
        trace_photons(scene, {.paths = arguments.paths, .store_direct = true, .caustic_paths = 0});
    std::vector<std::string> lines;
    std::string header = "rule;answered;in vain;missed";
    for (const TreeKind kind : {TreeKind::balanced, TreeKind::wide}) {
        const std::uint32_t k = arguments.neighbours;
        const DissertationOptions options{MapMode::thesis, 10 * k, EstimateForm::thesis, kind};
        const DissertationMaps maps =
            build_dissertation_maps(traced.global, surfaces, {k}, options);
        const std::vector<LocalQuery> queries = make_queries(scene, maps, arguments.width);
        const std::vector<Rule> rules = make_rules(queries);
        if (lines.empty())
            lines = describe(queries, rules);
        header += kind == TreeKind::wide ? ";ns wide" : ";ns balanced";
        const std::vector<double> ns = measure(scene, maps, queries, rules);
        for (std::size_t i = 0; i < rules.size(); ++i)
            lines[i] += ';' + std::to_string(std::lround(ns[i]));
    }
    for (const std::string& line : lines)
        header += '\n' + line;
    return header + '\n';
}

} // namespace

} // namespace hipmap

int main(int argc, char** argv)
{
    return hipmap::run_tool([&] {
        CLI::App app("Rules that predict whether a search ends in a local map of mode thesis: the "
                     "shares of searches answered there, begun in vain and missed, and ns a search "
                     "by tree.",
                     "filter_radius");
        hipmap::Arguments arguments;
        app.add_option("SCENE", arguments.scene, "Scene: .glb, .gltf or .obj")->required();
        app.add_option("--photons", arguments.paths, "Light paths [500000]")
            ->check(CLI::Range(1000, 100'000'000));
        app.add_option("--neighbours", arguments.neighbours, "k [50]")
            ->check(CLI::Range(2, 10'000));
        app.add_option("--angle", arguments.angle_deg, "Angle threshold, degrees [90]")
            ->check(CLI::Range(0, 180));
        app.add_option("--size", arguments.width, "Pixels across the picture [256]")
            ->check(CLI::Range(1, 65536));
        app.add_option("--csv", arguments.csv, "Write the table, separated by ;")
            ->type_name("FILE");
        if (const std::optional<int> code = hipmap::parse_arguments(app, argc, argv))
            return *code;
        if (!arguments.csv.empty())
            hipmap::check_writable(arguments.csv);
        const std::string table = hipmap::compare_rules(arguments);
        std::printf("%s", table.c_str());
        if (!arguments.csv.empty())
            hipmap::write_file(arguments.csv, table);
        return hipmap::kExitDone;
    });
}
