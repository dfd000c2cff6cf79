#include "render/lights/light.h"

#include <algorithm>

namespace hipmap {

namespace {

/// Returns the path power of kinds whose light paths all have one colour.
template <typename Kind>
double path_power(const Kind& kind)
{
    const glm::dvec3 whole = power(kind);
    return std::max({whole.x, whole.y, whole.z});
}

} // namespace

LightRole role(const Light& light)
{
    return std::visit([](const auto& kind) { return kind.kRole; }, light);
}

std::optional<LightSample> sample_li(const Light& light, const LightReceiver& at,
                                     RandomSequence& random)
{
    return std::visit([&](const auto& kind) { return sample_li(kind, at, random); }, light);
}

std::optional<LightHit> intersect(const Light& light, const Ray& ray)
{
    return std::visit([&](const auto& kind) { return intersect(kind, ray); }, light);
}

bool can_be_met(const Light& light)
{
    return std::visit([](const auto& kind) { return can_be_met(kind); }, light);
}

EmittedPath sample_emission(const Light& light, const PathPlace& path, RandomSequence& random)
{
    return std::visit([&](const auto& kind) { return sample_emission(kind, path, random); }, light);
}

EmittedPath sample_aimed_emission(const Light& light, const PathPlace& path,
                                  const std::vector<TargetSphere>& targets, RandomSequence& random)
{
    return std::visit(
        [&](const auto& kind) { return sample_aimed_emission(kind, path, targets, random); },
        light);
}

std::optional<PrimarySample> primary_of(const Light& light, const Ray& ray,
                                        const PrimarySample& unused)
{
    return std::visit(
        [&](const auto& kind) -> std::optional<PrimarySample> {
            if constexpr (requires { primary_of(kind, ray, unused).size(); })
                return primary_of(kind, ray, unused);
            else
                return std::nullopt;
        },
        light);
}

std::optional<FarLight> far_light(const Light& light)
{
    return std::visit(
        [](const auto& kind) -> std::optional<FarLight> {
            if constexpr (requires { far_light(kind).second; })
                return far_light(kind);
            else
                return std::nullopt;
        },
        light);
}

glm::dvec3 power(const Light& light)
{
    return std::visit([](const auto& kind) { return power(kind); }, light);
}

std::optional<LightBounds> bounds(const Light& light)
{
    return std::visit([](const auto& kind) { return bounds(kind); }, light);
}

double path_power(const Light& light)
{
    return std::visit([](const auto& kind) { return path_power(kind); }, light);
}

} // namespace hipmap
