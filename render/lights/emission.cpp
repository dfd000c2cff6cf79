#include "render/lights/emission.h"

#include "common/scene/light_path_rules.h"

#include <algorithm>
#include <cmath>

namespace hipmap {

namespace {

/// [lights] 0: no paths.
std::vector<double> powers_of(const LightSet& lights, Emitters emitters)
{
    std::vector<double> out;
    for (const Light& light : lights.lights) {
        const bool left_out =
            emitters == Emitters::all_but_media && role(light) == LightRole::medium;
        out.push_back(left_out ? 0 : path_power(light));
    }
    return out;
}

} // namespace

EmissionGuide even_guide(const LightSet& lights, Emitters emitters)
{
    const std::vector<double> powers = powers_of(lights, emitters);
    double total = 0;
    std::size_t emitting = 0;
    for (const double power : powers) {
        total += power;
        emitting += power > 0 ? 1 : 0;
    }
    EmissionGuide out;
    out.lights.resize(powers.size());
    for (std::size_t i = 0; i < powers.size(); ++i)
        if (powers[i] > 0)
            out.lights[i].share = kLightFloorShare / static_cast<double>(emitting) +
                                  (1 - kLightFloorShare) * powers[i] / total;
    return out;
}

EmissionPlan plan_emission(const EmissionGuide& guide, std::uint64_t paths)
{
    EmissionPlan plan;
    plan.first_path.push_back(0);
    for (const EmissionGuide::OfLight& light : guide.lights) {
        if (light.share > 0 && paths > 0)
            plan.paths += std::max<std::uint64_t>(
                1,
                static_cast<std::uint64_t>(std::llround(light.share * static_cast<double>(paths))));
        plan.first_path.push_back(plan.paths);
    }
    return plan;
}

EmissionPlan plan_emission(const LightSet& lights, std::uint64_t paths, Emitters emitters)
{
    return plan_emission(even_guide(lights, emitters), paths);
}

LightShare share_of(const EmissionPlan& plan, std::uint64_t path)
{
    const auto after = std::upper_bound(plan.first_path.begin(), plan.first_path.end(), path);
    const std::size_t light = static_cast<std::size_t>(after - plan.first_path.begin()) - 1;
    const std::uint64_t first = plan.first_path[light];
    return {light, {path - first, plan.first_path[light + 1] - first}};
}

EmittedPath emit_path(const LightSet& lights, const LightShare& share, RandomSequence& random)
{
    EmittedPath out = sample_emission(lights.lights[share.light], share.path, random);
    out.power /= static_cast<float>(share.path.paths);
    return out;
}

EmittedPath emit_aimed_path(const LightSet& lights, const LightShare& share,
                            const std::vector<TargetSphere>& targets, RandomSequence& random)
{
    EmittedPath out =
        sample_aimed_emission(lights.lights[share.light], share.path, targets, random);
    out.power /= static_cast<float>(share.path.paths);
    return out;
}

} // namespace hipmap
