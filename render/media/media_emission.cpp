#include "common/math/frame.h"
#include "common/math/sampling.h"
#include "render/media/material_insides.h"
#include "render/media/media_set.h"

namespace hipmap {

namespace {

/// A part of a line where something emits.
struct EmissivePart {
    OpticalDepth optical_depth;
    const Medium* medium = nullptr;

    float weight() const { return max_channel(medium->emission) * optical_depth.total; }
};

struct Sphere {
    glm::vec3 centre{0.0f};
    float radius = 0.0f;
};

/// Around all that emits.
Sphere emissive_sphere(const MediaSet& media)
{
    if (media.around.emits())
        return {media.centre, media.radius};
    return {0.5f * (media.low + media.high), 0.5f * glm::length(media.high - media.low)};
}

void add_part(const MediaSet& media, const MediumStack& inside, Ray ray,
              std::vector<EmissivePart>& parts)
{
    const Medium& medium = media.medium(inside.current());
    if (!medium.emits())
        return;
    if (inside.current() == kNone)
        ray = within_sphere(media, ray);
    if (!(ray.near < ray.far) || !std::isfinite(ray.far))
        return;
    ray.origin += ray.near * ray.direction;
    ray.far -= ray.near;
    ray.near = 0;
    parts.push_back({optical_depth_along(media.density(inside.current()), ray), &medium});
}

/// Returns the emissive parts of the whole line through all faces.
std::vector<EmissivePart> emissive_parts(const MediaSet& media, Ray ray)
{
    std::vector<EmissivePart> out;
    MediumStack inside = medium_stack_at(media, ray.origin);
    for (int faces = 0; faces < kMostFaces; ++faces) {
        const std::optional<RayHit> hit = media.rays.nearest(ray);
        if (hit)
            ray.far = hit->distance;
        add_part(media, inside, ray, out);
        if (!hit)
            break;
        const SurfacePoint at = surface_point(media.mesh, hit->face, hit->barycentric);
        cross(media, hit->face, glm::dot(ray.direction, at.geometric_normal) <= 0, inside);
        ray.origin = offset_origin(at, ray.direction);
        ray.near = Ray{}.near;
        ray.far = std::numeric_limits<float>::infinity();
    }
    return out;
}

} // namespace

MediaEmission sample_media_emission(const MediaSet& media, RandomSequence& random)
{
    const Sphere sphere = emissive_sphere(media);
    const glm::vec3 direction = sample_sphere(random.next2());
    const Frame frame(direction);
    const glm::vec2 aside = sphere.radius * sample_disc(random.next2());
    Ray line;
    line.origin =
        sphere.centre + frame.x * aside.x + frame.y * aside.y - direction * (2 * sphere.radius);
    line.direction = direction;
    const std::vector<EmissivePart> parts = emissive_parts(media, line);
    float sum = 0;
    for (const EmissivePart& part : parts)
        sum += part.weight();
    float drawn = random.next() * sum;
    for (const EmissivePart& part : parts) {
        if (&part != &parts.back() && !(drawn < part.weight())) {
            drawn -= part.weight();
            continue;
        }
        if (!(part.weight() > 0))
            break;
        const float share = std::min(1.0f, drawn / part.weight());
        Ray ray;
        ray.origin = part.optical_depth.part.origin +
                     distance_at(part.optical_depth, share * part.optical_depth.total) * direction;
        ray.direction = direction;
        const float lines = 4 * kPi * kPi * sphere.radius * sphere.radius;
        return {ray, part.medium->emission * (sum / max_channel(part.medium->emission) * lines)};
    }
    return {};
}

Rgb mean_media_emission(const MediaSet& media)
{
    constexpr std::uint64_t kLines = 1024;
    Rgb sum(0.0f);
    for (std::uint64_t i = 0; i < kLines; ++i) {
        RandomSequence random(0, RandomStream::pictures, 0, 0, i);
        sum += sample_media_emission(media, random).power;
    }
    return sum / static_cast<float>(kLines);
}

} // namespace hipmap
