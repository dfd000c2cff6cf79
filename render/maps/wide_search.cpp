#include "render/maps/wide_search.h"

#include "render/maps/wide_kernels.h"

#include <hwy/targets.h>

#include <string_view>

namespace hipmap {

namespace tree_search {

namespace {

/// The step, relative to the last radius, after which the last search bounds the next one badly.
constexpr float kNear = 0.5f;

/// The k-th photon is looked for within so many mean changes of the radius; the mean forgets at
/// this rate.
constexpr float kDrifts = 5.0f;
constexpr float kDriftShare = 0.1f;

/// More than the roundings of a few operations take away.
constexpr float kRoundedUp = 1.00001f;

} // namespace

float kth_of_collected(std::size_t k, const Bounds2& bounds, std::size_t inside,
                       TreeScratch& scratch)
{
    return inside > k ? kth_distance2(k, bounds, inside, scratch)
                      : greatest_distance2(bounds.high2, scratch);
}

std::span<std::uint32_t> ties_in_order(const TreeQuery& query, std::size_t count,
                                       TreeScratch& scratch)
{
    const auto ties = std::span(scratch.ties).first(count);
    if (query.order != nullptr)
        std::sort(ties.begin(), ties.end(), [&](std::uint32_t a, std::uint32_t b) {
            return query.order[a] < query.order[b];
        });
    return ties;
}

void remember(const WideTree& tree, const TreeQuery& query, std::size_t found, float farthest2,
              TreeScratch& scratch)
{
    const float radius =
        found == query.photons ? std::sqrt(farthest2) : std::numeric_limits<float>::infinity();
    const float step = glm::distance(query.point, scratch.last_point);
    const float change = std::abs(radius - scratch.last_radius);
    if (scratch.last_tree == tree.number && step > 0 && change <= step)
        scratch.drift += kDriftShare * (change / step - scratch.drift);
    scratch.last_tree = tree.number;
    scratch.last_point = query.point;
    scratch.last_missed = false;
    scratch.last_radius = radius;
}

float limit2(const WideTree& tree, const TreeQuery& query)
{
    // Rounding is monotonic, so no photon of the tree is farther than the farthest corner.
    const glm::vec3 d = glm::max(query.point - tree.low, tree.high - query.point);
    return std::min(query.radius2, glm::dot(d, d));
}

Bounds2 bounds2(const WideTree& tree, const TreeQuery& query, float most2, TreeScratch& scratch)
{
    if (most_photons(tree, query) <= query.photons)
        return {0.0f, most2, most2};
    const float step = glm::distance(query.point, scratch.last_point), last = scratch.last_radius;
    if (scratch.last_tree == tree.number && step < kNear * last) {
        // The k-th is no more than a step farther or nearer than it was; mostly much less.
        const float likely = step * std::min(1.0f, kDrifts * scratch.drift);
        const float low = std::isfinite(last) && !scratch.last_missed ? last - likely : 0.0f;
        const float high = last + likely, surely = last + step;
        return {low * low / kRoundedUp, std::min(most2, high * high * kRoundedUp),
                std::min(most2, surely * surely * kRoundedUp)};
    }
    const std::size_t near = collect_near(tree, query, scratch);
    const float far2 = greatest_distance2(std::numeric_limits<float>::max(), scratch);
    const float kth2 = kth_of_collected(query.photons, {0.0f, far2, far2}, near, scratch);
    return {0.0f, std::min(most2, kth2), std::min(most2, kth2)};
}

Bounds2 wider(const TreeQuery& query, const Bounds2& bounds, std::size_t inside, float most2)
{
    if (bounds.high2 < bounds.surely2)
        return {bounds.low2, bounds.surely2, bounds.surely2};
    const float missing = static_cast<float>(query.photons) / static_cast<float>(inside + 1);
    const float wider2 = bounds.high2 * std::clamp(1.3f * missing, 1.5f, 4.0f);
    const float next2 = wider2 > bounds.high2 && wider2 < most2 ? wider2 : most2;
    return {bounds.low2, next2, next2};
}

FoundSlots select(const WideTree& tree, const TreeQuery& query, const Bounds2& bounds,
                  std::size_t inside, TreeScratch& scratch)
{
    FoundSlots found;
    if (inside > 0) {
        found.farthest2 = kth_of_collected(query.photons, bounds, inside, scratch);
        const Emitted emitted = emit_nearest(found.farthest2, scratch);
        const auto ties = ties_in_order(query, emitted.as_far, scratch);
        const std::size_t count = std::min(emitted.nearer + ties.size(), query.photons);
        for (std::size_t i = emitted.nearer; i < count; ++i)
            scratch.found[i] = ties[i - emitted.nearer];
        found.slots = {scratch.found.data(), count};
    }
    remember(tree, query, found.slots.size(), found.farthest2, scratch);
    return found;
}

} // namespace tree_search

std::vector<const char*> simd_targets()
{
    hwy::SetSupportedTargetsForTest(0);
    std::vector<const char*> names;
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets())
        names.push_back(hwy::TargetName(target));
    return names;
}

bool use_simd_target(const char* name)
{
    hwy::SetSupportedTargetsForTest(0);
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets())
        if (std::string_view(name) == hwy::TargetName(target)) {
            hwy::GetChosenTarget().Update(target);
            return true;
        }
    return false;
}

} // namespace hipmap
