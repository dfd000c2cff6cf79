#include "render/integrator/shared_gathers.h"

#include "render/shading/scatter.h"

#include <cmath>

namespace hipmap {

namespace {

/// Cosine between directions in which surfaces send about the same light.
constexpr float kLikeWays = 0.99f;

/// From a start to an end: all zero where it is not seen.
struct Way {
    glm::vec3 direction{0.0f};
    Rgb factor{0.0f}; ///< of the radiance that arrives, for each unit of area at the end
    float pdf = 0;    ///< of the start's ray, for each unit of area
    float distance2 = 0;
};

/// The starts that share, and memory to work in.
struct Group {
    const RenderScene& scene;
    const GatherScale& scale;
    std::span<const GatherStart* const> starts{};
    std::vector<Way> ways{}; ///< from them to one end
};

bool is_seen(const RenderScene& scene, const GatherStart& start, const GatherStart& of)
{
    // The ray itself may have crossed faces of media.
    if (&start == &of && !scene.has_media())
        return true;
    return !scene.rays.occluded(ray_between(start.at.point, of.end->point));
}

/// Returns the way from a start to the end of the ray of another, or of its own.
Way way_between(const RenderScene& scene, const GatherScale& scale, const GatherStart& start,
                const GatherStart& of)
{
    const GatherEnd& end = *of.end;
    Way out;
    const glm::vec3 between = end.point.position - start.at.point.position;
    out.distance2 = glm::dot(between, between);
    const float distance = std::sqrt(out.distance2);
    out.direction = between / distance;
    const float area = -glm::dot(out.direction, end.normal) / out.distance2;
    if (!(area > 0) || (distance < scale.shrink * end.first_global) != end.near)
        return out; // its own ray would not end so
    const Scattered found = scattered(start.at, out.direction, Lobes::gathered);
    const float pdf =
        start.guide == nullptr ? found.pdf : mixed_pdf(*start.guide, found.pdf, out.direction);
    const Rgb factor = start.throughput * found.value;
    if (is_black(factor) || !is_seen(scene, start, of))
        return out;
    out.pdf = area * pdf;
    out.factor = area * factor;
    return out;
}

bool are_alike(const Way& a, const Way& b)
{
    return glm::dot(a.direction, b.direction) > kLikeWays;
}

/// Returns the sum of the pdfs of ways like one.
float pdf_of_all(std::span<const Way> ways, const Way& to, bool separable)
{
    float out = 0;
    for (const Way& way : ways)
        if (separable || are_alike(way, to))
            out += way.pdf;
    return out;
}

/// Adds what the end of one ray brings to all starts of its group.
void share_end(Group& group, const GatherStart& of, std::vector<TracedSample<3>>& samples)
{
    const GatherEnd& end = *of.end;
    group.ways.clear();
    for (const GatherStart* start : group.starts)
        group.ways.push_back(way_between(group.scene, group.scale, *start, of));
    const auto own =
        static_cast<std::size_t>(std::ranges::find(group.starts, &of) - group.starts.begin());
    if (!(group.ways[own].pdf > 0)) // by rounding
        return;
    for (std::size_t i = 0; i < group.starts.size(); ++i) {
        const GatherStart& start = *group.starts[i];
        const Way& way = group.ways[i];
        const bool like = end.separable || are_alike(way, group.ways[own]);
        if (!(way.pdf > 0) || !like)
            continue;
        const auto weight = [&](float first) {
            return gather_weight({first, start.indirect_radius, way.distance2}, group.scale);
        };
        const float global = weight(end.first_global), caustic = weight(end.first_caustic);
        const Rgb factor = way.factor / pdf_of_all(group.ways, way, end.separable);
        RadianceByRadius& to = samples[start.sample].value;
        for (std::size_t radius = 0; radius < to.size(); ++radius)
            to[radius] += factor * (global * end.global[radius] + caustic * end.caustic[radius]);
    }
}

/// Calls use(pixels) with the pixels of each group, in rows.
template <typename Use>
void over_groups(const PixelGroups& groups, const PixelRect& rows, const Use& use)
{
    for (int x = rows.x0; x < rows.x1;) {
        const int end = std::min(groups.begin_x(x) + groups.across, rows.x1);
        use(PixelRect{x, rows.y0, end, rows.y1});
        x = end;
    }
}

/// Calls use(lattice) with each lattice of pixels kApart apart, from its first pixel on.
template <typename Use>
void over_lattices(const PixelRect& pixels, const Use& use)
{
    for (int y = pixels.y0; y < std::min(pixels.y0 + kApart, pixels.y1); ++y)
        for (int x = pixels.x0; x < std::min(pixels.x0 + kApart, pixels.x1); ++x)
            use(PixelRect{x, y, pixels.x1, pixels.y1});
}

/// Calls use(sample) with the sample number `s` of each pixel of a lattice that has so many.
/// Returns whether there is one.
template <typename Use>
bool over_samples(const TracedRows<3>& rows, const PixelRect& lattice, std::size_t s,
                  const Use& use)
{
    bool found = false;
    for (int y = lattice.y0; y < lattice.y1; y += kApart)
        for (int x = lattice.x0; x < lattice.x1; x += kApart) {
            const Part own = rows.samples_of(x, y);
            if (!(s < own.size()))
                continue;
            use(own.begin + s);
            found = true;
        }
    return found;
}

/// Returns the first of the starts of each sample, and the end of all.
std::vector<std::size_t> begins_of(std::span<const GatherStart> starts, std::size_t samples)
{
    std::vector<std::size_t> out(samples + 1, 0);
    for (const GatherStart& start : starts)
        ++out[start.sample + 1];
    for (std::size_t i = 0; i < samples; ++i)
        out[i + 1] += out[i];
    return out;
}

/// Shares the ends of all starts, a few starts at a time.
void share_ends(Group& group, std::span<const GatherStart* const> starts,
                std::vector<TracedSample<3>>& samples)
{
    constexpr std::size_t kMost = kSharing;
    const std::size_t parts = (starts.size() + kMost - 1) / kMost;
    for (std::size_t i = 0; i < parts; ++i) {
        const Part part = part_of(starts.size(), i, parts);
        group.starts = starts.subspan(part.begin, part.size());
        for (const GatherStart* start : group.starts)
            if (start->end)
                share_end(group, *start, samples);
    }
}

} // namespace

void share_gathers(const RenderScene& scene, const GatherScale& scale, const PixelGroups& groups,
                   std::span<const GatherStart> starts, TracedRows<3>& rows)
{
    if (starts.empty())
        return;
    const std::vector<std::size_t> begins = begins_of(starts, rows.samples.size());
    Group group{scene, scale};
    std::vector<const GatherStart*> all;
    const auto append = [&](std::size_t sample) {
        for (std::size_t i = begins[sample]; i < begins[sample + 1]; ++i)
            all.push_back(&starts[i]);
    };
    over_groups(groups, rows.pixels, [&](const PixelRect& pixels) {
        over_lattices(pixels, [&](const PixelRect& lattice) {
            all.clear();
            for (std::size_t s = 0; over_samples(rows, lattice, s, append); ++s)
                ;
            share_ends(group, all, rows.samples);
        });
    });
}

} // namespace hipmap
