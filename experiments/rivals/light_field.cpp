#include "experiments/rivals/light_field.h"

#include "common/input_error.h"
#include "experiments/rivals/pinhole.h"
#include "experiments/rivals/pixels.h"
#include "render/integrator/path_tracer.h"

#include <algorithm>

namespace hipmap {

namespace {

constexpr int kProbes = 16; // rays along each side of the image that find the depth of the scene

/// The window of the cameras, and a rectangle in a plane parallel to it that all of them see; both
/// are centred on the axis of view, but for the camera's shift.
struct TwoPlanes {
    const Camera* camera;        ///< borrowed
    int views = 1;               ///< of the window, along each side
    glm::ivec2 points{1};        ///< of the rectangle
    glm::vec2 half_window{0.0f}; ///< scene units
    float depth = 1.0f;          ///< of the rectangle, along the axis of view
    glm::vec2 centre{0.0f};      ///< of the rectangle: right and up of the axis, scene units
    glm::vec2 half_size{0.0f};   ///< of the rectangle, scene units
};

/// Harmonic mean of the depths that the image shows; 1 where it shows nothing.
float mean_depth(const RenderScene& scene, const RivalSettings& settings)
{
    double nearness = 0;
    int found = 0;
    for (int y = 0; y < kProbes; ++y)
        for (int x = 0; x < kProbes; ++x) {
            const glm::vec2 at = (glm::vec2(x, y) + 0.5f) / static_cast<float>(kProbes);
            const Ray ray =
                ray_through(scene, settings, at * glm::vec2(settings.width, settings.height));
            if (const std::optional<RayHit> hit = scene.rays.nearest(ray)) {
                const Camera& camera = scene.scene.cameras[scene.scene.camera];
                nearness += 1 / (hit->distance * glm::dot(ray.direction, camera.forward));
                ++found;
            }
        }
    return found > 0 ? static_cast<float>(found / nearness) : 1.0f;
}

TwoPlanes two_planes(const RenderScene& scene, const RivalSettings& settings)
{
    const std::optional<Pinhole> pinhole = pinhole_of(scene, settings);
    if (!pinhole)
        throw InputError("a light field here needs a camera with a perspective and no lens");
    TwoPlanes out;
    out.camera = pinhole->camera;
    out.views = std::max(2, settings.views);
    out.points = {settings.width, settings.height};
    out.half_window = glm::vec2(settings.window / 2);
    out.depth = mean_depth(scene, settings);
    const float half = out.depth * pinhole->half_height;
    out.centre = 2 * half * out.camera->shift;
    out.half_size = half * glm::vec2(pinhole->size.x / pinhole->size.y, 1);
    return out;
}

/// Returns a ray from a point of the window to one of the rectangle; both in [-1, 1]^2, right and
/// up.
Ray ray_between_planes(const TwoPlanes& planes, const glm::vec2& window, const glm::vec2& rectangle)
{
    const Camera& camera = *planes.camera;
    const glm::vec2 from = window * planes.half_window;
    const glm::vec2 to = planes.centre + rectangle * planes.half_size;
    Ray out;
    out.origin = camera.position + from.x * camera.right + from.y * camera.up;
    out.direction = glm::normalize(planes.depth * camera.forward + (to - from).x * camera.right +
                                   (to - from).y * camera.up);
    return out;
}

/// Returns the middle of a sample of a grid in [-1, 1].
float middle_of(int place, int count)
{
    return (2 * static_cast<float>(place) + 1) / static_cast<float>(count) - 1;
}

/// Returns the radiance of all samples: [views views height width].
std::vector<Rgb> record(const RenderScene& scene, const RivalSettings& settings,
                        const TwoPlanes& planes)
{
    const int views = planes.views * planes.views;
    const auto pixels = static_cast<std::size_t>(planes.points.x) * planes.points.y;
    std::vector<Rgb> out(static_cast<std::size_t>(views) * pixels);
    tbb::parallel_for(0, views * planes.points.y, [&](int row) {
        const int view = row / planes.points.y, t = row % planes.points.y;
        const glm::vec2 window(middle_of(view % planes.views, planes.views),
                               middle_of(view / planes.views, planes.views));
        for (int s = 0; s < planes.points.x; ++s) {
            const std::size_t at = static_cast<std::size_t>(row) * planes.points.x + s;
            for (int i = 0; i < settings.samples; ++i) {
                RandomSequence random(settings.seed, RandomStream::pictures, 0, at,
                                      static_cast<std::uint64_t>(i));
                const glm::vec2 point =
                    2.0f * (glm::vec2(s, t) + random.next2()) / glm::vec2(planes.points) - 1.0f;
                const Ray ray = ray_between_planes(planes, window, point);
                const Rgb found = trace_path(scene, ray, random);
                if (is_finite(found))
                    out[at] += found / static_cast<float>(settings.samples);
            }
        }
    });
    return out;
}

/// The two samples of a grid about a place, and the weight of the second.
struct Between {
    int low = 0, high = 0;
    float weight = 0.0f;
};

/// place: in [-1, 1]; beyond the outermost samples it takes these.
Between between(float place, int count)
{
    const float at = std::clamp((place + 1) / 2 * static_cast<float>(count) - 0.5f, 0.0f,
                                static_cast<float>(count - 1));
    Between out;
    out.low = static_cast<int>(at);
    out.high = std::min(out.low + 1, count - 1);
    out.weight = at - static_cast<float>(out.low);
    return out;
}

/// Interpolates in all four coordinates.
Rgb resample(const TwoPlanes& planes, const std::vector<Rgb>& field, const glm::vec2& window,
             const glm::vec2& rectangle)
{
    const std::array<Between, 4> at{
        between(window.y, planes.views), between(window.x, planes.views),
        between(rectangle.y, planes.points.y), between(rectangle.x, planes.points.x)};
    const std::array<int, 4> counts{planes.views, planes.views, planes.points.y, planes.points.x};
    Rgb sum(0.0f);
    for (unsigned corner = 0; corner < 16; ++corner) {
        float weight = 1;
        std::size_t index = 0;
        for (unsigned axis = 0; axis < 4; ++axis) {
            const bool high = (corner >> axis & 1) != 0;
            weight *= high ? at[axis].weight : 1 - at[axis].weight;
            index = index * static_cast<std::size_t>(counts[axis]) +
                    static_cast<std::size_t>(high ? at[axis].high : at[axis].low);
        }
        if (weight > 0)
            sum += weight * field[index];
    }
    return sum;
}

} // namespace

RivalImage render_light_field(const RenderScene& scene, const RivalSettings& settings)
{
    RivalImage out;
    const Stopwatch preparing;
    const TwoPlanes planes = two_planes(scene, settings);
    const std::vector<Rgb> field = record(scene, settings, planes);
    out.prepared.add(preparing);
    out.stored = field.size() * sizeof(Rgb);
    const Stopwatch rendering;
    out.image = Image(settings.width, settings.height);
    for (int y = 0; y < settings.height; ++y)
        for (int x = 0; x < settings.width; ++x)
            out.image.at(x, settings.height - 1 - y) =
                resample(planes, field, glm::vec2(0),
                         {middle_of(x, settings.width), middle_of(y, settings.height)});
    out.rendered.add(rendering);
    return out;
}

} // namespace hipmap
