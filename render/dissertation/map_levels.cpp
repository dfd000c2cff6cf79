#include "render/dissertation/map_levels.h"

#include "common/partition/limiting_radius.h"
#include "render/dissertation/level_search.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace hipmap {

namespace {

/// One photon of so many is a sample, and no more than so many in all.
constexpr std::uint64_t kPhotonsPerSample = 64;
constexpr std::uint64_t kMostSamples = 1024;

/// What it costs to ask a level for its map and limiting radius, in nodes of a search;
/// bench/tiers measures it.
constexpr double kAskingLocal = 4;
constexpr double kAskingGroup = 2;

using LevelLimit = float (*)(const TriangleMesh&, const Partition&, FaceId, const glm::vec3&);

/// Where the photons of a face, or of a group, on one side lie.
struct Extent {
    std::size_t map = 0; ///< place of its shared map
    std::uint64_t photons = 0;
    std::uint64_t low = 0, high = 0; ///< slots
    double area = 0;                 ///< square scene units
    TreeNode node;
};

/// A level before it is known whether it pays.
struct LevelDraft {
    std::vector<std::uint32_t> key_of_face; ///< [F] face or group; kNone: no candidate
    std::vector<Extent> extents;            ///< [sides keys] by index_by_side
    LevelLimit limit;
    double asking; ///< nodes
};

void add_photons(const DissertationMaps& maps, LevelDraft& draft)
{
    // The photons of a face or group are in one map, so that no two threads meet.
    tbb::parallel_for(std::size_t{0}, maps.shared.maps.size(), [&](std::size_t m) {
        const PhotonMap& map = maps.shared.maps[m];
        for (std::uint64_t slot = 0; slot < map.tree.size; ++slot) {
            const std::uint32_t key = draft.key_of_face[map.faces[slot]];
            if (key == kNone)
                continue;
            Extent& extent = draft.extents[maps.index_by_side(key, map.side)];
            if (extent.photons++ == 0) {
                extent.map = m;
                extent.low = slot;
            }
            extent.high = slot;
        }
    });
}

LevelDraft draft_level(const DissertationMaps& maps, const TriangleMesh& mesh, LevelDraft draft,
                       std::size_t keys)
{
    draft.extents.resize(maps.sides() * keys);
    add_photons(maps, draft);
    for (FaceId face = 0; face < mesh.face_count(); ++face)
        if (const std::uint32_t key = draft.key_of_face[face]; key != kNone)
            for (std::uint8_t side = 0; side < maps.sides(); ++side)
                draft.extents[maps.index_by_side(key, side)].area += face_area(mesh, face);
    for (Extent& extent : draft.extents)
        if (extent.photons > 0 && extent.photons >= maps.options.local_min)
            extent.node = lowest_node(maps.shared.maps[extent.map].tree, extent.low, extent.high);
        else
            extent.photons = 0;
    return draft;
}

/// Searches for a sample of the photons and sees what the level would have done.
void count_searches(const DissertationMaps& maps, const TriangleMesh& mesh,
                    const Partition& partition, const LevelDraft& draft, LevelPlan& plan)
{
    const std::uint64_t step = std::max(kPhotonsPerSample, maps.shared.size / kMostSamples + 1);
    std::uint64_t samples = 0, asked = 0, answered = 0, spared = 0;
    TreeScratch wide;
    KdScratch kd;
    const auto try_photon = [&](const PhotonMap& map, std::uint32_t slot) {
        const FaceId face = map.faces[slot];
        const std::uint32_t key = draft.key_of_face[face];
        if (key == kNone)
            return;
        const std::uint32_t level = draft.extents[maps.index_by_side(key, map.side)].node.level;
        if (level == 0)
            return;
        ++asked;
        const glm::vec3 position = map.tree.position(slot);
        const PhotonQuery query{position, glm::vec3(0.0f), face, map.side};
        const FoundPhotons found =
            find_in_shared(maps, partition, {query, maps.shared.options.neighbours}, {wide, kd});
        const float limit = draft.limit(mesh, partition, face, position);
        if (!(found.farthest2 < limit * limit))
            return;
        ++answered;
        spared += level;
    };
    std::uint64_t first = 0; // slot of the next sample in its map
    for (const PhotonMap& map : maps.shared.maps) {
        for (; first < map.tree.size; first += step, ++samples)
            try_photon(map, static_cast<std::uint32_t>(first));
        first -= map.tree.size;
    }
    const auto all = static_cast<double>(std::max<std::uint64_t>(1, samples));
    plan.asked = static_cast<double>(asked) / all;
    plan.answered = static_cast<double>(answered) / all;
    plan.saving = static_cast<double>(spared) / all - plan.asking * plan.asked;
}

/// The maps of a level that is used.
LevelMaps make_level(const DissertationMaps& maps, const LevelDraft& draft, const LevelPlan& plan)
{
    LevelMaps level{plan, {}, {}};
    if (!plan.used)
        return level;
    std::vector<std::uint32_t> of_key(draft.extents.size(), kNone);
    std::vector<const Extent*> kept;
    for (std::size_t key = 0; key < draft.extents.size(); ++key)
        if (draft.extents[key].node.level > 0) {
            of_key[key] = static_cast<std::uint32_t>(kept.size());
            kept.push_back(&draft.extents[key]);
        }
    level.of_face.assign(maps.sides() * draft.key_of_face.size(), kNone);
    for (FaceId face = 0; face < draft.key_of_face.size(); ++face)
        if (const std::uint32_t key = draft.key_of_face[face]; key != kNone)
            for (std::uint8_t side = 0; side < maps.sides(); ++side)
                level.of_face[maps.index_by_side(face, side)] =
                    of_key[maps.index_by_side(key, side)];
    level.maps.resize(kept.size());
    tbb::parallel_for(std::size_t{0}, kept.size(), [&](std::size_t i) {
        const Extent& extent = *kept[i];
        level.maps[i] = {extent.node, filter_radius(extent.area, maps.shared.options.neighbours,
                                                    extent.photons)};
    });
    return level;
}

/// docs/photon_maps.md (8).
LevelMaps build_level(const DissertationMaps& maps, const TriangleMesh& mesh,
                      const Partition& partition, LevelDraft draft, std::size_t keys)
{
    LevelPlan plan{draft.asking};
    for (FaceId face = 0; face < mesh.face_count(); ++face)
        if (draft.key_of_face[face] != kNone)
            for (std::uint8_t side = 0; side < maps.sides(); ++side) {
                const PhotonMap* map = maps.shared.map_at(partition.map_of_face[face], side);
                plan.most = std::max(plan.most, map == nullptr ? 0.0 : map->tree.levels - 1.0);
            }
    const bool all = maps.options.levels == LevelChoice::all;
    plan.counted = all || plan.most > plan.asking;
    if (!plan.counted)
        return {plan, {}, {}};
    draft = draft_level(maps, mesh, std::move(draft), keys);
    for (const Extent& extent : draft.extents) {
        plan.candidates += extent.photons > 0 ? 1 : 0;
        plan.photons += extent.photons;
    }
    count_searches(maps, mesh, partition, draft, plan);
    plan.used = plan.saving > 0 || (all && plan.asked > 0);
    return make_level(maps, draft, plan);
}

} // namespace

void build_levels(DissertationMaps& maps, const MapSurfaces& surfaces)
{
    const TriangleMesh& mesh = surfaces.mesh;
    const Partition& partition = surfaces.partition;
    LevelDraft local{std::vector<std::uint32_t>(mesh.face_count(), kNone),
                     {},
                     exact_limiting_radius,
                     kAskingLocal};
    for (FaceId face = 0; face < mesh.face_count(); ++face)
        if (partition.candidate[face])
            local.key_of_face[face] = face;
    LevelDraft group{partition.group_of_face, {}, exact_group_radius, kAskingGroup};
    maps.local_level = build_level(maps, mesh, partition, std::move(local), mesh.face_count());
    maps.group_level = build_level(maps, mesh, partition, std::move(group), partition.group_count);
}

} // namespace hipmap
