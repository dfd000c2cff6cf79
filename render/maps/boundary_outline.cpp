#include "render/maps/boundary_outline.h"

#include "common/math/frame.h"
#include "render/maps/own_fold.h"
#include "render/maps/plane_directions.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <tuple>

namespace hipmap {

namespace {

/// Half the width over the distance of a bounding box that one segment may stand for: at first,
/// and what each part that was looked at adds, so that dense boundaries are seen ever more coarsely
/// rather than within a smaller radius.
constexpr double kCoarseWidth = 0.1, kCoarseGrowth = 0.01;

constexpr int kSectors = 64;

/// Direction as a number of sectors from +x counter-clockwise, from 0 to kSectors.
double sector_of(const glm::dvec2& p)
{
    return direction_key(p) * (kSectors / 4);
}

/// A direction on the border between sectors.
glm::dvec2 border_direction(int sector)
{
    const double key = 4.0 * (sector % kSectors) / kSectors;
    const double x = key < 2 ? 1 - key : key - 3;
    const double y = key < 1 ? key : key < 3 ? 2 - key : key - 4;
    return {x, y};
}

/// Directions from `from` counter-clockwise to `to`, less than half a turn, in sectors.
struct SectorRange {
    double from, to;

    SectorRange(const glm::dvec2& first, const glm::dvec2& last)
        : from(sector_of(first)), to(sector_of(last))
    {
        if (to < from)
            to += kSectors;
    }
};

/// A bounding box in the plane, along the direction of its centre.
struct BoxView {
    glm::dvec2 toward; ///< unit
    double front;      ///< the nearest of it; at or below 0: it may surround the point
    double side;       ///< half its width
    bool off_fold;     ///< all of it
};

class Outliner {
  public:
    Outliner(const MapBoundaries& boundaries, const OutlineQuery& query, OutlineScratch& scratch,
             std::vector<BoundarySegment>& out)
        : boundaries_(boundaries), segments_(boundaries.of(query.map)), query_(query),
          scratch_(scratch), out_(out), fold_(query.radius), x_(Frame(query.normal).x),
          y_(Frame(query.normal).y)
    {
        scratch_.open.clear();
        scratch_.hidden2.fill(std::numeric_limits<double>::infinity());
    }

    float look()
    {
        const double radius2 = double(query_.radius) * query_.radius;
        push(boundaries_.root(query_.map), 0, static_cast<std::uint32_t>(segments_.size()));
        for (parts_ = 0; !scratch_.open.empty();) {
            const OutlineScratch::Part part = pop();
            if (part.distance2 >= radius2)
                break;
            if (parts_ == kMostParts || out_.size() == kMostSegments)
                return distance_below(part.distance2);
            parts_ += part.distance2 > 0 ? 1 : 0; // boxes around the point have to be opened
            if (part.node == kNone)
                add_segment(segments_[part.begin]);
            else
                look_at(part);
        }
        return query_.radius;
    }

  private:
    using Part = OutlineScratch::Part;

    static bool is_farther(const Part& l, const Part& r)
    {
        return std::tuple(l.distance2, l.begin, l.end) > std::tuple(r.distance2, r.begin, r.end);
    }

    static float distance_below(double distance2)
    {
        return std::nextafter(static_cast<float>(std::sqrt(distance2)), 0.0f);
    }

    void push(std::uint32_t node, std::uint32_t begin, std::uint32_t end)
    {
        const MapBoundaries::Node& box = boundaries_.node(node);
        push({distance2_to_box(query_.point, box.low, box.high), begin, end, node});
    }

    void push(const Part& part)
    {
        scratch_.open.push_back(part);
        std::push_heap(scratch_.open.begin(), scratch_.open.end(), is_farther);
    }

    Part pop()
    {
        std::pop_heap(scratch_.open.begin(), scratch_.open.end(), is_farther);
        const Part part = scratch_.open.back();
        scratch_.open.pop_back();
        return part;
    }

    void look_at(const Part& part)
    {
        const BoxView box = view_of(boundaries_.node(part.node));
        if (box.off_fold || (box.front > 0 && is_hidden(box)))
            return;
        if (box.front > 0 && box.side <= coarse_width() * box.front)
            return add_in_front_of(box);
        if (part.end - part.begin > MapBoundaries::kLeafSize) {
            const std::uint32_t middle = part.begin + (part.end - part.begin) / 2;
            push(part.node + 1, part.begin, middle);
            push(boundaries_.node(part.node).right, middle, part.end);
            return;
        }
        for (std::uint32_t i = part.begin; i < part.end; ++i)
            push({distance2_to_segment(query_.point, segments_[i]), i, i + 1, kNone});
    }

    double coarse_width() const
    {
        return kCoarseWidth + kCoarseGrowth * static_cast<double>(parts_);
    }

    PlanePoint project(const glm::vec3& point) const
    {
        const glm::dvec3 off = glm::dvec3(point) - glm::dvec3(query_.point);
        return {{glm::dot(off, x_), glm::dot(off, y_)}, glm::dot(off, glm::dvec3(query_.normal))};
    }

    BoxView view_of(const MapBoundaries::Node& box) const
    {
        const glm::dvec3 half = (glm::dvec3(box.high) - glm::dvec3(box.low)) * 0.5;
        const glm::dvec3 off = glm::dvec3(box.low) + half - glm::dvec3(query_.point);
        const glm::dvec2 centre(glm::dot(off, x_), glm::dot(off, y_));
        const double distance = glm::length(centre);
        const glm::dvec3 normal(query_.normal);
        const double lowest = std::abs(glm::dot(off, normal)) - glm::dot(half, glm::abs(normal));
        const bool off_fold =
            lowest > 0 && !fold_.contains({distance + glm::length(half), 0}, lowest);
        if (!(distance > 0))
            return {{1, 0}, 0, 0, off_fold};
        const glm::dvec2 toward = centre / distance;
        const glm::dvec3 along = toward.x * x_ + toward.y * y_;
        const glm::dvec3 across = toward.x * y_ - toward.y * x_;
        return {toward, distance - glm::dot(half, glm::abs(along)),
                glm::dot(half, glm::abs(across)), off_fold};
    }

    bool is_hidden(const BoxView& box) const
    {
        const glm::dvec2 middle = box.front * box.toward;
        const glm::dvec2 side = box.side * glm::dvec2(-box.toward.y, box.toward.x);
        return is_hidden(SectorRange(middle - side, middle + side), box.front * box.front);
    }

    bool is_hidden(const SectorRange& range, double distance2) const
    {
        for (int sector = static_cast<int>(range.from); sector <= range.to; ++sector)
            if (scratch_.hidden2[static_cast<std::size_t>(sector % kSectors)] > distance2)
                return false;
        return true;
    }

    void add_segment(const BoundarySegment& segment)
    {
        const PlanePoint ends[2] = {project(segment.a), project(segment.b)};
        const SegmentParts parts = parts_on_fold(fold_, ends[0], ends[1]);
        if (parts.count == 0)
            return;
        glm::dvec2 a = ends[0].at, b = ends[1].at;
        if (cross(a, b) < 0)
            std::swap(a, b);
        if (cross(a, b) > 0) {
            const SectorRange range(a, b);
            if (is_hidden(range, distance2(a, b)))
                return;
            if (parts.whole())
                hide_beyond(a, b, range);
        }
        out_.push_back(segment);
    }

    void add_in_front_of(const BoxView& box)
    {
        const glm::dvec2 middle = box.front * box.toward;
        const glm::dvec2 side = box.side * glm::dvec2(-box.toward.y, box.toward.x);
        const glm::dvec2 a = middle - side, b = middle + side;
        if (cross(a, b) > 0)
            hide_beyond(a, b, {a, b});
        const auto in_space = [&](const glm::dvec2& p) {
            return glm::vec3(glm::dvec3(query_.point) + p.x * x_ + p.y * y_);
        };
        out_.push_back({in_space(a), in_space(b)});
    }

    /// In the sectors that lie wholly within the directions of a segment from a to b.
    void hide_beyond(const glm::dvec2& a, const glm::dvec2& b, const SectorRange& range)
    {
        const double turn = cross(a, b);
        const auto border_distance2 = [&](int border) {
            const glm::dvec2 direction = border_direction(border);
            const double t = turn / cross(direction, b - a);
            return t * t * glm::dot(direction, direction);
        };
        int sector = static_cast<int>(std::ceil(range.from));
        double from = sector + 1 <= range.to ? border_distance2(sector) : 0.0;
        for (; sector + 1 <= range.to; ++sector) {
            const double to = border_distance2(sector + 1);
            double& hidden2 = scratch_.hidden2[static_cast<std::size_t>(sector % kSectors)];
            hidden2 = std::min(hidden2, std::max(from, to));
            from = to;
        }
    }

    const MapBoundaries& boundaries_;
    const std::span<const BoundarySegment> segments_;
    const OutlineQuery& query_;
    OutlineScratch& scratch_;
    std::vector<BoundarySegment>& out_;
    const OwnFold fold_;
    const glm::dvec3 x_, y_; ///< axes of the plane
    std::size_t parts_ = 0;  ///< looked at
};

} // namespace

float outline_boundary(const MapBoundaries& boundaries, const OutlineQuery& query,
                       OutlineScratch& scratch, std::vector<BoundarySegment>& out)
{
    assert(query.radius > 0 && std::isfinite(query.radius));
    out.clear();
    if (boundaries.near(query.map, query.point, query.radius, out, kExactSegments))
        return query.radius;
    out.clear();
    return Outliner(boundaries, query, scratch, out).look();
}

} // namespace hipmap
