#pragma once

#include "common/math/sampling.h"
#include "render/shading/scatter.h"

#include <vector>

namespace hipmap::tiny {

/// Directions in which a surface is seen: steep, oblique and grazing.
inline const glm::vec3 kBacks[] = {{0.1f, 0, 1}, {0.7f, -0.4f, 0.6f}, {-1, 0.2f, 0.25f}};

/// A point of a flat surface of the material, seen from `back`: in front of it if back.z > 0.
inline Interaction lit_surface(const Material& material, const glm::vec3& back, bool solid = true)
{
    Interaction at;
    at.own = make_bsdf(material, material_factors(material));
    at.ior = at.own->ior;
    at.point.geometric_normal = at.point.shading_normal = {0, 0, 1};
    at.back = glm::normalize(back);
    at.front = back.z > 0;
    at.normal = at.shading_normal = {0, 0, at.front ? 1 : -1};
    at.cosine = glm::dot(at.back, at.normal);
    at.solid = solid;
    return at;
}

/// A point that no longer borrows its scene's material.
inline Interaction kept(Interaction at)
{
    at.own = at.bsdf();
    return at;
}

/// What each lobe of a set sends of a particle's power, added up: of radiance, as `scattered`.
inline Rgb particle_weights(const Interaction& at, Lobes lobes, RandomSequence& random)
{
    Rgb sum(0.0f);
    for (const PlacedLobe& lobe : at.bsdf().lobes())
        if (lobe.handled == lobes) {
            const LobeSample sample = sample_lobe(at, lobe, random);
            sum += sample.weight / (sample.eta * sample.eta);
        }
    return sum;
}

/// Returns lit_surface with its shading normal tilted, so that much of what it reflects lies behind
/// the face.
inline Interaction tilted_surface(const Material& material, const glm::vec3& back)
{
    Interaction at = lit_surface(material, back);
    at.shading_normal = glm::normalize(at.normal + 0.5f * at.back * glm::vec3(-1, -1, 0));
    at.cosine = glm::dot(at.back, at.shading_normal);
    return at;
}

/// Midpoints of a grid of polar angle and azimuth over the whole sphere: `each(direction, solid
/// angle)`.
template <typename Each>
void over_sphere(int rows, Each&& each)
{
    const int columns = 2 * rows;
    const double step = std::numbers::pi / rows;
    for (int i = 0; i < rows; ++i) {
        const double solid_angle = (std::cos(i * step) - std::cos((i + 1) * step)) * step;
        const auto cosine = static_cast<float>(std::cos((i + 0.5) * step));
        for (int j = 0; j < columns; ++j)
            each(direction_from_cosine(cosine, (j + 0.5f) / columns), solid_angle);
    }
}

/// All that the gathered and followed lobes send on of light from at.back.
inline glm::dvec3 sent(const Interaction& at, int rows)
{
    glm::dvec3 sum(0.0);
    over_sphere(rows, [&](const glm::vec3& in, double solid_angle) {
        sum += glm::dvec3(scattered(at, in, Lobes::gathered).value +
                          scattered(at, in, Lobes::followed).value) *
               solid_angle;
    });
    return sum;
}

/// Pairs of directions above surfaces of the materials, by either set of lobes: `each(there, back)`
/// hears what the lobes scatter one way and the other.
template <typename Each>
void there_and_back(const std::vector<Material>& materials, Each&& each)
{
    for (std::uint64_t i = 0; i < 4000; ++i) {
        RandomSequence random(11, RandomStream::pictures, 0, i);
        const Material& material = materials[i % materials.size()];
        glm::vec3 a = sample_sphere(random.next2()), b = sample_sphere(random.next2());
        a.z = std::abs(a.z);
        b.z = std::abs(b.z);
        for (const Lobes lobes : {Lobes::gathered, Lobes::followed})
            each(scattered(lit_surface(material, a), b, lobes).value.x / b.z,
                 scattered(lit_surface(material, b), a, lobes).value.x / a.z);
    }
}

/// Below a clear coat.
inline Material lacquered(Material material, float roughness, float coat_roughness)
{
    material.roughness = roughness;
    material.clearcoat = 0.9f;
    material.clearcoat_roughness = coat_roughness;
    return material;
}

} // namespace hipmap::tiny
