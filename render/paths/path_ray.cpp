#include "render/paths/path_ray.h"

namespace hipmap {

namespace {

/// For a ray already sent.
void enter_media(const RenderScene& scene, const Interaction& at, PathRay& path)
{
    if (scene.has_media() && glm::dot(path.ray.direction, at.normal) < 0)
        cross(*scene.media, at.point.face, at.front, path.inside);
}

} // namespace

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

void leave_by_lobes(const RenderScene& scene, const Interaction& at, const LobeSample& sample,
                    Lobes lobes, PathRay& path)
{
    path.ray = scattered_ray(at, sample);
    if (lobes == Lobes::gathered)
        path.nanometres = 0; // light is of all wavelengths after it
    else if (sample.transmitted)
        path.absorption = absorption_behind(at);
    enter_media(scene, at, path);
}

} // namespace hipmap
