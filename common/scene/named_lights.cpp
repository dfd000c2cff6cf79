#include "common/scene/named_lights.h"

#include <algorithm>

namespace hipmap {

namespace {

/// Notes in the description of a light what its numbers say.
struct DescribeNumbers : IgnoreNumbers {
    NamedLight& out;

    explicit DescribeNumbers(NamedLight& named) : out(named) {}

    void position(const glm::dvec3& v) { out.placement.push_back(v); }
    void direction(const glm::dvec3& v) { out.placement.push_back(v); }
    void extent(const glm::dvec3& v)
    {
        out.placement.push_back(v);
        out.has_size = true;
    }
    void extent(double size) { (size > 0 ? out.has_size : out.lacks_size) = true; }
    void angle(double size) { extent(size); }
    void radiant_intensity(const glm::dvec3& v) { out.emits = out.emits || v != glm::dvec3(0); }
    void irradiance(const glm::dvec3& v) { radiant_intensity(v); }
    void radiance(const glm::dvec3& v) { radiant_intensity(v); }
};

} // namespace

NamedLight describe_light(const SceneLight& light)
{
    NamedLight out;
    out.kind = std::visit([](const auto& of_kind) { return of_kind.kKind; }, light);
    out.name = name_of(light);
    DescribeNumbers visit(out);
    each_number(light, visit);
    return out;
}

std::vector<NamedLight> named_lights(const std::vector<SceneLight>& lights)
{
    std::vector<const SceneLight*> by_kind;
    for (const SceneLight& light : lights)
        by_kind.push_back(&light);
    std::stable_sort(by_kind.begin(), by_kind.end(), [](const SceneLight* a, const SceneLight* b) {
        return a->index() < b->index();
    });
    std::vector<NamedLight> out;
    for (const SceneLight* light : by_kind)
        out.push_back(describe_light(*light));
    return out;
}

} // namespace hipmap
