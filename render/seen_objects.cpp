#include "render/seen_objects.h"

#include "common/scene/named_lights.h"
#include "common/scene/scene_names.h"
#include "render/integrator/pixel_samples.h"

#include <algorithm>
#include <map>
#include <vector>

namespace hipmap {

std::string describe_seen(const RenderScene& scene, const RenderOptions& options)
{
    constexpr int kRays = 32; // along each axis
    const TriangleMesh& mesh = scene.mesh();
    const PixelRect pixels = rendered_pixels(options);
    std::map<ObjectId, int> met;
    for (int i = 0; i < kRays * kRays; ++i) {
        const glm::vec2 at = (glm::vec2(i % kRays, i / kRays) + 0.5f) / float{kRays};
        const glm::vec2 point =
            glm::vec2(pixels.x0, pixels.y0) + at * glm::vec2(pixels.width(), pixels.height());
        if (const auto hit = scene.rays.nearest(image_ray(scene, options, point, glm::vec2(0.0f))))
            ++met[mesh.object_of(hit->face)];
    }
    std::vector<std::pair<int, ObjectId>> order;
    for (const auto& [object, rays] : met)
        order.emplace_back(-rays, object);
    std::ranges::sort(order);
    std::vector<std::string> names;
    for (const auto& [rays, object] : order)
        names.push_back(mesh.object_names[object]);
    return names.empty() ? "no object" : list_names(names);
}

std::string describe_light(const RenderScene& scene, std::size_t light)
{
    const std::vector<SceneLight>& analytic = scene.scene.lights;
    if (light < analytic.size()) {
        const NamedLight named = describe_light(analytic[light]);
        return std::string(named.kind) + " '" + named.name + "'";
    }
    if (light >= scene.lights.lights.size())
        return "a light";
    const Light& other = scene.lights.lights[light];
    if (const auto* mesh = std::get_if<EmissiveMesh>(&other); mesh && !mesh->faces.empty()) {
        const TriangleMesh& faces = scene.mesh();
        return "object '" + faces.object_names[faces.object_of(mesh->faces.front())] + "'";
    }
    return role(other) == LightRole::medium ? "media" : "the environment";
}

} // namespace hipmap
