#include "common/command_line/command_line.h"
#include "common/math/random.h"
#include "common/partition/limiting_radius.h"
#include "preprocess/partition/build_partition.h"
#include "render/dissertation/level_search.h"

#include <algorithm>
#include <cstdio>
#include <ctime>

namespace hipmap {

namespace {

struct Floor {
    Scene scene;
    Partition partition;
    std::uint32_t cells;

    FaceId face_at(const glm::vec2& at) const
    {
        const glm::vec2 cell = glm::min(glm::floor(at * float(cells)), float(cells - 1));
        const glm::vec2 inside = at * float(cells) - cell;
        const auto square = static_cast<FaceId>(cell.y) * cells + static_cast<FaceId>(cell.x);
        return 2 * square + (inside.y <= inside.x ? 0 : 1);
    }
};

Floor make_floor(std::uint32_t cells)
{
    Floor floor{{}, {}, cells};
    TriangleMesh& mesh = floor.scene.mesh;
    for (std::uint32_t j = 0; j <= cells; ++j)
        for (std::uint32_t i = 0; i <= cells; ++i) {
            mesh.positions.emplace_back(glm::vec2(i, j) / float(cells), 0);
            if (i == cells || j == cells)
                continue;
            const std::uint32_t a = j * (cells + 1) + i;
            mesh.corners.emplace_back(a, a + 1, a + cells + 2);
            mesh.corners.emplace_back(a, a + cells + 2, a + cells + 1);
        }
    mesh.normals.assign(mesh.positions.size(), glm::vec3(0.0f));
    mesh.material_of_face.assign(mesh.face_count(), 0);
    mesh.object_of_face.assign(mesh.face_count(), 0);
    floor.partition = build_partition(floor.scene, {}).partition;
    return floor;
}

std::vector<Photon> make_photons(const Floor& floor, std::size_t count)
{
    std::vector<Photon> photons;
    for (std::size_t i = 0; i < count; ++i) {
        RandomSequence random(1, RandomStream::photons, 0, i);
        const glm::vec2 at = random.next2();
        photons.push_back({{at, 0}, Rgb(1), {0, 0, 1}, floor.face_at(at), 0});
    }
    return photons;
}

/// Line by line, as an image asks.
std::vector<PhotonQuery> make_queries(const Floor& floor)
{
    constexpr int kSide = 512;
    std::vector<PhotonQuery> queries;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            const glm::vec2 at = (glm::vec2(x, y) + 0.5f) / float(kSide);
            queries.push_back({{at, 0}, {0, 0, 1}, floor.face_at(at), 0});
        }
    return queries;
}

constexpr int kRuns = 9;

/// Lowers `best`, ns a query, if this run is faster: others only ever slow it down.
template <typename Act>
void time_run(const std::vector<PhotonQuery>& queries, const Act& act, double& best)
{
    const std::clock_t start = std::clock();
    for (const PhotonQuery& query : queries)
        act(query);
    const double seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
    best = std::min(best, 1e9 * seconds / static_cast<double>(queries.size()));
}

/// Lowers `best` by a run of limiting radii; returns their sum, so that none is left out.
template <typename Limit>
float time_limits(const Floor& floor, const std::vector<PhotonQuery>& queries, Limit limit,
                  double& best)
{
    float sum = 0;
    const auto add = [&](const PhotonQuery& query) {
        sum += limit(floor.scene.mesh, floor.partition, query.face, query.position);
    };
    time_run(queries, add, best);
    return sum;
}

void print_level(const char* name, const LevelMaps& level, const LevelSearches& searches)
{
    std::printf("  %s: %zu maps; asked %.3f, answered %.3f, saving %.2f nodes; %llu begun, %llu "
                "abandoned\n",
                name, level.maps.size(), level.plan.asked, level.plan.answered, level.plan.saving,
                static_cast<unsigned long long>(searches.begun),
                static_cast<unsigned long long>(searches.abandoned));
}

void measure(std::uint32_t cells, std::size_t photon_count, std::uint32_t k)
{
    const Floor floor = make_floor(cells);
    const std::vector<Photon> photons = make_photons(floor, photon_count);
    const std::vector<PhotonQuery> queries = make_queries(floor);
    const MapSurfaces surfaces(floor.scene.mesh, floor.partition);
    DissertationOptions options{MapMode::shared, 10 * k};
    const auto build = [&] { return build_dissertation_maps(photons, surfaces, {k}, options); };
    const DissertationMaps shared = build();
    options.mode = MapMode::hierarchical;
    const DissertationMaps paying = build();
    options.levels = LevelChoice::all;
    const DissertationMaps all = build();

    SearchScratch scratch[3];
    DissertationScratch below[3];
    const DissertationMaps* const maps[] = {&shared, &paying, &all};
    double ns[3] = {1e30, 1e30, 1e30}, local = 1e30, group = 1e30;
    float sum = 0;
    for (int run = 0; run < kRuns; ++run) {
        for (int i = 0; i < 3; ++i) {
            const auto find = [&](const PhotonQuery& query) {
                find_photons(*maps[i], surfaces, query, {scratch[i], below[i]});
            };
            time_run(queries, find, ns[i]);
        }
        sum += time_limits(floor, queries, exact_limiting_radius, local);
        sum += time_limits(floor, queries, exact_group_radius, group);
    }
    std::printf("%zu faces, %zu photons, k = %u, %u levels: shared %.1f ns, paying %.1f (%.3f), "
                "all %.1f (%.3f); limiting radius: local %.1f, group %.1f ns%s\n",
                floor.scene.mesh.face_count(), photon_count, k, shared.shared.maps[0].tree.levels,
                ns[0], ns[1], ns[0] / ns[1], ns[2], ns[0] / ns[2], local, group,
                sum < 0 ? "!" : "");
    print_level("local", all.local_level, below[2].levels.local);
    print_level("group", all.group_level, below[2].levels.group);
}

} // namespace

} // namespace hipmap

int main(int argc, char** argv)
{
    return hipmap::run_tool([&] {
        CLI::App app("Searches with local and group maps beside those of the shared map alone, on "
                     "evenly lit floors of 8 to 32,768 faces.",
                     "tiers");
        std::vector<std::size_t> photons{100'000, 1'000'000};
        std::vector<std::uint32_t> neighbours{50};
        app.add_option("PHOTONS", photons, "Photons [100000 1000000]")
            ->check(CLI::Range(1000, 100'000'000));
        app.add_option("--neighbours", neighbours, "k [50]")->check(CLI::Range(2, 10'000));
        if (const std::optional<int> code = hipmap::parse_arguments(app, argc, argv))
            return *code;
        for (const std::size_t count : photons)
            for (const std::uint32_t k : neighbours)
                for (const std::uint32_t cells : {2, 4, 16, 128})
                    hipmap::measure(cells, count, k);
        return hipmap::kExitDone;
    });
}
