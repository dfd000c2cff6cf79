#include "render/shading/interaction.h"

#include "render/shading/anisotropy_tangent.h"
#include "render/shading/normal_map.h"
#include "render/shading/texture_axes.h"

#include <algorithm>
#include <cmath>

namespace hipmap {

namespace {

/// c_max of docs/light_transport.md (9).
constexpr float kMostCorrection = 16;

/// The normal stays as it is where the tilted one would turn away from the ray.
void tilt(const RenderScene& scene, const RayHit& hit, float sign, Interaction& at)
{
    const glm::vec3 tilted = sign * mapped_normal(scene.scene, at.point, hit.barycentric);
    const float cosine = glm::dot(at.back, tilted);
    if (!(cosine > 0))
        return;
    at.shading_normal = tilted;
    at.cosine = cosine;
}

/// The clear coat has its own map or none, whatever the surface below has.  smooth: the shading
/// normal before that was tilted.
void tilt_coat(const RenderScene& scene, const RayHit& hit, float sign, const glm::vec3& smooth,
               Interaction& at)
{
    const glm::vec3 tilted =
        sign * mapped_normal(scene.scene, at.point, hit.barycentric, TextureUse::clearcoat_normal);
    const glm::vec3 normal = glm::dot(at.back, tilted) > 0 ? tilted : smooth;
    if (normal != at.shading_normal)
        at.coat_normal = normal;
}

/// No tangent where nothing says along what facets are anisotropic.
void find_tangent(const RenderScene& scene, const RayHit& hit, Interaction& at)
{
    std::optional<glm::vec3> along = anisotropy_tangent(scene.scene, at.point, hit.barycentric);
    if (along)
        along = part_across(*along, at.shading_normal);
    if (along)
        at.tangent = *along;
}

/// What differs from point to point.  A function of its own, to spare others its registers.
[[gnu::noinline]] void add_details(const RenderScene& scene, const RayHit& hit, MaterialId material,
                                   float sign, Interaction& at)
{
    if (scene.varying[material] != 0)
        at.own = make_bsdf(scene.scene.materials[material],
                           material_at(scene.scene, hit.face, hit.barycentric));
    if (scene.opacity)
        at.opacity = scene.opacity(hit.face, hit.barycentric);
    if (scene.bumpy[material] != 0) {
        const glm::vec3 smooth = at.shading_normal;
        tilt(scene, hit, sign, at);
        if (at.bsdf().layers.clearcoat > 0)
            tilt_coat(scene, hit, sign, smooth, at);
    }
    if (at.bsdf().is_directed)
        find_tangent(scene, hit, at);
}

} // namespace

Interaction interact(const RenderScene& scene, const Ray& ray, const RayHit& hit)
{
    Interaction out;
    out.point = surface_point(scene.mesh(), hit.face, hit.barycentric);
    const MaterialId material = scene.mesh().material_of(hit.face);
    out.worn = &scene.bsdfs[material];
    out.back = -ray.direction;
    out.front = glm::dot(out.back, out.point.geometric_normal) >= 0;
    const float sign = out.front ? 1.0f : -1.0f;
    out.normal = sign * out.point.geometric_normal;
    out.shading_normal = sign * out.point.shading_normal;
    out.cosine = glm::dot(out.back, out.shading_normal);
    if (!(out.cosine > 0)) { // seen from behind the interpolated normal
        out.shading_normal = out.normal;
        out.cosine = std::max(0.0f, glm::dot(out.back, out.normal));
    }
    if (!scene.is_plain(material)) [[unlikely]]
        add_details(scene, hit, material, sign, out);
    out.ior = out.bsdf().ior;
    const FaceId stored = scene.partition.stored_face(hit.face);
    out.solid = scene.partition.closed[stored] != 0;
    const bool flipped = scene.partition.flipped[stored] != 0;
    out.side = out.front == flipped ? 1 : 0;
    return out;
}

Interaction scattering_point(const glm::vec3& position, const glm::vec3& back,
                             const PhaseFunction& phase, const MediumStack& inside)
{
    Interaction out;
    out.point.position = position;
    out.back = back;
    out.phase = &phase;
    out.inside = &inside;
    return out;
}

MediumStack medium_stack_towards(const RenderScene& scene, const Interaction& at,
                                 const glm::vec3& direction)
{
    if (!at.in_media())
        return {};
    MediumStack inside = *at.inside;
    if (glm::dot(direction, at.normal) < 0)
        cross(*scene.media, at.point.face, at.front, inside);
    return inside;
}

Rgb unoccluded_in_media(const RenderScene& scene, const Interaction& at, const Ray& shadow)
{
    return let_through(*scene.media, shadow, medium_stack_towards(scene, at, shadow.direction));
}

std::optional<RayHit> first_surface(const RenderScene& scene, const Interaction& at, const Ray& ray,
                                    Rgb& left)
{
    if (!at.in_media())
        return scene.rays.nearest(ray);
    MediumStack inside = medium_stack_towards(scene, at, ray.direction);
    return walk(*scene.media, ray, inside,
                [&](const MediumSegment& segment) {
                    left *= left_along(*scene.media, segment);
                    return true;
                })
        .hit;
}

Ray mirror_ray(const Interaction& at)
{
    Ray ray;
    ray.direction = reflect(at.back, at.shading_normal);
    if (!(glm::dot(ray.direction, at.normal) > 0)) // bent into the surface by the shading normal
        ray.direction = reflect(at.back, at.normal);
    ray.origin = offset_origin(at.point, at.normal);
    return ray;
}

Ray transmitted_ray(const Interaction& at, float eta)
{
    Ray ray;
    ray.direction = eta == 1 ? -at.back : refract(at.back, at.shading_normal, eta);
    if (!(glm::dot(ray.direction, at.normal) < 0))
        ray.direction = -at.back;
    ray.origin = offset_origin(at.point, -at.normal);
    return ray;
}

Rgb absorption_behind(const Interaction& at)
{
    return at.solid && at.front && !at.in_media() ? at.bsdf().absorption : Rgb(0);
}

float particle_correction(const Interaction& at, const glm::vec3& towards)
{
    if (at.shading_normal == at.normal)
        return 1;
    const float below =
        glm::dot(at.back, at.normal) * std::abs(glm::dot(towards, at.shading_normal));
    if (!(below > 0))
        return 0;
    return at.cosine * std::abs(glm::dot(towards, at.normal)) / below;
}

float specular_correction(const Interaction& at, const glm::vec3& towards)
{
    return std::min(particle_correction(at, towards), kMostCorrection);
}

float specular_share(const Interaction& at, const glm::vec3& from)
{
    if (at.shading_normal == at.normal)
        return 1;
    const float carried =
        std::abs(glm::dot(from, at.shading_normal)) * glm::dot(at.back, at.normal);
    const float most = kMostCorrection * std::abs(glm::dot(from, at.normal)) * at.cosine;
    return carried > most ? most / carried : 1.0f;
}

} // namespace hipmap
