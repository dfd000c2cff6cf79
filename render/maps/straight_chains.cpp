#include "render/maps/straight_chains.h"

#include "common/scene/mesh.h"

#include <algorithm>
#include <array>
#include <tuple>

namespace hipmap {

namespace {

/// Points of a chain that one segment may replace: each is measured again when the chain grows.
constexpr std::size_t kMostJoined = 64;

/// Ends of segments are numbered 2 s (a) and 2 s + 1 (b).
using End = std::uint32_t;

glm::vec3 point_of(std::span<const BoundarySegment> segments, End end)
{
    return end % 2 == 0 ? segments[end / 2].a : segments[end / 2].b;
}

/// [2n] the one other end at the same point; kNone where there is none or more than one.
std::vector<End> find_joints(std::span<const BoundarySegment> segments)
{
    std::vector<End> order(2 * segments.size());
    for (End end = 0; end < order.size(); ++end)
        order[end] = end;
    const auto key = [&](End end) {
        const glm::vec3 p = point_of(segments, end);
        return std::tuple(p.x, p.y, p.z);
    };
    std::sort(order.begin(), order.end(), [&](End l, End r) { return key(l) < key(r); });
    std::vector<End> joint(order.size(), kNone);
    for (std::size_t first = 0, last = 0; first < order.size(); first = last) {
        while (last < order.size() && key(order[last]) == key(order[first]))
            ++last;
        if (last - first != 2 || order[first] / 2 == order[first + 1] / 2)
            continue;
        joint[order[first]] = order[first + 1];
        joint[order[first + 1]] = order[first];
    }
    return joint;
}

class ChainJoiner {
  public:
    ChainJoiner(std::span<const BoundarySegment> segments, double tolerance)
        : segments_(segments), tolerance2_(tolerance * tolerance), joint_(find_joints(segments)),
          done_(segments.size(), false)
    {
    }

    std::vector<BoundarySegment> join()
    {
        for (End end = 0; end < joint_.size(); ++end)
            if (!done_[end / 2] && !goes_straight_on(end))
                follow(end);
        for (End end = 0; end < joint_.size(); end += 2) // rings that nowhere bend
            if (!done_[end / 2])
                follow(end);
        return std::move(out_);
    }

  private:
    /// Whether the segments that meet at this end make a straight line.
    bool goes_straight_on(End end) const
    {
        if (joint_[end] == kNone)
            return false;
        const BoundarySegment across{point_of(segments_, end ^ 1),
                                     point_of(segments_, joint_[end] ^ 1)};
        return is_between(point_of(segments_, end), across);
    }

    bool is_between(const glm::vec3& point, const BoundarySegment& line) const
    {
        const glm::dvec3 to_a = glm::dvec3(line.a) - glm::dvec3(point);
        const glm::dvec3 to_b = glm::dvec3(line.b) - glm::dvec3(point);
        return glm::dot(to_a, to_b) < 0 && distance2_to_segment(point, line) <= tolerance2_;
    }

    /// Adds the chain that begins at an end of a segment and leads over the segment.
    void follow(End begin)
    {
        skipped_.clear();
        glm::vec3 from = point_of(segments_, begin);
        End end = begin ^ 1;
        done_[end / 2] = true;
        for (;;) {
            const glm::vec3 here = point_of(segments_, end);
            const End next = joint_[end];
            if (next == kNone || done_[next / 2]) {
                out_.push_back({from, here});
                return;
            }
            skipped_.push_back(here);
            if (!replaces_skipped({from, point_of(segments_, next ^ 1)})) {
                out_.push_back({from, here});
                from = here;
                skipped_.clear();
            }
            done_[next / 2] = true;
            end = next ^ 1;
        }
    }

    bool replaces_skipped(const BoundarySegment& line) const
    {
        return skipped_.size() <= kMostJoined &&
               std::all_of(skipped_.begin(), skipped_.end(),
                           [&](const glm::vec3& point) { return is_between(point, line); });
    }

    std::span<const BoundarySegment> segments_;
    double tolerance2_;
    std::vector<End> joint_;
    std::vector<bool> done_;
    std::vector<glm::vec3> skipped_;
    std::vector<BoundarySegment> out_;
};

} // namespace

double distance2_to_segment(const glm::vec3& point, const BoundarySegment& segment)
{
    const glm::dvec3 a(segment.a);
    const glm::dvec3 along = glm::dvec3(segment.b) - a;
    const glm::dvec3 to_point = glm::dvec3(point) - a;
    const double length2 = glm::dot(along, along);
    const double t = length2 > 0 ? glm::dot(to_point, along) / length2 : 0.0;
    const glm::dvec3 off = to_point - std::clamp(t, 0.0, 1.0) * along;
    return glm::dot(off, off);
}

std::vector<BoundarySegment> join_straight_chains(std::span<const BoundarySegment> segments,
                                                  float rounding)
{
    std::vector<BoundarySegment> out(segments.begin(), segments.end());
    std::size_t before = 0;
    do {
        before = out.size();
        out = ChainJoiner(out, 2.0 * double{rounding}).join();
    } while (4 * out.size() < before * 3 && out.size() > 1);
    return out;
}

} // namespace hipmap
