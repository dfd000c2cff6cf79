#include "render/media/media_set.h"

#include "common/math/bounds.h"
#include "common/scene/store_copies.h"
#include "render/media/material_insides.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>

namespace hipmap {

namespace {

bool bounds_an_inside(const MediaSet& media, FaceId face)
{
    return media.partition.is_closed(face) && media.has_inside[media.mesh.material_of(face)] != 0;
}

void find_spaces(MediaSet& media)
{
    const Bounds<glm::vec3> all = bounds_of(media.mesh);
    Bounds<glm::vec3> with_inside; // no copies have one
    for (FaceId face = 0; face < media.mesh.face_count(); ++face)
        if (bounds_an_inside(media, face))
            for (const glm::vec3& corner : media.mesh.triangle(face))
                with_inside.add(corner);
    if (!all.empty()) {
        media.centre = all.centre();
        media.radius = 0.5f * glm::length(all.extent());
    }
    media.low = with_inside.empty() ? glm::vec3(1) : with_inside.low;
    media.high = with_inside.empty() ? glm::vec3(-1) : with_inside.high;
}

/// Its inside is not that of clear glass, whose rays know by themselves what it absorbs.
bool needs_media(const Material& material)
{
    return material.holds_medium() || (material.transmission == 0 && !material.inside().is_clear());
}

bool absorbs_at(const MediaSet& media, const glm::vec3& point)
{
    return !media.medium(medium_stack_at(media, point).current()).is_clear();
}

/// The middle of what a named light's paths start from, and points at its rim.
std::array<glm::dvec3, 7> parts_of(const MeanEmission& light)
{
    std::array<glm::dvec3, 3> to_rim{light.half_right, light.half_up};
    if (light.from == MeanEmission::From::sphere)
        for (int axis = 0; axis < 3; ++axis)
            to_rim[static_cast<std::size_t>(axis)][axis] = light.radius;
    if (light.from == MeanEmission::From::rectangle)
        to_rim = {light.half_right + light.half_up, light.half_right - light.half_up};
    std::array<glm::dvec3, 7> out;
    out.fill(light.centre);
    for (std::size_t i = 0; i < to_rim.size(); ++i) {
        out[2 * i] += to_rim[i];
        out[2 * i + 1] -= to_rim[i];
    }
    return out;
}

/// The middle of a face, and points beside its corners.
std::array<glm::vec3, 4> parts_of(const TriangleMesh& mesh, FaceId face)
{
    const glm::vec3 middle = centroid(mesh, face);
    const auto [a, b, c] = mesh.triangle(face);
    const auto beside = [&](const glm::vec3& corner) { return glm::mix(corner, middle, 0.01f); };
    return {middle, beside(a), beside(b), beside(c)};
}

/// Paths start where something absorbs: their rays do not know it, as they have not entered it, nor
/// do the shadow rays between what is in there.
bool starts_in_absorption(const MediaSet& media, const Scene& scene)
{
    const auto absorbs = [&](const auto& point) { return absorbs_at(media, glm::vec3(point)); };
    if (absorbs(scene.cameras[scene.camera].position))
        return true;
    for (const SceneLight& light : scene.lights) {
        const MeanEmission sent =
            std::visit([](const auto& of_kind) { return mean_emission(of_kind); }, light);
        if (sent.from != MeanEmission::From::afar && std::ranges::any_of(parts_of(sent), absorbs))
            return true;
    }
    std::atomic<bool> found = false;
    tbb::parallel_for(FaceId{0}, static_cast<FaceId>(scene.mesh.face_count()), [&](FaceId face) {
        if (!is_black(scene.materials[scene.mesh.material_of(face)].emission) && !found &&
            std::ranges::any_of(parts_of(scene.mesh, face), absorbs))
            found = true;
    });
    return found;
}

/// Any direction that is unlikely to run along edges.
glm::vec3 way_out()
{
    return glm::normalize(glm::vec3(0.2371f, 0.8963f, 0.3747f));
}

} // namespace

std::optional<MediaSet> collect_media(const Scene& scene, const Partition& partition,
                                      const EmbreeScene& rays)
{
    std::vector<std::uint8_t> closed(scene.materials.size(), 0), worn = closed;
    for (FaceId face = 0; face < scene.mesh.face_count(); ++face) {
        worn[scene.mesh.material_of(face)] = 1;
        closed[scene.mesh.material_of(face)] |= partition.is_closed(face);
    }
    MediaSet out{.mesh = scene.mesh, .partition = partition, .rays = rays, .around = scene.around};
    out.nested = scene.nested_dielectrics;
    bool wanted = out.nested || !scene.around.is_clear(), absorbs = false;
    out.scatters = scene.around.scatters();
    out.emits = scene.around.emits();
    for (std::size_t m = 0; m < scene.materials.size(); ++m) {
        const Material& material = scene.materials[m];
        out.insides.push_back(material.inside());
        out.has_inside.push_back(lets_light_in(material) && closed[m] != 0);
        out.has_surface.push_back(material.boundary);
        out.bends.push_back(is_dielectric(material));
        out.priority.push_back(material.priority);
        wanted = wanted || (out.has_inside.back() != 0 && needs_media(material)) ||
                 (worn[m] != 0 && !material.boundary);
        absorbs |= out.has_inside.back() != 0 && !out.insides.back().is_clear();
        out.scatters |= out.has_inside.back() != 0 && out.insides.back().scatters();
        out.emits |= out.has_inside.back() != 0 && out.insides.back().emits();
    }
    if (!wanted && !absorbs)
        return std::nullopt;
    find_spaces(out);
    if (!wanted && !starts_in_absorption(out, scene))
        return std::nullopt;
    out.densities = place_densities(scene, partition);
    if (out.emits)
        out.emission_power = mean_media_emission(out);
    return out;
}

void cross(const MediaSet& media, FaceId face, bool front, MediumStack& inside)
{
    if (!bounds_an_inside(media, face))
        return;
    const MaterialId material = media.mesh.material_of(face);
    if (front)
        inside.enter(material, media.priority);
    else
        inside.leave(material);
}

MaterialId dielectric_at(const MediaSet& media, const MediumStack& inside)
{
    for (std::size_t i = inside.count; i-- > 0;)
        if (media.bends[inside.entered[i]] != 0)
            return inside.entered[i];
    return kNone;
}

bool is_surface(const MediaSet& media, FaceId face, bool front, const MediumStack& inside)
{
    const MaterialId material = media.mesh.material_of(face);
    if (!has_surface(media, face))
        return false;
    if (!media.nested || media.bends[material] == 0 || !media.partition.is_closed(face))
        return true;
    MediumStack behind = inside;
    cross(media, face, front, behind);
    // What is left without having been entered, or is one too many, counts as a surface.
    return behind.count == inside.count ||
           dielectric_at(media, behind) != dielectric_at(media, inside);
}

MediumStack medium_stack_at(const MediaSet& media, const glm::vec3& point)
{
    if (!(glm::all(glm::lessThanEqual(media.low, point)) &&
          glm::all(glm::lessThanEqual(point, media.high))))
        return {};
    Ray ray;
    ray.origin = point;
    ray.direction = way_out();
    MediumStack passed;           // entered on the way
    std::vector<MaterialId> left; // without having been entered, inmost first
    for (int faces = 0; faces < kMostFaces; ++faces) {
        const std::optional<RayHit> hit = media.rays.nearest(ray);
        if (!hit)
            break;
        const SurfacePoint at = surface_point(media.mesh, hit->face, hit->barycentric);
        const bool front = glm::dot(ray.direction, at.geometric_normal) <= 0;
        const std::size_t before = passed.count;
        cross(media, hit->face, front, passed);
        if (!front && passed.count == before && bounds_an_inside(media, hit->face))
            left.push_back(media.mesh.material_of(hit->face));
        ray.origin = offset_origin(at, ray.direction);
    }
    MediumStack out;
    for (auto material = left.rbegin(); material != left.rend(); ++material)
        out.enter(*material, media.priority);
    return out;
}

Ray within_sphere(const MediaSet& media, const Ray& ray)
{
    const glm::dvec3 way = glm::dvec3(ray.origin) - glm::dvec3(media.centre);
    const double along = -glm::dot(way, glm::dvec3(ray.direction));
    const glm::dvec3 aside = way + along * glm::dvec3(ray.direction);
    const double half2 = double{media.radius} * media.radius - glm::dot(aside, aside);
    Ray out = ray;
    if (!(half2 > 0)) {
        out.far = out.near;
        return out;
    }
    out.near = std::max(ray.near, static_cast<float>(along - std::sqrt(half2)));
    out.far = std::min(ray.far, static_cast<float>(along + std::sqrt(half2)));
    return out;
}

Rgb let_through(const MediaSet& media, const Ray& ray, MediumStack inside)
{
    Rgb left(1.0f);
    const WalkEnd end = walk(media, ray, inside, [&](const MediumSegment& segment) {
        left *= left_along(media, segment);
        return !is_black(left);
    });
    return end.hit ? Rgb(0) : left;
}

} // namespace hipmap
