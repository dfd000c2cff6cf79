#include "render/lights/light_tree.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <span>

namespace hipmap {

namespace {

constexpr int kBins = 12;
constexpr double kBelowOne = 0x1.fffffffffffffp-1;

/// A way to divide lights in two: those of the bins up to `last` along an axis, and the others.
struct Split {
    int axis = 0;
    int last = 0;
    double cost = std::numeric_limits<double>::infinity();
};

glm::vec3 middle_of(const LightBounds& light)
{
    return light.box.centre();
}

class TreeBuilder {
  public:
    explicit TreeBuilder(const std::vector<LightBounds>& lights) : lights_(lights)
    {
        std::vector<std::uint32_t> all(lights.size());
        std::iota(all.begin(), all.end(), 0u);
        tree_.leaf_of.resize(lights.size());
        tree_.nodes.reserve(2 * lights.size());
        if (!all.empty())
            build(all, 0);
    }

    LightTree take() { return std::move(tree_); }

  private:
    void build(std::span<std::uint32_t> lights, std::uint32_t parent)
    {
        const auto here = static_cast<std::uint32_t>(tree_.nodes.size());
        tree_.nodes.push_back({});
        tree_.nodes[here].parent = parent;
        if (lights.size() == 1) {
            tree_.nodes[here].bounds = lights_[lights[0]];
            tree_.nodes[here].light = lights[0];
            tree_.nodes[here].end = here + 1;
            tree_.leaf_of[lights[0]] = here;
            return;
        }
        const std::size_t first = divide(lights);
        build(lights.first(first), here);
        const auto second = static_cast<std::uint32_t>(tree_.nodes.size());
        build(lights.subspan(first), here);
        tree_.nodes[here].second = second;
        tree_.nodes[here].end = static_cast<std::uint32_t>(tree_.nodes.size());
        tree_.nodes[here].bounds =
            together(tree_.nodes[here + 1].bounds, tree_.nodes[second].bounds);
    }

    int bin_of(std::uint32_t light, int axis, const Bounds<glm::vec3>& middles) const
    {
        const float along = (middle_of(lights_[light])[axis] - middles.low[axis]) /
                            (middles.high[axis] - middles.low[axis]);
        return std::clamp(static_cast<int>(along * kBins), 0, kBins - 1);
    }

    /// Brings those of the first child to the front; returns how many they are.
    std::size_t divide(std::span<std::uint32_t> lights) const
    {
        Bounds<glm::vec3> middles;
        for (const std::uint32_t light : lights)
            middles.add(middle_of(lights_[light]));
        const float longest =
            std::max({middles.extent().x, middles.extent().y, middles.extent().z});
        Split best;
        for (int axis = 0; axis < 3; ++axis)
            if (middles.extent()[axis] > 0)
                try_axis(lights, axis, middles, longest / middles.extent()[axis], best);
        const auto end = std::partition(lights.begin(), lights.end(), [&](std::uint32_t light) {
            return middles.extent()[best.axis] > 0 &&
                   bin_of(light, best.axis, middles) <= best.last;
        });
        const auto first = static_cast<std::size_t>(end - lights.begin());
        return first == 0 || first == lights.size() ? lights.size() / 2 : first;
    }

    void try_axis(std::span<const std::uint32_t> lights, int axis, const Bounds<glm::vec3>& middles,
                  double thinness, Split& best) const
    {
        std::array<std::optional<LightBounds>, kBins> bins, after;
        const auto add = [](std::optional<LightBounds>& to, const LightBounds& more) {
            to = to ? together(*to, more) : more;
        };
        for (const std::uint32_t light : lights)
            add(bins[static_cast<std::size_t>(bin_of(light, axis, middles))], lights_[light]);
        for (std::size_t i = kBins - 1; i > 0; --i) {
            after[i - 1] = after[i];
            if (bins[i])
                add(after[i - 1], *bins[i]);
        }
        std::optional<LightBounds> before;
        for (std::size_t i = 0; i + 1 < kBins; ++i) {
            if (bins[i])
                add(before, *bins[i]);
            if (!before || !after[i])
                continue;
            const double cost = thinness * (spread_cost(*before) + spread_cost(*after[i]));
            if (cost < best.cost)
                best = {axis, static_cast<int>(i), cost};
        }
    }

    const std::vector<LightBounds>& lights_;
    LightTree tree_;
};

} // namespace

LightTree build_light_tree(const std::vector<LightBounds>& lights)
{
    return TreeBuilder(lights).take();
}

std::optional<ChosenLight> choose_light(const LightTree& tree, const LightReceiver& at, double u)
{
    std::uint32_t here = 0;
    double probability = importance(tree.nodes[0].bounds, at) > 0 ? 1 : 0;
    while (probability > 0 && tree.nodes[here].second != 0) {
        const std::uint32_t second = tree.nodes[here].second;
        const double a = importance(tree.nodes[here + 1].bounds, at);
        const double b = importance(tree.nodes[second].bounds, at);
        if (!(a + b > 0))
            return std::nullopt;
        const double first = a / (a + b);
        const bool to_first = u < first;
        u = std::min(to_first ? u / first : (u - first) / (1 - first), kBelowOne);
        probability *= to_first ? first : 1 - first;
        here = to_first ? here + 1 : second;
    }
    if (!(probability > 0))
        return std::nullopt;
    return ChosenLight{tree.nodes[here].light, probability};
}

double probability_of(const LightTree& tree, const LightReceiver& at, std::uint32_t light)
{
    double probability = 1;
    std::uint32_t here = tree.leaf_of[light];
    while (here != 0 && probability > 0) {
        const std::uint32_t parent = tree.nodes[here].parent;
        const double a = importance(tree.nodes[parent + 1].bounds, at);
        const double b = importance(tree.nodes[tree.nodes[parent].second].bounds, at);
        const double first = a + b > 0 ? a / (a + b) : 0;
        probability *= here == parent + 1 ? first : (a + b > 0 ? 1 - first : 0);
        here = parent;
    }
    return probability > 0 && importance(tree.nodes[0].bounds, at) > 0 ? probability : 0;
}

} // namespace hipmap
