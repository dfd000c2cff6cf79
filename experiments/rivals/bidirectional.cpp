#include "experiments/rivals/bidirectional.h"

#include "common/input_error.h"
#include "experiments/rivals/light_starts.h"
#include "experiments/rivals/pinhole.h"
#include "experiments/rivals/pixels.h"
#include "experiments/rivals/sub_path.h"

namespace hipmap {

namespace {

constexpr int kBands = 16; // of rows, each with an image of its own for light paths

/// What all threads share.
struct Shared {
    const RenderScene& scene;
    const RivalSettings& settings;
    LightStarts starts;
    std::optional<Pinhole> camera;

    /// Light paths of a pass: each eye path has one.
    float light_paths() const
    {
        return static_cast<float>(settings.width) * static_cast<float>(settings.height);
    }
};

/// Traces a light path; its vertices are those that others can be joined to.
std::vector<Vertex> trace_light(const Shared& shared, RandomSequence& random)
{
    std::vector<Vertex> out;
    const LightStart start = draw_start(shared.scene, shared.starts, random);
    if (!(start.pdf > 0) || is_black(start.power))
        return out;
    SubPath path;
    path.ray = start.ray;
    path.carried = start.power;
    path.begun = max_channel(start.power);
    path.from_light = true;
    path.weights = {1 / start.pdf, start.is_point ? 0 : start.cosine / start.pdf};
    while (survives(path, random)) {
        const float here = path.weights.here;
        std::optional<Vertex> vertex = reach_vertex(shared.scene, random, path);
        if (!vertex)
            break;
        if (path.depth == 0 && !start.is_point) { // times the pdf of the light sampled from there
            const float direct = pdf_li(shared.scene.lights.faces, receiver(vertex->at),
                                        start.on_face, vertex->at.back, vertex->hit.distance);
            path.weights.here =
                here * direct * start.cosine / cosine_to(vertex->at, path.ray.direction);
            vertex->weights = path.weights;
        }
        if (vertex->ways.spread() > 0)
            out.push_back(*vertex);
        if (!leave_vertex(shared.scene, *vertex, random, path))
            break;
    }
    return out;
}

/// Returns the light of emissive faces that an eye path meets, weighted.  source: where its ray
/// began; none: at the eye.
Rgb met_light(const Shared& shared, const Vertex& met, const std::optional<LightReceiver>& source)
{
    const Rgb radiance = emitted_radiance(met.at.bsdf(), met.at.point, met.at.back);
    if (is_black(radiance) || !source)
        return met.carried * radiance;
    const float cosine = cosine_to(met.at, met.at.back);
    const float distance = met.hit.distance;
    const float direct =
        pdf_li(shared.scene.lights.faces, *source, met.at.point, -met.at.back, distance) * cosine /
        (distance * distance);
    const float start = start_pdf(shared.scene, shared.starts, met.hit.face, cosine);
    const float others = direct * met.weights.here + start * met.weights.before;
    return met.carried * radiance / (1 + others);
}

/// Light of one light sample, as an eye path sees it.
struct Sampled {
    Ray shadow;
    Rgb light{0.0f};       ///< W/m2 across the ray over the pdf of the sample
    float pdf = 0.0f;      ///< per steradian at the surface; 0: the light has no size
    float area_pdf = 0.0f; ///< of the surface, by light paths: per area across the ray
};

Rgb add_sampled(const Shared& shared, const Vertex& from, const Sampled& sampled)
{
    const glm::vec3& direction = sampled.shadow.direction;
    const SpreadValue found = spread_value(shared.scene, from.at, from.ways, from.hit, direction);
    const Rgb sent = from.carried * found.value * sampled.light;
    if (is_black(sent) || shared.scene.rays.occluded(sampled.shadow))
        return Rgb(0);
    const float by_light = sampled.pdf > 0 ? found.pdf / sampled.pdf : 0;
    const float by_eye = sampled.area_pdf * cosine_to(from.at, direction) *
                         (from.weights.here + from.weights.before * found.reverse);
    return sent / (1 + by_light + by_eye);
}

/// Returns the light of a point of the emissive faces.
Rgb face_light(const Shared& shared, const Vertex& from, RandomSequence& random)
{
    const EmissiveMesh& faces = shared.scene.lights.faces;
    if (faces.empty())
        return Rgb(0);
    const std::optional<EmissivePoint> point = sample_point(faces, receiver(from.at), random);
    if (!point)
        return Rgb(0);
    Sampled out;
    out.shadow = ray_between(from.at.point, point->surface);
    const glm::vec3& direction = out.shadow.direction;
    const float distance = glm::length(point->surface.position - from.at.point.position);
    const float cosine = std::abs(glm::dot(direction, point->surface.geometric_normal));
    out.pdf = per_solid_angle(point->area_pdf, point->surface, direction, distance);
    if (!(out.pdf > 0))
        return Rgb(0);
    out.light = radiance_towards(faces, *point, -direction) / out.pdf;
    // The start's density over that of the sample, which is relative to the same area.
    out.area_pdf = start_pdf(shared.scene, shared.starts, point->surface.face, cosine) /
                   (point->area_pdf * distance * distance);
    return add_sampled(shared, from, out);
}

/// Returns the light of all point lights.
Rgb point_light(const Shared& shared, const Vertex& from, RandomSequence& random)
{
    Rgb sum(0.0f);
    const std::vector<Light>& lights = shared.scene.lights.lights;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        if (!std::holds_alternative<PointLight>(lights[i]))
            continue;
        const auto sample = sample_li(lights[i], receiver(from.at), random);
        if (!sample)
            continue;
        Sampled out{ray_between(from.at.point, sample->point), sample->light};
        const glm::vec3 way = sample->point - from.at.point.position;
        out.area_pdf = probability_of(shared.starts, i) / (4 * kPi * glm::dot(way, way));
        sum += add_sampled(shared, from, out);
    }
    return sum;
}

/// Returns the light that comes by a vertex of a light path.
Rgb joined_light(const Shared& shared, const Vertex& eye, const Vertex& light)
{
    const glm::vec3 way = light.at.point.position - eye.at.point.position;
    const float distance2 = glm::dot(way, way);
    if (!(distance2 > 0))
        return Rgb(0);
    const glm::vec3 direction = way / std::sqrt(distance2);
    const SpreadValue here = spread_value(shared.scene, eye.at, eye.ways, eye.hit, direction);
    if (is_black(here.value))
        return Rgb(0);
    const SpreadValue there =
        spread_value(shared.scene, light.at, light.ways, light.hit, -direction);
    const Rgb sent = eye.carried * here.value * there.value * light.carried *
                     (particle_factor(light.at, -direction) / distance2);
    if (is_black(sent) || shared.scene.rays.occluded(ray_between(eye.at.point, light.at.point)))
        return Rgb(0);
    const float by_light = here.pdf * cosine_to(light.at, direction) / distance2 *
                           (light.weights.here + light.weights.before * there.reverse);
    const float by_eye = there.pdf * cosine_to(eye.at, direction) / distance2 *
                         (eye.weights.here + eye.weights.before * here.reverse);
    return sent / (1 + by_light + by_eye);
}

/// Adds the light that a vertex of a light path sends straight to the camera.
void add_to_image(const Shared& shared, const Vertex& light, Image& image)
{
    const std::optional<Projected> seen = project(*shared.camera, light.at.point.position);
    if (!seen)
        return;
    const Ray shadow = ray_between(light.at.point, shared.camera->camera->position);
    const glm::vec3& direction = shadow.direction;
    const SpreadValue found =
        spread_value(shared.scene, light.at, light.ways, light.hit, direction);
    if (is_black(found.value) || shared.scene.rays.occluded(shadow))
        return;
    const float paths = shared.light_paths();
    const float across =
        pixel_pdf(*shared.camera, seen->cosine) / (seen->distance * seen->distance);
    const float by_eye = across * cosine_to(light.at, direction) / paths *
                         (light.weights.here + light.weights.before * found.reverse);
    const Rgb sent = light.carried * found.value *
                     (particle_factor(light.at, direction) * across / paths / (1 + by_eye));
    if (is_finite(sent))
        image.at(seen->x, seen->y) += sent;
}

/// Returns what an eye path brings back, with the light path that it has.
Rgb trace_eye(const Shared& shared, const Ray& ray, const std::vector<Vertex>& light,
              RandomSequence& random)
{
    SubPath path;
    path.ray = ray;
    if (shared.camera) {
        const float cosine = glm::dot(ray.direction, shared.camera->camera->forward);
        path.weights.here = shared.light_paths() / pixel_pdf(*shared.camera, cosine);
    }
    Rgb radiance(0.0f);
    std::optional<LightReceiver> source;
    while (survives(path, random)) {
        const std::optional<Vertex> vertex = reach_vertex(shared.scene, random, path);
        if (!vertex)
            break;
        radiance += met_light(shared, *vertex, source);
        source = receiver(vertex->at);
        if (vertex->ways.spread() > 0) {
            radiance += face_light(shared, *vertex, random) + point_light(shared, *vertex, random);
            for (const Vertex& of_light : light)
                radiance += joined_light(shared, *vertex, of_light);
        }
        if (!leave_vertex(shared.scene, *vertex, random, path))
            break;
    }
    return radiance;
}

/// Traces both paths of a sample; the image is that of light paths.
Rgb trace_sample(const Shared& shared, const Ray& ray, RandomSequence& random, Image& image)
{
    const std::vector<Vertex> light = trace_light(shared, random);
    if (shared.camera)
        for (const Vertex& vertex : light)
            add_to_image(shared, vertex, image);
    return trace_eye(shared, ray, light, random);
}

/// Throws InputError for what this method does not know.
void check_scene(const RenderScene& scene)
{
    if (scene.has_media() || scene.opacity || !scene.mesh().copies.empty())
        throw InputError("the scene has media, transparent faces or copies of a mesh, which "
                         "bidirectional path tracing here does not know: use another method");
}

} // namespace

RivalImage render_bidirectional(const RenderScene& scene, const RivalSettings& settings)
{
    check_scene(scene);
    RivalImage out;
    const Stopwatch rendering;
    const Shared shared{scene, settings, plan_starts(scene), pinhole_of(scene, settings)};
    out.image = Image(settings.width, settings.height);
    std::vector<Image> light_images(kBands, out.image);
    tbb::parallel_for(0, kBands, [&](int band) {
        Image& light_image = light_images[static_cast<std::size_t>(band)];
        for (int y = settings.height * band / kBands; y < settings.height * (band + 1) / kBands;
             ++y)
            render_row(
                scene, settings, y,
                [&](const Ray& ray, RandomSequence& random) {
                    return trace_sample(shared, ray, random, light_image);
                },
                out.image);
    });
    for (const Image& light_image : light_images)
        for (std::size_t i = 0; i < out.image.pixels.size(); ++i)
            out.image.pixels[i] += light_image.pixels[i] / static_cast<float>(settings.samples);
    out.rendered.add(rendering);
    out.stored = light_images.size() * out.image.pixels.size() * sizeof(Rgb);
    return out;
}

} // namespace hipmap
