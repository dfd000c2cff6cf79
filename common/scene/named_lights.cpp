#include "common/scene/named_lights.h"

namespace hipmap {

namespace {

std::string_view kind_name(LightKind kind)
{
    switch (kind) {
    case LightKind::point:
        return "point light";
    case LightKind::spot:
        return "spot light";
    case LightKind::directional:
        return "sun (directional light)";
    }
    return "";
}

} // namespace

std::vector<NamedLight> named_lights(const Scene& scene)
{
    std::vector<NamedLight> out;
    for (const LightKind kind : {LightKind::point, LightKind::spot, LightKind::directional})
        for (const PunctualLight& light : scene.lights)
            if (light.kind == kind)
                out.push_back({kind_name(kind),
                               light.name,
                               !is_black(light.intensity),
                               light.radius > 0 || light.half_angle > 0,
                               {light.position, light.direction}});
    for (const AreaLight& light : scene.area_lights)
        out.push_back({"area light",
                       light.name,
                       !is_black(light.radiance),
                       true,
                       {light.centre, light.half_right, light.half_up}});
    return out;
}

} // namespace hipmap
