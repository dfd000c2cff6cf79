#include "preprocess/prediction/light_walk.h"

#include "common/math/frame.h"
#include "common/math/fresnel.h"
#include "common/math/sampling.h"
#include "common/rays/surface_point.h"

#include <glm/exponential.hpp>

#include <array>
#include <cmath>

namespace hipmap {

namespace {

/// Light caught in glass or a white room goes on for long; what comes later counts little.
constexpr int kMostSurfaces = 256;

/// A surface as a light path meets it.
struct Met {
    SurfacePoint point;
    const MeanMaterial& material;
    glm::vec3 back;   ///< unit, to where the path came from
    glm::vec3 normal; ///< unit, on that side
    bool front = true;
    bool solid = false;
};

/// One way on, and the share of light that goes it.
struct Way {
    enum class By { diffuse, through, reflection, coat, glass } by;
    Rgb share;
};

constexpr std::size_t kWays = 5;

std::array<Way, kWays> ways_from(const Met& at)
{
    const MeanMaterial& m = at.material;
    const float weight = grazing_weight(glm::dot(at.back, at.normal));
    const Rgb reflected = m.reflectance + (Rgb(m.grazing) - m.reflectance) * weight;
    constexpr float kCoat = 0.04f; // of a clear coat, at normal incidence
    const float coat = m.clearcoat * (kCoat + (1 - kCoat) * weight);
    const Rgb below = (1 - coat) * m.opaque * glm::max(Rgb(1) - reflected, Rgb(0));
    return {{{Way::By::diffuse, below * m.base_color * (1 - m.through)},
             {Way::By::through, below * m.through * m.through_color},
             {Way::By::reflection, (1 - coat) * glm::max(reflected, Rgb(0))},
             {Way::By::coat, Rgb(coat)},
             {Way::By::glass, (1 - coat) * Rgb(m.glass)}}};
}

/// Draws a way by the largest channel of what goes there and weighs the power by Russian roulette.
/// Nothing: the path ends.
std::optional<Way::By> draw_way(const Met& at, Rgb& power, RandomSequence& random)
{
    const float before = max_channel(power);
    float left = random.next(), sum = 0;
    std::optional<Way::By> out;
    Rgb drawn(0);
    for (const Way& way : ways_from(at)) {
        const Rgb sent = power * way.share;
        const float probability = max_channel(sent) / before;
        sum += probability;
        if (!out && probability > 0 && left < probability) {
            out = way.by;
            drawn = sent / probability;
        }
        left -= probability;
    }
    power = drawn;
    return out;
}

/// The normal of a facet of GGX roughness, on the side of the surface's.
glm::vec3 draw_facet(const glm::vec3& normal, float roughness, RandomSequence& random)
{
    const glm::vec2 u = random.next2();
    const float alpha = roughness * roughness, tan2 = alpha * alpha * u.x / (1 - u.x);
    return Frame(normal).to_world(direction_from_cosine(1 / std::sqrt(1 + tan2), u.y));
}

glm::vec3 reflect_off(const Met& at, float roughness, RandomSequence& random)
{
    const glm::vec3 facet = draw_facet(at.normal, roughness, random);
    const glm::vec3 out = reflect(at.back, facet);
    return glm::dot(out, at.normal) > 0 ? out : reflect(at.back, at.normal);
}

/// Reflects or refracts; through thin panes light goes straight on.
glm::vec3 cross_glass(const Met& at, Rgb& power, RandomSequence& random)
{
    const MeanMaterial& m = at.material;
    const float eta = at.solid && !at.front ? 1 / m.ior : m.ior;
    const glm::vec3 facet = draw_facet(at.normal, m.roughness, random);
    const float cosine = glm::dot(at.back, facet);
    float reflected = cosine > 0 ? fresnel_dielectric(cosine, eta) : 1;
    if (!at.solid) // both faces of the pane
        reflected = 2 * reflected / (1 + reflected);
    if (random.next() < reflected) {
        const glm::vec3 out = reflect(at.back, facet);
        return glm::dot(out, at.normal) > 0 ? out : reflect(at.back, at.normal);
    }
    power *= m.base_color;
    if (!at.solid)
        return -at.back;
    return refract(at.back, facet, eta);
}

/// A path under way.
struct Walk {
    Ray ray;
    Rgb power;
    Rgb absorption{0.0f}; ///< per scene unit, where it is
    bool was_diffuse = false, was_specular = false;

    bool leaves(PhotonKind kind) const
    {
        return kind == PhotonKind::indirect ? was_diffuse : was_specular && !was_diffuse;
    }
};

/// Sends the path on from a surface.  False: it ends.
bool scatter(const Met& at, Walk& walk, RandomSequence& random)
{
    const std::optional<Way::By> by = draw_way(at, walk.power, random);
    if (!by)
        return false;
    const MeanMaterial& m = at.material;
    glm::vec3 out;
    switch (*by) {
    case Way::By::diffuse:
        out = Frame(at.normal).to_world(sample_cosine_hemisphere(random.next2()));
        break;
    case Way::By::through:
        out = Frame(-at.normal).to_world(sample_cosine_hemisphere(random.next2()));
        break;
    case Way::By::reflection:
        out = reflect_off(at, m.roughness, random);
        break;
    case Way::By::coat:
        out = reflect_off(at, m.coat_roughness, random);
        break;
    case Way::By::glass:
        out = cross_glass(at, walk.power, random);
        break;
    }
    const bool gathered = *by == Way::By::diffuse || *by == Way::By::through ||
                          (*by == Way::By::reflection && m.roughness > kFollowedRoughness) ||
                          (*by == Way::By::coat && m.coat_roughness > kFollowedRoughness);
    (gathered ? walk.was_diffuse : walk.was_specular) = true;
    const bool goes_in = glm::dot(out, at.normal) < 0;
    if (goes_in)
        walk.absorption = at.solid && at.front ? m.absorption : Rgb(0);
    walk.ray = {offset_origin(at.point, goes_in ? -at.normal : at.normal), out};
    return max_channel(walk.power) > 0;
}

Met meet(const LightSpace& space, const Ray& ray, const RayHit& hit)
{
    Met out{surface_point(space.mesh, hit.face, hit.barycentric),
            space.materials[space.mesh.material_of(hit.face)],
            -ray.direction,
            {}};
    out.front = glm::dot(out.back, out.point.geometric_normal) >= 0;
    out.normal = out.front ? out.point.geometric_normal : -out.point.geometric_normal;
    out.solid = space.partition.is_closed(hit.face);
    return out;
}

} // namespace

void follow_light(const LightSpace& space, LightStart path, PhotonKind kind, RandomSequence& random,
                  std::vector<LeftPhoton>& out)
{
    Walk walk{path.ray, path.power};
    if (!(max_channel(walk.power) > 0))
        return;
    for (int surface = 0; surface < kMostSurfaces; ++surface) {
        const std::optional<RayHit> hit = space.nearest(walk.ray);
        if (!hit)
            return;
        walk.power *= glm::exp(-walk.absorption * hit->distance);
        if (!(max_channel(walk.power) > 0))
            return;
        const Met at = meet(space, walk.ray, *hit);
        if (walk.leaves(kind) && stores_photons(at.material) &&
            space.partition.map_of(hit->face) != kNone) {
            const bool is_flipped = space.partition.is_flipped(hit->face);
            out.push_back(
                {hit->face, at.front == is_flipped ? std::uint8_t{1} : std::uint8_t{0}, kind});
        }
        const float opacity = at.material.boundary ? at.material.opacity : 0;
        if (opacity < 1 && random.next() >= opacity) {
            walk.ray.origin = offset_origin(at.point, walk.ray.direction);
            continue;
        }
        if (!scatter(at, walk, random) || (kind == PhotonKind::caustic && walk.was_diffuse))
            return;
    }
}

} // namespace hipmap
