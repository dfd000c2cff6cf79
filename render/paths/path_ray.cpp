#include "render/paths/path_ray.h"

namespace hipmap {

void leave_by_mirror(const RenderScene& scene, const Interaction& at, PathRay& path)
{
    path.ray = mirror_ray(at);
    enter_media(scene, at, path);
}

void leave_through(const RenderScene& scene, const Interaction& at, float eta, PathRay& path)
{
    path.ray = transmitted_ray(at, eta);
    path.absorption = absorption_behind(at);
    enter_media(scene, at, path);
}

} // namespace hipmap
