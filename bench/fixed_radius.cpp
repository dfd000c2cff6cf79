#include "bench/fixed_radius.h"

#include "bench/hash_grid.h"
#include "render/maps/wide_batch.h"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <limits>

namespace hipmap {

namespace {

constexpr std::size_t kWanted = 100;
constexpr int kRepeats = 7;

struct Maps {
    WideTree tree;
    PhotonPowers powers;
    PowerScale scale;
    float radius = 0.0f; ///< half of the queries have more than kWanted photons within
    HashGrid grid;
};

Maps build(const std::vector<RoomPoint>& photons, const std::vector<RoomPoint>& queries)
{
    std::vector<Photon> powered;
    std::vector<HashGrid::Item> items;
    std::vector<TreePoint> points;
    for (std::uint32_t i = 0; i < photons.size(); ++i) {
        const glm::vec3 power(1.0f + float(i) / float(photons.size()));
        powered.push_back({photons[i].position, power, {0, 1, 0}, 0, 0});
        items.push_back({photons[i].position, power});
        points.push_back({photons[i].position, i});
    }
    WideTree tree = build_wide_tree(points);
    const PowerScale scale = power_scale(powered);
    PhotonPowers powers = build_powers(tree, points, powered, scale);
    TreeScratch scratch;
    std::vector<float> radii;
    for (const RoomPoint& query : queries)
        radii.push_back(
            std::sqrt(find_nearest(tree, {query.position, kWanted}, scratch).farthest2));
    std::nth_element(radii.begin(), radii.begin() + std::ptrdiff_t(radii.size() / 2), radii.end());
    const float radius = radii[radii.size() / 2];
    return {std::move(tree), std::move(powers), scale, radius, HashGrid(items, radius)};
}

/// The least of some runs; others only ever slow one down.
template <typename Act>
double nanoseconds(const std::vector<RoomPoint>& queries, const Act& act)
{
    double best = std::numeric_limits<double>::infinity();
    for (int i = 0; i < kRepeats; ++i) {
        const std::clock_t start = std::clock();
        for (const RoomPoint& query : queries)
            act(query.position);
        best = std::min(best, double(std::clock() - start) / CLOCKS_PER_SEC);
    }
    return 1e9 * best / double(queries.size());
}

/// Powers were rounded to 16 bits of the largest.
bool agree(const HashGrid::Sum& grid, const RadiusSum& tree, const PowerScale& scale)
{
    const glm::dvec3 power = scale.unit * glm::dvec3(tree.power);
    return grid.photons == tree.photons &&
           glm::all(glm::lessThanEqual(glm::abs(power - grid.power), 1e-4 * grid.power));
}

/// Prints what batches of some sizes cost, beside `single` ns of a search alone, sorting included;
/// returns how many sums differ from those of searches alone.
std::size_t measure_batches(const Maps& maps, const std::vector<RoomPoint>& picture, double single)
{
    std::vector<glm::vec3> points;
    for (const RoomPoint& query : picture)
        points.push_back(query.position);
    const float r2 = maps.radius * maps.radius;
    std::vector<RadiusSum> sums(points.size());
    BatchScratch scratch;
    std::size_t wrong = 0;
    for (const std::size_t size : {points.size(), points.size() / 12, points.size() / 96}) {
        double best = std::numeric_limits<double>::infinity();
        for (int i = 0; i < kRepeats; ++i) {
            const std::clock_t start = std::clock();
            for (std::size_t begin = 0; begin < points.size(); begin += size) {
                const std::size_t count = std::min(size, points.size() - begin);
                sum_within({maps.tree, maps.powers}, std::span(points).subspan(begin, count), r2,
                           std::span(sums).subspan(begin, count), scratch);
            }
            best = std::min(best, double(std::clock() - start) / CLOCKS_PER_SEC);
        }
        const double ns = 1e9 * best / double(points.size());
        std::printf("in batches of %zu searches %.0f ns (%.2f times faster than one by one)\n",
                    size, ns, single / ns);
        for (std::size_t i = 0; i < points.size(); i += 97) {
            const RadiusSum alone = sum_within(maps.tree, maps.powers, points[i],
                                               std::array<float, 1>{r2}, scratch.single)[0];
            wrong += sums[i].power == alone.power && sums[i].photons == alone.photons ? 0 : 1;
        }
    }
    return wrong;
}

} // namespace

bool measure_fixed_radius(const std::vector<RoomPoint>& photons,
                          const std::vector<RoomPoint>& queries,
                          const std::vector<RoomPoint>& picture)
{
    const Maps maps = build(photons, queries);
    const float r2 = maps.radius * maps.radius;
    const std::array<float, 3> radii2{r2, 0.75f * r2, 0.5f * r2};
    TreeScratch scratch;
    const auto one = [&](const glm::vec3& at) {
        return sum_within(maps.tree, maps.powers, at, std::array<float, 1>{r2}, scratch)[0];
    };
    std::uint64_t found = 0, wrong = 0;
    for (const RoomPoint& query : queries) {
        const HashGrid::Sum sum = maps.grid.within(query.position);
        found += sum.photons;
        wrong += agree(sum, one(query.position), maps.scale) ? 0 : 1;
    }
    std::uint64_t sum = 0; // so that nothing is left out
    const double grid =
        nanoseconds(queries, [&](const glm::vec3& at) { sum += maps.grid.within(at).photons; });
    const double tree = nanoseconds(queries, [&](const glm::vec3& at) { sum += one(at).photons; });
    const double three = nanoseconds(queries, [&](const glm::vec3& at) {
        sum += sum_within(maps.tree, maps.powers, at, radii2, scratch)[2].photons;
    });
    std::printf(
        "\n%zu photons, fixed radius, random order, %.0f photons on average: hash grid %.0f "
        "ns, wide %.0f (%.1f times faster), wide at three radii %.0f (%.1f); %zu differ%s\n",
        photons.size(), double(found) / double(queries.size()), grid, tree, grid / tree, three,
        grid / three, std::size_t(wrong), sum == 0 ? "!" : "");
    return measure_batches(maps, picture, tree) + wrong == 0;
}

} // namespace hipmap
