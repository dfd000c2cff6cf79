#include "render/maps/fold_areas.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <numbers>

// foreach_target compiles what follows it once for each instruction set.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/maps/fold_areas.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace hipmap::fold_walk::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, kFoldWidth>;
using Vec = hn::Vec<Floats>;
using Mask = hn::Mask<Floats>;

/// What is narrower than this part of a radius counts by its mean distance.
constexpr float kSmall = 0.5f;

HWY_INLINE Vec all(float value)
{
    return hn::Set(Floats(), value);
}

HWY_INLINE Mask none()
{
    return hn::Lt(all(0), all(0));
}

HWY_INLINE unsigned bits_of(Mask mask)
{
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(Floats(), mask, bits);
    return bits[0];
}

// No fused multiply-add anywhere, and sums in one order: the same bits on every processor.

struct Vec3 {
    Vec x, y, z;

    friend HWY_INLINE Vec3 operator-(const Vec3& a, const Vec3& b)
    {
        return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
    }
    friend HWY_INLINE Vec3 operator+(const Vec3& a, const Vec3& b)
    {
        return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
    }
    friend HWY_INLINE Vec3 operator*(const Vec3& a, Vec b)
    {
        return {hn::Mul(a.x, b), hn::Mul(a.y, b), hn::Mul(a.z, b)};
    }
    friend HWY_INLINE Vec3 operator*(const Vec3& a, const Vec3& b)
    {
        return {hn::Mul(a.x, b.x), hn::Mul(a.y, b.y), hn::Mul(a.z, b.z)};
    }
};

HWY_INLINE Vec3 spread(const glm::vec3& value)
{
    return {all(value.x), all(value.y), all(value.z)};
}

HWY_INLINE Vec3 load(const float (&from)[3][kFoldWidth], std::size_t lane)
{
    const Floats d;
    return {hn::Load(d, from[0] + lane), hn::Load(d, from[1] + lane), hn::Load(d, from[2] + lane)};
}

HWY_INLINE Vec total(const Vec3& v)
{
    return hn::Add(hn::Add(v.x, v.y), v.z);
}

HWY_INLINE Vec dot(const Vec3& a, const Vec3& b)
{
    return total(a * b);
}

HWY_INLINE Vec3 cross(const Vec3& a, const Vec3& b)
{
    return Vec3{hn::Mul(a.y, b.z), hn::Mul(a.z, b.x), hn::Mul(a.x, b.y)} -
           Vec3{hn::Mul(a.z, b.y), hn::Mul(a.x, b.z), hn::Mul(a.y, b.x)};
}

HWY_INLINE Vec3 max(const Vec3& a, const Vec3& b)
{
    return {hn::Max(a.x, b.x), hn::Max(a.y, b.y), hn::Max(a.z, b.z)};
}

HWY_INLINE Vec3 min(const Vec3& a, const Vec3& b)
{
    return {hn::Min(a.x, b.x), hn::Min(a.y, b.y), hn::Min(a.z, b.z)};
}

HWY_INLINE Vec widest(const Vec3& v)
{
    return hn::Max(hn::Max(v.x, v.y), v.z);
}

HWY_INLINE Vec ratio(Vec above, Vec below)
{
    return hn::Div(above, hn::Max(below, all(std::numeric_limits<float>::min())));
}

/// Boxes about a query; places from it.
struct Boxes {
    Vec near2, far2; ///< square distances of the nearest and the farthest point
    Vec extent;      ///< the longest side

    HWY_INLINE Boxes(const Vec3& low, const Vec3& high)
    {
        const Vec3 zero{all(0), all(0), all(0)};
        const Vec3 outside = max(max(low, zero - high), zero), corner = max(zero - low, high);
        near2 = dot(outside, outside);
        far2 = dot(corner, corner);
        extent = widest(high - low);
    }
};

/// The distances of small things from a query, taken to be spread evenly.
struct Distances {
    Vec middle, half;

    /// way: to the middle; along, across: variance of the place along the way and across it.
    HWY_INLINE Distances(Vec way, Vec along, Vec across)
        : middle(hn::Add(way, ratio(hn::Mul(across, all(0.5f)), way))),
          half(hn::Sqrt(hn::Mul(along, all(3))))
    {
    }

    /// Returns the parts of their areas within a radius.
    HWY_INLINE Vec part_within(float radius) const
    {
        const Vec beyond = hn::Mul(hn::Sub(all(radius), middle), all(0.5f));
        return hn::Min(hn::Max(hn::Add(all(0.5f), ratio(beyond, half)), all(0)), all(1));
    }
};

HWY_INLINE Distances distances_of(const FoldNode& node, std::size_t lane, const Vec3& way)
{
    const Vec3 turned{hn::Mul(way.y, way.z), hn::Mul(way.z, way.x), hn::Mul(way.x, way.y)};
    const Vec3 variance = load(node.variance, lane);
    const Vec way2 = dot(way, way), every = total(variance);
    const Vec crossed = dot(load(node.covariance, lane), turned);
    const Vec along = ratio(hn::Add(dot(variance, way * way), hn::Add(crossed, crossed)), way2);
    const Vec kept = hn::Min(hn::Max(along, all(0)), every);
    return {hn::Sqrt(way2), kept, hn::Sub(every, kept)};
}

HWY_INLINE Distances distances_of(const std::array<Vec3, 3>& corners)
{
    const Vec3 way = (corners[0] + corners[1] + corners[2]) * all(1.0f / 3);
    const Vec length = hn::Sqrt(dot(way, way));
    Vec along = all(0), every = all(0);
    for (const Vec3& corner : corners) {
        const Vec3 apart = corner - way;
        const Vec part = ratio(dot(apart, way), length);
        along = hn::Add(along, hn::Mul(part, part));
        every = hn::Add(every, dot(apart, apart));
    }
    const Vec each = all(1.0f / 12);
    return {length, hn::Mul(along, each), hn::Mul(hn::Sub(every, along), each)};
}

/// The cosines between some faces' normals and a query's, taken to be spread evenly from the
/// lowest to the highest: those of a cap of directions about their mean, docs/visible_area.md (A9).
struct Slopes {
    Vec mean, lowest, highest;

    HWY_INLINE Slopes(const Vec3& faces, const Vec3& normal)
    {
        const Vec alike = hn::Sqrt(dot(faces, faces)), one = all(1);
        const Vec cap = hn::Max(hn::Sub(hn::Add(alike, alike), one), all(0));
        const Vec spread = hn::Sqrt(hn::Max(hn::Sub(one, hn::Mul(cap, cap)), all(0)));
        mean = dot(faces, normal);
        const Vec middle = ratio(mean, alike);
        lowest = hn::Sub(middle, spread);
        highest = hn::Add(middle, spread);
    }

    /// Returns the parts of the areas that look to the query's side and lie within a radius, of
    /// which the `near` parts do.  away: cosine between the normal and the way to the middle.
    HWY_INLINE Vec part(AreaOf of, Vec near, Vec away) const
    {
        const Vec up = hn::Max(highest, all(0)), zero = all(0), one = all(1);
        const Mask whole = hn::Ge(lowest, zero);
        const Vec facing =
            hn::IfThenElse(whole, one, hn::Min(ratio(up, hn::Sub(highest, lowest)), one));
        const Vec apart = hn::Mul(near, facing);
        const Vec nearest = hn::Min(near, facing);
        const Vec farthest = hn::Max(hn::Sub(hn::Add(near, facing), one), zero);
        const Vec end = hn::IfThenElse(hn::Lt(away, zero), nearest, farthest);
        const Vec both = hn::Add(apart, hn::Mul(hn::Abs(away), hn::Sub(end, apart)));
        if (of == AreaOf::surface)
            return both;
        return hn::Mul(both, hn::IfThenElse(whole, hn::Max(mean, zero), hn::Mul(up, all(0.5f))));
    }
};

/// Returns twice the arc tangents of ratios, of which `below` are >= 0: Abramowitz and Stegun,
/// Handbook of Mathematical Functions, 4.4.49, to 1e-7.
HWY_INLINE Vec double_arc_tangent(Vec above, Vec below)
{
    constexpr std::array<float, 9> kSeries{1.0f,           -0.3333314528f, 0.1999355085f,
                                           -0.1420889944f, 0.1065626393f,  -0.0752896400f,
                                           0.0429096138f,  -0.0161657367f, 0.0028662257f};
    const Vec size = hn::Abs(above);
    const Vec x = ratio(hn::Min(size, below), hn::Max(size, below)), x2 = hn::Mul(x, x);
    Vec sum = all(kSeries.back());
    for (std::size_t i = kSeries.size() - 1; i-- > 0;)
        sum = hn::Add(hn::Mul(sum, x2), all(kSeries[i]));
    const Vec angle = hn::Mul(hn::Add(sum, sum), x);
    const Vec turned = hn::Sub(all(std::numbers::pi_v<float>), angle);
    return hn::CopySign(hn::IfThenElse(hn::Gt(size, below), turned, angle), above);
}

HWY_INLINE Vec3 area_vector(const std::array<Vec3, 3>& corners)
{
    return cross(corners[1] - corners[0], corners[2] - corners[0]) * all(0.5f);
}

/// Faces in their planes, about the feet of a query; docs/visible_area.md (A11).
struct FlatFaces {
    /// An edge from a to b, in the plane.
    struct Edge {
        Vec twice;   ///< twice the area of the triangle with the foot
        Vec from2;   ///< a . a
        Vec towards; ///< a . (b - a)
        Vec length2;
        Vec angle; ///< from a to b as the foot sees them
    };
    Vec3 normal;
    Vec area, height2;
    std::array<Edge, 3> edges;

    HWY_INLINE explicit FlatFaces(const std::array<Vec3, 3>& corners)
    {
        const Vec3 vector = area_vector(corners);
        area = hn::Sqrt(dot(vector, vector));
        normal = vector * ratio(all(1), area);
        const Vec height = dot(corners[0], normal);
        height2 = hn::Mul(height, height);
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3 &a = corners[i], &b = corners[(i + 1) % 3], along = b - a;
            edges[i] = {dot(normal, cross(a, b)), in_plane2(dot(a, a)), dot(a, along),
                        dot(along, along), all(0)};
        }
        for (std::size_t i = 0; i < 3; ++i) {
            Edge& edge = edges[i];
            edge.angle = angle_between(edge.twice, edge.from2, edges[(i + 1) % 3].from2,
                                       hn::Add(edge.from2, edge.towards));
        }
    }

    /// Returns the areas within a radius of the query.
    HWY_INLINE Vec area_within(Vec radius2) const
    {
        const Vec circle2 = in_plane2(radius2);
        Vec twice = all(0);
        for (const Edge& edge : edges)
            twice = hn::Add(twice, twice_within(edge, circle2));
        return hn::Min(hn::Max(hn::Mul(twice, all(0.5f)), all(0)), area);
    }

  private:
    HWY_INLINE Vec in_plane2(Vec length2) const
    {
        return hn::Max(hn::Sub(length2, height2), all(0));
    }

    static HWY_INLINE Vec angle_between(Vec crossed, Vec a2, Vec b2, Vec dotted)
    {
        const Vec below = hn::Add(hn::Sqrt(hn::Mul(a2, b2)), dotted);
        return double_arc_tangent(crossed, hn::Max(below, all(0)));
    }

    /// Returns twice the areas of the triangles of an edge and the foot within a circle.
    static HWY_INLINE Vec twice_within(const Edge& edge, Vec circle2)
    {
        const Vec each = ratio(all(1), edge.length2), zero = all(0);
        const Vec nearest = hn::Mul(hn::Sub(zero, edge.towards), each);
        const Vec way2 = hn::Mul(hn::Mul(edge.twice, edge.twice), each);
        const Vec half = hn::Sqrt(hn::Mul(hn::Max(hn::Sub(circle2, way2), zero), each));
        const Vec from = hn::Max(hn::Sub(nearest, half), zero);
        const Vec to = hn::Min(hn::Add(nearest, half), all(1));
        const auto place = [&](Vec s, Vec t) HWY_ATTR {
            const Vec first = hn::Mul(hn::Add(s, t), edge.towards);
            return hn::Add(hn::Add(edge.from2, first), hn::Mul(hn::Mul(s, t), edge.length2));
        };
        const Vec crossed = hn::Mul(hn::Sub(to, from), edge.twice);
        const Vec enter2 = hn::Max(place(from, from), zero), leave2 = hn::Max(place(to, to), zero);
        const Vec chord = angle_between(crossed, enter2, leave2, place(from, to));
        const Vec cut = hn::Add(crossed, hn::Mul(circle2, hn::Sub(edge.angle, chord)));
        return hn::IfThenElse(hn::Lt(from, to), cut, hn::Mul(circle2, edge.angle));
    }
};

/// Walks a tree from its largest nodes to the smallest, so that what is left over when it has
/// opened enough of them is small.
class Walk {
  public:
    Walk(const FoldTrees& trees, const FoldQuery& query, std::span<const float> radii)
        : trees_(trees), query_(query), radii_(radii), point_(spread(query.point)),
          normal_(spread(query.normal))
    {
        queue_[0] = trees.roots[query.fold];
        for (const float radius : radii)
            widest2_ = std::max(widest2_, radius * radius);
    }

    FoldAreas sum()
    {
        for (std::size_t i = 0; i < waiting_; ++i)
            if (queue_[i].is_block)
                visit(trees_.blocks[queue_[i].number]);
            else
                visit(trees_.nodes[queue_[i].number]);
        FoldAreas out{};
        for (std::size_t r = 0; r < radii_.size(); ++r)
            for (const float lane : lanes_[r])
                out[r] += double{lane};
        return out;
    }

  private:
    /// Returns those that must be looked at more closely: a circle cuts them, and they are large.
    HWY_INLINE Mask is_cut(const Boxes& boxes) const
    {
        Mask out = none();
        for (const float radius : radii_) {
            const Vec radius2 = all(radius * radius);
            const Mask crossed = hn::And(hn::Lt(boxes.near2, radius2), hn::Lt(radius2, boxes.far2));
            out = hn::Or(out, hn::And(crossed, hn::Ge(boxes.extent, all(kSmall * radius))));
        }
        return out;
    }

    HWY_INLINE Vec part_within(const Boxes& boxes, const Distances& at, float radius) const
    {
        const Vec radius2 = all(radius * radius);
        const Vec part =
            hn::IfThenElse(hn::Ge(radius2, boxes.far2), all(1), at.part_within(radius));
        return hn::IfThenElseZero(hn::Lt(boxes.near2, radius2), part);
    }

    HWY_INLINE void add(std::size_t radius, std::size_t lane, Vec area)
    {
        const Floats d;
        float* const sums = lanes_[radius] + lane;
        hn::Store(hn::Add(hn::Load(d, sums), area), d, sums);
    }

    void visit(const FoldNode& node)
    {
        const Floats d;
        const bool enough = waiting_ + kFoldWidth > queue_.size();
        for (std::size_t lane = 0; lane < kFoldWidth; lane += hn::Lanes(d)) {
            const Boxes boxes(load(node.low, lane) - point_, load(node.high, lane) - point_);
            const Mask reached = hn::Lt(boxes.near2, all(widest2_));
            const Mask open = enough ? none() : hn::And(reached, is_cut(boxes));
            add_sums(node, lane, boxes, hn::AndNot(open, reached));
            for (unsigned bits = bits_of(open); bits != 0; bits &= bits - 1)
                queue_[waiting_++] = {node.first_child + static_cast<std::uint32_t>(lane) +
                                          static_cast<std::uint32_t>(std::countr_zero(bits)),
                                      node.of_blocks};
        }
    }

    HWY_INLINE void add_sums(const FoldNode& node, std::size_t lane, const Boxes& boxes,
                             Mask wanted)
    {
        const Floats d;
        if (hn::AllFalse(d, wanted))
            return;
        const Vec3 way = load(node.middle, lane) - point_;
        const Distances at = distances_of(node, lane, way);
        const Vec away = ratio(dot(way, normal_), hn::Sqrt(dot(way, way)));
        Vec near[kMostFoldRadii];
        for (std::size_t r = 0; r < radii_.size(); ++r)
            near[r] = part_within(boxes, at, radii_[r]);
        for (std::size_t i = 0; i < FoldNode::kDirections; ++i) {
            const Vec area = hn::IfThenElseZero(wanted, hn::Load(d, node.area[i] + lane));
            if (hn::AllFalse(d, hn::Gt(area, all(0))))
                continue;
            const Slopes slopes(load(node.normal[i], lane), normal_);
            for (std::size_t r = 0; r < radii_.size(); ++r)
                add(r, lane, hn::Mul(area, slopes.part(query_.of, near[r], away)));
        }
    }

    void visit(const FoldBlock& block)
    {
        const Floats d;
        for (std::size_t lane = 0; lane < kFoldWidth; lane += hn::Lanes(d)) {
            const std::array<Vec3, 3> corners{load(block.corner[0], lane) - point_,
                                              load(block.corner[1], lane) - point_,
                                              load(block.corner[2], lane) - point_};
            const Vec3 vector = area_vector(corners);
            const Vec along = dot(vector, normal_);
            const Boxes boxes(min(min(corners[0], corners[1]), corners[2]),
                              max(max(corners[0], corners[1]), corners[2]));
            const Mask wanted = hn::And(hn::Gt(along, all(0)), hn::Lt(boxes.near2, all(widest2_)));
            const Mask large = hn::And(wanted, is_cut(boxes));
            if (!hn::AllFalse(d, large))
                add_clipped(corners, boxes, lane, large);
            const Mask small = hn::AndNot(large, wanted);
            if (hn::AllFalse(d, small))
                continue;
            const Vec area =
                query_.of == AreaOf::projection ? along : hn::Sqrt(dot(vector, vector));
            const Distances at = distances_of(corners);
            for (std::size_t r = 0; r < radii_.size(); ++r)
                add(r, lane,
                    hn::IfThenElseZero(small, hn::Mul(area, part_within(boxes, at, radii_[r]))));
        }
    }

    HWY_INLINE void add_clipped(const std::array<Vec3, 3>& corners, const Boxes& boxes,
                                std::size_t lane, Mask wanted)
    {
        const FlatFaces faces(corners);
        const Vec part = query_.of == AreaOf::projection ? dot(faces.normal, normal_) : all(1);
        for (std::size_t r = 0; r < radii_.size(); ++r) {
            const Vec radius2 = all(radii_[r] * radii_[r]);
            const Vec within =
                hn::IfThenElse(hn::Ge(radius2, boxes.far2), faces.area, faces.area_within(radius2));
            const Mask kept = hn::And(wanted, hn::Lt(boxes.near2, radius2));
            add(r, lane, hn::IfThenElseZero(kept, hn::Mul(part, within)));
        }
    }

    const FoldTrees& trees_;
    const FoldQuery& query_;
    std::span<const float> radii_;
    Vec3 point_, normal_;
    float widest2_ = 0;
    HWY_ALIGN float lanes_[kMostFoldRadii][kFoldWidth] = {};
    std::array<FoldPlace, kMostOpenFolds> queue_;
    std::size_t waiting_ = 1;
};

FoldAreas Within(const FoldTrees& trees, const FoldQuery& query, std::span<const float> radii)
{
    return Walk(trees, query, radii).sum();
}

} // namespace hipmap::fold_walk::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hipmap {

namespace fold_walk {

HWY_EXPORT(Within);

} // namespace fold_walk

FoldAreas fold_areas(const FoldTrees& trees, const FoldQuery& query, std::span<const float> radii)
{
    using namespace fold_walk;
    return HWY_DYNAMIC_DISPATCH(Within)(trees, query, radii);
}

} // namespace hipmap
#endif
