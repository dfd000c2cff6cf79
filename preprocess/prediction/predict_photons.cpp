#include "preprocess/prediction/predict_photons.h"

#include "common/scene/light_path_rules.h"
#include "preprocess/prediction/caustic_targets.h"
#include "preprocess/prediction/tree_rays.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <memory>

namespace hipmap {

namespace {

/// Embree's tree of more faces would take too much of the time and memory that the partition takes.
constexpr std::size_t kEmbreeFaces = 1 << 19;

/// Light paths traced: one for so many of the pass, within bounds, and an eighth of that where rays
/// go through the slower tree of a large mesh.
constexpr std::uint64_t kPathsPerTraced = 64;
constexpr std::uint64_t kFewestPaths = 1 << 15;
constexpr std::uint64_t kMostPaths = 1 << 20;
constexpr std::uint64_t kLessOfLarge = 8;

constexpr std::uint64_t kPathsPerChunk = 512;

/// Other paths than those of a render of a small seed.
constexpr std::uint64_t kSeed = std::uint64_t{1} << 63;

/// Traces paths in chunks that are joined in order.  start(point, random): a ray of a light.
template <typename Start>
std::vector<LeftPhoton> trace(const LightSpace& space, const MeanLights& sources,
                              std::uint64_t paths, PhotonKind kind, const Start& start)
{
    std::vector<std::vector<LeftPhoton>> chunks((paths + kPathsPerChunk - 1) / kPathsPerChunk);
    tbb::parallel_for(std::size_t{0}, chunks.size(), [&](std::size_t c) {
        const std::uint64_t end = std::min(paths, (c + 1) * kPathsPerChunk);
        for (std::uint64_t i = c * kPathsPerChunk; i < end; ++i) {
            RandomSequence random(kSeed, RandomStream::photons, 0, static_cast<std::uint64_t>(kind),
                                  i);
            const double place = (static_cast<double>(i) + 0.5) / static_cast<double>(paths);
            const LightPoint point = draw_light_point(sources, place, random);
            follow_light(space, start(point, random), kind, random, chunks[c]);
        }
    });
    std::vector<LeftPhoton> out;
    for (const std::vector<LeftPhoton>& chunk : chunks)
        out.insert(out.end(), chunk.begin(), chunk.end());
    return out;
}

/// Returns whether a sphere holds the start of light, so that all of it is aimed there.
bool is_enclosed(const LightPoint& point, const std::vector<BoundingSphere>& targets)
{
    return !point.far &&
           std::any_of(targets.begin(), targets.end(), [&](const BoundingSphere& target) {
               return glm::distance(point.position, target.centre) <= target.radius;
           });
}

/// Counts equal photons.  each: what one of them stands for.
void add_counts(std::vector<LeftPhoton> photons, double each, PredictedPhotons& out)
{
    tbb::parallel_sort(photons);
    for (const LeftPhoton& photon : photons) {
        if (out.places.empty() || out.places.back().place != photon)
            out.places.push_back({photon, 0});
        out.places.back().photons += each;
    }
}

/// Counts the photons of caustics: of enclosed lights all paths leave them, of others the aimed
/// ones.
void add_caustics(const LightSpace& space, const MeanLights& sources, std::uint64_t paths,
                  double each, PredictedPhotons& out)
{
    const std::vector<BoundingSphere> targets = find_caustic_targets(space.mesh, space.materials);
    if (targets.empty())
        return;
    add_counts(trace(space, sources, paths, PhotonKind::caustic,
                     [&](const LightPoint& point, RandomSequence& random) {
                         return is_enclosed(point, targets) ? draw_start(sources, point, random)
                                                            : LightStart{};
                     }),
               each, out);
    add_counts(trace(space, sources, paths / kPathsPerCausticPath, PhotonKind::caustic,
                     [&](const LightPoint& point, RandomSequence& random) {
                         return is_enclosed(point, targets)
                                    ? LightStart{}
                                    : draw_aimed_start(sources, point, targets, random);
                     }),
               each, out);
}

} // namespace

PredictedPhotons predict_photons(const Scene& scene, const Partition& partition,
                                 const FaceTree& tree, std::uint64_t photons)
{
    const TriangleMesh& mesh = scene.mesh;
    const std::vector<MeanMaterial> materials = mean_materials(scene);
    const MeanLights sources = collect_mean_lights(scene, materials);
    PredictedPhotons out;
    out.is_lit = !sources.lights.empty();
    if (!out.is_lit || photons == 0)
        return out;
    std::unique_ptr<EmbreeScene> rays;
    LightSpace space{mesh, partition, materials,
                     [&](const Ray& ray) { return nearest_in_tree(mesh, tree, ray); }};
    const bool by_tree =
        tree.root().end > 0 && mesh.copies.empty() && mesh.face_count() > kEmbreeFaces;
    if (!by_tree) {
        rays = std::make_unique<EmbreeScene>(mesh);
        space.nearest = [&](const Ray& ray) { return rays->nearest(ray); };
    }
    const std::uint64_t paths = std::clamp(photons / kPathsPerTraced, kFewestPaths, kMostPaths) /
                                (by_tree ? kLessOfLarge : 1);
    const double each = static_cast<double>(photons) / static_cast<double>(paths);
    out.each = each;
    add_counts(trace(space, sources, paths, PhotonKind::indirect,
                     [&](const LightPoint& point, RandomSequence& random) {
                         return draw_start(sources, point, random);
                     }),
               each, out);
    add_caustics(space, sources, paths, each, out);
    std::ranges::sort(out.places, {}, &PredictedPhotons::At::place);
    return out;
}

} // namespace hipmap
