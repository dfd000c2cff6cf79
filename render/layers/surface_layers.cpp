#include "render/layers/surface_layers.h"

#include "common/math/random.h"
#include "common/math/sampling.h"
#include "render/integrator/pixel_samples.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace hipmap {

namespace {

constexpr std::uint64_t kMeanSamples = 16; ///< rays of a pixel for layers that average

/// Faces without a surface, which only bound a medium, are crossed.
std::optional<RayHit> first_face(const RenderScene& scene, const Ray& ray)
{
    if (!scene.has_media())
        return scene.rays.nearest(ray);
    MediumStack inside = medium_stack_at(*scene.media, ray.origin);
    return walk(*scene.media, ray, inside, [](const MediumSegment&) { return true; }).hit;
}

std::optional<FirstSurface> first_surface_of(const RenderScene& scene, const Ray& ray)
{
    const std::optional<RayHit> hit = first_face(scene, ray);
    if (!hit)
        return std::nullopt;
    return FirstSurface{scene, interact(scene, ray, *hit)};
}

/// Returns where a sample that counts in a pixel lies along an axis, in pixels from its middle: by
/// the inverse of the filter's cumulative distribution at `u`, which is uniform in [0, 1).
float filtered_offset(PixelFilter filter, float u)
{
    if (filter == PixelFilter::box)
        return u - 0.5f;
    if (u < 1.0f / 6)
        return std::cbrt(6 * u) - 1.5f;
    if (u > 5.0f / 6)
        return 1.5f - std::cbrt(6 * (1 - u));
    // 1/2 + 3/4 x - x^3/3 = u by the sine of three times an angle
    const float root = std::sqrt(3.0f);
    return root * std::sin(std::asin((u - 0.5f) * 4 / root) / 3);
}

/// A frame seen by rays through its pixels.
struct View {
    const RenderScene& scene;
    const RenderOptions& options;

    /// Returns the surface behind a point of the image, in pixels, and of the lens.
    std::optional<FirstSurface> at(const glm::vec2& point, const glm::vec2& lens) const
    {
        return first_surface_of(scene, image_ray(scene, options, point, lens));
    }

    /// Returns the surface behind a point drawn from the pixel's filter: filter importance
    /// sampling, Ernst, Stamminger and Greiner 2006.
    std::optional<FirstSurface> drawn(int x, int y, RandomSequence random) const
    {
        const glm::vec2 u = random.next2();
        const glm::vec2 lens = sample_disc(random.next2());
        const glm::vec2 middle = glm::vec2(x, y) + 0.5f;
        return at(middle + glm::vec2(filtered_offset(options.filter, u.x),
                                     filtered_offset(options.filter, u.y)),
                  lens);
    }
};

/// The values of one rendered pixel in a layer.
float* values_of(LayerImage& layer, std::size_t pixel)
{
    return layer.values.data() + pixel * layer.row->channels.size();
}

/// The index of a pixel of the whole image among those rendered.
std::size_t place_of(const RenderOptions& options, int x, int y)
{
    const PixelRect pixels = rendered_pixels(options);
    return static_cast<std::size_t>(y - pixels.y0) * pixels.width() + (x - pixels.x0);
}

void store(const glm::vec4& value, std::size_t pixel, LayerImage& layer)
{
    for (std::size_t c = 0; c < layer.row->channels.size(); ++c)
        values_of(layer, pixel)[c] = value[static_cast<int>(c)];
}

void fill_centre(const View& view, int x, int y, std::span<LayerImage> layers)
{
    const std::optional<FirstSurface> seen = view.at(glm::vec2(x, y) + 0.5f, glm::vec2(0.0f));
    const std::size_t pixel = place_of(view.options, x, y);
    for (LayerImage& layer : layers)
        if (const auto* of = std::get_if<OfCentre>(&layer.row->read))
            store(seen ? of->read(*seen) : glm::vec4(of->nothing), pixel, layer);
}

void fill_mean(const View& view, int x, int y, std::span<LayerImage> layers)
{
    const auto of_whole = static_cast<std::size_t>(y) * view.options.width + x;
    const std::size_t pixel = place_of(view.options, x, y);
    for (std::uint64_t s = 0; s < kMeanSamples; ++s) {
        const std::optional<FirstSurface> seen =
            view.drawn(x, y, {view.options.seed, RandomStream::pictures, 0, of_whole, s});
        if (!seen)
            continue;
        for (LayerImage& layer : layers)
            if (const auto* of = std::get_if<OfMean>(&layer.row->read)) {
                const glm::vec4 share = of->read(*seen) / static_cast<float>(kMeanSamples);
                for (std::size_t c = 0; c < layer.row->channels.size(); ++c)
                    values_of(layer, pixel)[c] += share[static_cast<int>(c)];
            }
    }
}

template <typename Reader>
bool any_is(std::span<const LayerImage> layers)
{
    return std::ranges::any_of(layers, [](const LayerImage& layer) {
        return std::holds_alternative<Reader>(layer.row->read);
    });
}

} // namespace

std::vector<LayerImage> surface_layers(const RenderScene& scene, const RenderOptions& options,
                                       std::span<const LayerRow* const> layers)
{
    const PixelRect part = rendered_pixels(options);
    const auto pixels = static_cast<std::size_t>(part.width()) * part.height();
    std::vector<LayerImage> out;
    for (const LayerRow* row : layers)
        if (!std::holds_alternative<OfFilm>(row->read))
            out.push_back({row, std::vector<float>(pixels * row->channels.size())});
    const bool centre = any_is<OfCentre>(out), mean = any_is<OfMean>(out);
    const View view{scene, options};
    tbb::parallel_for(part.y0, out.empty() ? part.y0 : part.y1, [&](int y) {
        for (int x = part.x0; x < part.x1; ++x) {
            if (centre)
                fill_centre(view, x, y, out);
            if (mean)
                fill_mean(view, x, y, out);
        }
    });
    return out;
}

} // namespace hipmap
