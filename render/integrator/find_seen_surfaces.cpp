#include "render/integrator/find_seen_surfaces.h"

#include "render/paths/direct_light.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace hipmap {

namespace {

/// A region has as many importons as that, and as that part of all.
constexpr std::size_t kFewest = 16;
constexpr std::size_t kMostRegions = 256;

/// The part of a region's points at each end of an axis that its box leaves out.
constexpr std::size_t kOutermost = 16;

/// The part of all weight that the least sides hold together.
constexpr double kRare = 0.05;

/// Units that a photon of mean power and worth counts.
constexpr double kUnits = 0x1p20;

/// Points at which each light is sampled, at most.
constexpr std::size_t kLightSamples = 256;

struct Point {
    std::uint64_t side = 0; ///< SeenRegions::side_of
    glm::vec3 position{0.0f};
    FaceId face = kNone;
    double weight = 0;
};

using Points = std::span<Point>;

double weight_of(Points points)
{
    double sum = 0;
    for (const Point& point : points)
        sum += point.weight;
    return sum;
}

/// Returns the box of points without the outermost along each axis, which a few eye rays may have
/// reached by luck.
Bounds<glm::vec3> box_of(Points points)
{
    const std::size_t cut = points.size() / kOutermost;
    std::vector<float> along(points.size());
    Bounds<glm::vec3> out;
    for (int axis = 0; axis < 3; ++axis) {
        std::ranges::transform(points, along.begin(),
                               [&](const Point& point) { return point.position[axis]; });
        std::ranges::sort(along);
        out.low[axis] = along[cut];
        out.high[axis] = along[along.size() - 1 - cut];
    }
    return out;
}

/// Builds the regions of sides of maps.
class RegionBuilder {
  public:
    RegionBuilder(const MapSurfaces& surfaces, std::size_t all)
        : surfaces_(surfaces), fewest_(std::max(kFewest, all / kMostRegions))
    {
    }

    void add_side(Points points)
    {
        out_.sides.push_back(points.front().side);
        out_.roots.push_back(static_cast<std::uint32_t>(out_.nodes.size()));
        build(points, points.size());
    }

    SeenRegions take()
    {
        out_.mean_worth = weight_ > 0 ? weighted_ / weight_ : 0;
        return std::move(out_);
    }

  private:
    /// all: points of the side.
    void build(Points points, std::size_t all)
    {
        const std::size_t here = out_.nodes.size();
        out_.nodes.push_back({});
        if (points.size() < 2 * fewest_) {
            out_.nodes[here].next = static_cast<std::uint32_t>(out_.regions.size());
            add_region(points, all);
            return;
        }
        const glm::vec3 extent = box_of(points).extent();
        const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0
                         : extent.y >= extent.z                       ? 1
                                                                      : 2;
        const std::size_t half = points.size() / 2;
        std::nth_element(
            points.begin(), points.begin() + static_cast<std::ptrdiff_t>(half), points.end(),
            [&](const Point& a, const Point& b) { return a.position[axis] < b.position[axis]; });
        out_.nodes[here].split = points[half].position[axis];
        out_.nodes[here].axis = static_cast<std::uint32_t>(axis);
        build(points.first(half), all);
        out_.nodes[here].next = static_cast<std::uint32_t>(out_.nodes.size());
        build(points.subspan(half), all);
    }

    /// all: points of the side.  Few points say where they are too coarsely: the whole side counts.
    void add_region(Points points, std::size_t all)
    {
        const auto count = static_cast<double>(points.size());
        const double weight = weight_of(points);
        const double side = surfaces_.area_at(points.front().face);
        double area = side * count / static_cast<double>(all);
        SeenRegion region{.box = {glm::vec3(-kEndless), glm::vec3(kEndless)}};
        if (points.size() >= kFewest) {
            const Bounds<glm::vec3> box = box_of(points);
            const glm::dvec3 sides(box.extent());
            const glm::vec3 margin(surfaces_.partition.position_error);
            region.box = {box.low - margin, box.high + margin};
            const double seen = std::max({sides.x * sides.y, sides.y * sides.z, sides.z * sides.x});
            if (seen > 0)
                area = std::min(seen, side);
        }
        region.worth = area > 0 ? static_cast<float>(weight / area) : 0;
        out_.regions.push_back(region);
        weight_ += weight;
        weighted_ += weight * double{region.worth};
    }

    static constexpr float kEndless = std::numeric_limits<float>::infinity();

    const MapSurfaces& surfaces_;
    const std::size_t fewest_;
    SeenRegions out_;
    double weight_ = 0, weighted_ = 0;
};

void append(std::vector<Point>& to, const Partition& partition, const std::vector<Photon>& from)
{
    for (const Photon& importon : from) {
        const MapId map = importon.face == kNone ? kNone : partition.map_of(importon.face);
        const Rgb& weight = importon.power;
        if (map != kNone)
            to.push_back({SeenRegions::side_of(map, importon.side), importon.position,
                          importon.face,
                          (double{weight.x} + double{weight.y} + double{weight.z}) / 3});
    }
}

/// Returns the points of each side, without the sides that hold the least weight, kRare of all:
/// eye rays reached them by luck, as through a keyhole.
std::vector<Points> split_by_side(std::vector<Point>& points)
{
    std::ranges::stable_sort(points, {}, &Point::side);
    std::vector<Points> sides;
    for (std::size_t begin = 0; begin < points.size();) {
        std::size_t end = begin + 1;
        while (end < points.size() && points[end].side == points[begin].side)
            ++end;
        sides.push_back(Points(points).subspan(begin, end - begin));
        begin = end;
    }
    std::ranges::stable_sort(sides, {}, weight_of);
    double rare = kRare * weight_of(points);
    const auto kept =
        std::ranges::find_if(sides, [&](Points side) { return (rare -= weight_of(side)) < 0; });
    sides.erase(sides.begin(), kept);
    std::ranges::sort(sides, {}, [](Points side) { return side.front().side; });
    return sides;
}

SeenRegions find_regions(const MapSurfaces& surfaces, std::vector<Point> points)
{
    RegionBuilder builder(surfaces, points.size());
    for (const Points side : split_by_side(points))
        builder.add_side(side);
    return builder.take();
}

/// Returns whether a sample of a light reaches a point that the image sees.
bool reaches(const RenderScene& scene, const Light& light, const Photon& at, RandomSequence random)
{
    const std::optional<LightSample> sample = sample_li(light, {at.position, at.direction}, random);
    if (!sample || !(max_channel(sample->light) > 0))
        return false;
    const glm::vec3 error(scene.partition.position_error);
    const Ray ray = shadow_ray({at.face, at.position, error, at.direction, at.direction}, *sample);
    return glm::dot(ray.direction, at.direction) > 0 && !scene.rays.occluded(ray);
}

/// Returns the lights of which some sample reaches some of the points.
std::vector<std::uint8_t> find_reached(const RenderScene& scene, const std::vector<Photon>& points,
                                       std::uint64_t seed)
{
    const std::vector<Light>& lights = scene.lights.lights;
    std::vector<std::uint8_t> out(lights.size());
    const std::size_t step = points.size() / kLightSamples + 1;
    tbb::parallel_for(std::size_t{0}, lights.size(), [&](std::size_t i) {
        for (std::size_t at = i % step; at < points.size() && out[i] == 0; at += step)
            out[i] = reaches(scene, lights[i], points[at],
                             RandomSequence(seed, RandomStream::reached_lights, i, at));
    });
    return out;
}

double mean_power(const LightSet& lights, const PhotonOptions& photons)
{
    double sum = 0;
    for (const Light& light : lights.lights)
        sum += path_power(light);
    return photons.paths > 0 ? sum / static_cast<double>(photons.paths) : 0;
}

} // namespace

SeenSurfaces find_seen_surfaces(const MappedScene& mapped, const Importons& importons,
                                const PhotonOptions& photons)
{
    const Partition& partition = mapped.scene.partition;
    std::vector<Point> caustic, global;
    if (photons.light.caustic)
        append(caustic, partition, importons.caustic);
    if (photons.light.indirect) {
        append(global, partition, importons.global);
        append(global, partition, importons.indirect);
    }
    SeenSurfaces out{mapped.scene.mesh(), partition, find_regions(mapped.surfaces, caustic),
                     find_regions(mapped.surfaces, global), importons.light};
    out.unit = mean_power(mapped.scene.lights, photons) *
               std::max(out.caustic.mean_worth, out.global.mean_worth) / kUnits;
    if (!photons.light.indirect) // no photon shows the light that falls directly on surfaces
        out.reached = find_reached(mapped.scene, importons.caustic, photons.seed);
    return out;
}

} // namespace hipmap
