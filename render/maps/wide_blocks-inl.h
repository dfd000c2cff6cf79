// How far photons and boxes are; included once for each instruction set.

#if defined(HIPMAP_RENDER_MAPS_WIDE_BLOCKS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef HIPMAP_RENDER_MAPS_WIDE_BLOCKS_INL_H
#undef HIPMAP_RENDER_MAPS_WIDE_BLOCKS_INL_H
#else
#define HIPMAP_RENDER_MAPS_WIDE_BLOCKS_INL_H
#endif

#include "render/maps/wide_simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace hipmap::tree_search::HWY_NAMESPACE {

// No fused multiply-add anywhere, and sums in one order: distances are those of glm::dot, to the
// bit, on every processor.

struct PointVec {
    FloatVec x, y, z;
};

HWY_INLINE PointVec spread(const glm::vec3& point)
{
    const Floats d;
    return {hn::Set(d, point.x), hn::Set(d, point.y), hn::Set(d, point.z)};
}

HWY_INLINE FloatVec length2(FloatVec x, FloatVec y, FloatVec z)
{
    return hn::Add(hn::Add(hn::Mul(x, x), hn::Mul(y, y)), hn::Mul(z, z));
}

HWY_INLINE FloatVec photon_distance2(const PhotonBlock& block, std::size_t lane,
                                     const PointVec& point)
{
    const Floats d;
    return length2(hn::Sub(hn::Load(d, block.position[0] + lane), point.x),
                   hn::Sub(hn::Load(d, block.position[1] + lane), point.y),
                   hn::Sub(hn::Load(d, block.position[2] + lane), point.z));
}

/// Squares of the distances to the nearest point and the farthest corner of boxes.
struct BoxDistances2 {
    FloatVec nearest, farthest;
};

/// Computes the least and the greatest distance of any point between two corners to the boxes of a
/// node's children.  Rounding is monotonic, so no photon of a box is nearer or farther.  For a
/// missing child both are infinite.
HWY_INLINE BoxDistances2 box_distances2(const BoxNode& node, std::size_t lane, const PointVec& low,
                                        const PointVec& high)
{
    const Floats d;
    const FloatVec zero = hn::Zero(d);
    const auto below = [&](int axis, FloatVec p)
                           HWY_ATTR { return hn::Sub(hn::Load(d, node.low[axis] + lane), p); };
    const auto above = [&](int axis, FloatVec p)
                           HWY_ATTR { return hn::Sub(p, hn::Load(d, node.high[axis] + lane)); };
    const FloatVec x0 = below(0, high.x), x1 = above(0, low.x);
    const FloatVec y0 = below(1, high.y), y1 = above(1, low.y);
    const FloatVec z0 = below(2, high.z), z1 = above(2, low.z);
    const auto outside = [&](FloatVec a, FloatVec b)
                             HWY_ATTR { return hn::Max(hn::Max(a, b), zero); };
    return {length2(outside(x0, x1), outside(y0, y1), outside(z0, z1)),
            length2(hn::Min(x0, x1), hn::Min(y0, y1), hn::Min(z0, z1))};
}

/// Computes the distances of one point to the boxes of a node's children.
HWY_INLINE BoxDistances2 box_distances2(const BoxNode& node, std::size_t lane,
                                        const PointVec& point)
{
    return box_distances2(node, lane, point, point);
}

/// Writes the distances of the photons of the first `count` blocks into rows, and those between the
/// bounds also into the band; returns how many are in the ball.
HWY_INLINE std::size_t measure(const WideTree& tree, const PointVec& point, const Bounds2& bounds,
                               std::size_t count, TreeScratch& scratch)
{
    const Floats d;
    const FloatVec low2 = hn::Set(d, bounds.low2), high2 = hn::Set(d, bounds.high2);
    grow(scratch.rows, count + 1);
    grow(scratch.band, kTreeWidth * (count + 2));
    float* const band = scratch.band.data();
    const std::uint32_t* const blocks = scratch.blocks.data();
    TreeScratch::Row* const rows = scratch.rows.data();
    std::size_t inside = 0, in_band = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const PhotonBlock& block = tree.blocks[blocks[i]];
        for (std::size_t lane = 0; lane < kTreeWidth; lane += hn::Lanes(d)) {
            const FloatVec distance2 = photon_distance2(block, lane, point);
            const Mask near = hn::Le(distance2, high2);
            hn::Store(distance2, d, rows[i].distance2 + lane);
            inside += hn::CountTrue(d, near);
            in_band +=
                write_values(distance2, hn::And(near, hn::Ge(distance2, low2)), band + in_band);
        }
    }
    pad(band + in_band);
    scratch.filled = count;
    scratch.in_band = in_band;
    return inside;
}

} // namespace hipmap::tree_search::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
