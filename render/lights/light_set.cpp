#include "render/lights/light_set.h"

#include <algorithm>
#include <utility>

namespace hipmap {

namespace {

/// A tree chooses from more analytic lights than these.
constexpr std::size_t kFewLights = 16;

} // namespace

LightSet make_light_set(std::vector<Light> lights, EmissiveMesh faces)
{
    LightSet out;
    out.lights = std::move(lights);
    out.faces = std::move(faces);
    const auto analytic =
        std::count_if(out.lights.begin(), out.lights.end(),
                      [](const Light& light) { return role(light) == LightRole::analytic; });
    const bool few = static_cast<std::size_t>(analytic) <= kFewLights;
    std::vector<LightBounds> chosen_bounds;
    for (std::uint32_t i = 0; i < out.lights.size(); ++i) {
        const Light& light = out.lights[i];
        if (role(light) == LightRole::environment)
            out.environments.push_back(i);
        if (role(light) != LightRole::analytic || !(path_power(light) > 0))
            continue;
        const std::optional<LightBounds> its_bounds = few ? std::nullopt : bounds(light);
        if (its_bounds) {
            out.chosen.push_back(i);
            chosen_bounds.push_back(*its_bounds);
            out.chosen_are_met = out.chosen_are_met || can_be_met(light);
            continue;
        }
        out.sampled.push_back(i);
        if (can_be_met(light))
            out.met.push_back(i);
    }
    out.tree = build_light_tree(chosen_bounds);
    return out;
}

bool can_be_met(const LightSet& lights)
{
    return !lights.environments.empty() || !lights.faces.empty() || has_met_lights(lights);
}

} // namespace hipmap
