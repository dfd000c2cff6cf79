#include "render/maps/visible_disc.h"

#include "render/maps/plane_directions.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace hipmap {

namespace {

/// Least barycentric weight of the point looked from: far above the rounding of doubles, about that
/// of the floats the corners are given in.
constexpr double kInside = 0x1p-22;

/// To test so many pieces takes less time than to find the one in a direction.
constexpr std::size_t kFewPieces = 8;

/// Angle from u counter-clockwise to v, whose keys are `turn` apart (0 to 4).  The keys settle what
/// the arctangent leaves open or rounds away: no turn or a whole one, in particular.
double angle_between(const glm::dvec2& u, const glm::dvec2& v, double turn)
{
    if (!(turn > 0))
        return 0.0;
    const double angle = std::atan2(cross(u, v), glm::dot(u, v));
    if (turn < 1)
        return std::max(0.0, angle);
    return angle < 0 || turn > 3 ? 2 * std::numbers::pi + std::min(0.0, angle) : angle;
}

} // namespace

/// False if the face has no area.
bool VisibleDisc::set_plane(const DiscQuery& query)
{
    const glm::dvec3 corner(query.face[0]);
    const glm::dvec3 side1 = glm::dvec3(query.face[1]) - corner;
    const glm::dvec3 side2 = glm::dvec3(query.face[2]) - corner;
    const glm::dvec3 to_point = glm::dvec3(query.point) - corner;
    const glm::dvec3 normal = glm::cross(side1, side2);
    const double normal2 = glm::dot(normal, normal);
    if (!(normal2 > 0))
        return false;

    // The rounded point may lie beyond an edge of its face; it looks from just within.
    const double w1 = glm::dot(glm::cross(to_point, side2), normal) / normal2;
    const double w2 = glm::dot(glm::cross(side1, to_point), normal) / normal2;
    const double in0 = std::max(1 - w1 - w2, kInside);
    const double in1 = std::max(w1, kInside);
    const double in2 = std::max(w2, kInside);
    centre_ = corner + (in1 * side1 + in2 * side2) / (in0 + in1 + in2);
    x_axis_ = glm::normalize(side1);
    normal_ = normal / std::sqrt(normal2);
    y_axis_ = glm::cross(normal, x_axis_) / std::sqrt(normal2);
    return true;
}

PlanePoint VisibleDisc::project(const glm::vec3& point) const
{
    const glm::dvec3 off = glm::dvec3(point) - centre_;
    return {{glm::dot(off, x_axis_), glm::dot(off, y_axis_)}, glm::dot(off, normal_)};
}

void VisibleDisc::add_walls(const BoundarySegment& segment, double radius2)
{
    const PlanePoint a = project(segment.a), b = project(segment.b);
    for (const auto& [from, to] : parts_on_fold(fold_, a, b)) {
        const auto at = [&](double t) { return t < 1 ? a.at + t * (b.at - a.at) : b.at; };
        add_wall(at(from), at(to), radius2);
    }
}

void VisibleDisc::add_wall(glm::dvec2 a, glm::dvec2 b, double radius2)
{
    const double turn = cross(a, b);
    if (turn == 0) // seen end-on, or a point: hides nothing
        return;
    if (turn < 0)
        std::swap(a, b);
    const double d2 = distance2(a, b);
    if (d2 >= radius2)
        return;
    nearest2_ = std::min(nearest2_, d2);
    walls_.push_back({a, b, std::abs(turn)});
}

/// False if the face has no area.
bool VisibleDisc::look_past(const DiscQuery& query, std::span<const BoundarySegment> boundary)
{
    assert(query.radius > 0 && std::isfinite(query.radius));
    if (!set_plane(query))
        return false;
    fold_ = OwnFold(query.radius);
    nearest2_ = std::numeric_limits<double>::infinity();
    for (const BoundarySegment& segment : boundary)
        add_walls(segment, double(query.radius) * query.radius);
    build_envelope();
    few_.clear();
    if (envelope_.size() <= kFewPieces)
        for (const Piece& piece : envelope_)
            few_.push_back(walls_[piece.wall]);
    return true;
}

/// A1: p = (s a + t b) / (a x b) lies beyond the wall if s, t >= 0 and s + t > a x b.  Both ends
/// belong to the wall, so that nothing passes between two walls that share one.
bool VisibleDisc::hides(const DiscWall& wall, const glm::dvec2& p)
{
    const double s = cross(p, wall.b);
    const double t = cross(wall.a, p);
    return s >= 0 && t >= 0 && s + t > wall.cross;
}

/// What any wall hides, the nearest in that direction hides too.  Where keys are rounded, that may
/// be a neighbour of the piece they name.
bool VisibleDisc::sees_past_walls(const glm::vec3& photon) const
{
    const auto [p, height] = project(photon);
    if (!fold_.contains(p, height))
        return false;
    if (glm::dot(p, p) <= nearest2_)
        return true;
    const std::size_t count = envelope_.size();
    if (count <= kFewPieces)
        return std::ranges::none_of(few_, [&](const DiscWall& wall) { return hides(wall, p); });
    const auto after =
        std::upper_bound(envelope_.begin(), envelope_.end(), direction_key(p),
                         [](double key, const Piece& piece) { return key < piece.from.key; });
    const auto next = static_cast<std::size_t>(after - envelope_.begin());
    const auto hidden_by = [&](std::size_t piece) {
        return hides(walls_[envelope_[piece < count ? piece : piece - count].wall], p);
    };
    return !hidden_by(next + count - 1) && !hidden_by(next + count - 2) && !hidden_by(next);
}

std::optional<DiscView> VisibleDisc::few_walls() const
{
    if (envelope_.size() > kFewPieces)
        return std::nullopt;
    return DiscView{centre_, x_axis_, y_axis_, normal_, fold_, nearest2_, few_};
}

/// The wall as one piece, or as two if it crosses the ray along +x, where keys jump.
void VisibleDisc::add_first_pieces(std::uint32_t wall)
{
    const auto& [a, b, turn] = walls_[wall];
    const Mark from{a, direction_key(a)};
    const Mark to{b, direction_key(b)};
    if (from.key < to.key)
        return envelope_.push_back({from, to, wall});
    if (from.key - to.key < 1) // no wider than rounding
        return;
    const glm::dvec2 on_axis(turn / (b.y - a.y), 0.0);
    if (to.key > 0)
        envelope_.push_back({{on_axis, 0.0}, to, wall});
    if (from.key < 4)
        envelope_.push_back({from, {on_axis, 4.0}, wall});
}

/// A2, by divide and conquer: runs of pieces are merged two by two.
void VisibleDisc::build_envelope()
{
    envelope_.clear();
    runs_.assign(1, 0);
    for (std::uint32_t wall = 0; wall < walls_.size(); ++wall) {
        add_first_pieces(wall);
        runs_.push_back(static_cast<std::uint32_t>(envelope_.size()));
    }
    while (runs_.size() > 2) {
        merged_.clear();
        merged_runs_.assign(1, 0);
        for (std::size_t i = 0; i + 1 < runs_.size(); i += 2) {
            const std::size_t middle = runs_[i + 1];
            const std::size_t end = i + 2 < runs_.size() ? runs_[i + 2] : middle;
            const std::span<const Piece> all(envelope_);
            merge(all.subspan(runs_[i], middle - runs_[i]), all.subspan(middle, end - middle));
            merged_runs_.push_back(static_cast<std::uint32_t>(merged_.size()));
        }
        envelope_.swap(merged_);
        runs_.swap(merged_runs_);
    }
}

/// Where the wall of `piece` lies in a direction: between its ends, whatever the rounding.
VisibleDisc::Mark VisibleDisc::mark_towards(const Piece& piece, const Mark& direction) const
{
    const DiscWall& wall = walls_[piece.wall];
    const double to_b = std::max(0.0, cross(wall.a, direction.point));
    const double to_a = std::max(0.0, cross(direction.point, wall.b));
    const double t = to_b + to_a > 0 ? to_b / (to_b + to_a) : 0.5;
    return {wall.a + t * (wall.b - wall.a), direction.key};
}

void VisibleDisc::emit(const Piece& piece)
{
    if (!(piece.from.key < piece.to.key))
        return;
    const bool follows = merged_.size() > merged_runs_.back() &&
                         merged_.back().wall == piece.wall &&
                         merged_.back().to.key == piece.from.key;
    if (follows)
        merged_.back().to = piece.to;
    else
        merged_.push_back(piece);
}

/// Emits what is nearer of two pieces over the same directions; they may cross once.
void VisibleDisc::emit_nearer(const Piece& left, const Piece& right)
{
    const auto gap = [](const Mark& l, const Mark& r) {
        return glm::dot(r.point, r.point) - glm::dot(l.point, l.point);
    };
    const double gap_from = gap(left.from, right.from);
    const double gap_to = gap(left.to, right.to);
    if (gap_from >= 0 && gap_to >= 0)
        return emit(left);
    if (gap_from <= 0 && gap_to <= 0)
        return emit(right);

    const glm::dvec2 along = right.to.point - right.from.point;
    const double off_from = std::abs(cross(along, left.from.point - right.from.point));
    const double off_to = std::abs(cross(along, left.to.point - right.from.point));
    const double t = off_from + off_to > 0 ? off_from / (off_from + off_to) : 0.5;
    Mark crossing{left.from.point + t * (left.to.point - left.from.point), 0.0};
    crossing.key = std::clamp(direction_key(crossing.point), left.from.key, left.to.key);
    const Piece& first = gap_from > 0 ? left : right;
    const Piece& second = gap_from > 0 ? right : left;
    emit({first.from, crossing, first.wall});
    emit({crossing, second.to, second.wall});
}

/// Merges two runs of pieces into one, the nearer in front.
void VisibleDisc::merge(std::span<const Piece> left, std::span<const Piece> right)
{
    std::size_t i = 0, j = 0;
    Piece l = left.empty() ? Piece{} : left[0];
    Piece r = right.empty() ? Piece{} : right[0];
    while (i < left.size() && j < right.size()) {
        if (l.from.key == r.from.key) {
            const Mark l_cut = l.to.key <= r.to.key ? l.to : mark_towards(l, r.to);
            const Mark r_cut = r.to.key <= l.to.key ? r.to : mark_towards(r, l.to);
            emit_nearer({l.from, l_cut, l.wall}, {r.from, r_cut, r.wall});
            l.from = l_cut;
            r.from = r_cut;
        } else {
            Piece& first = l.from.key < r.from.key ? l : r;
            const Mark& next = l.from.key < r.from.key ? r.from : l.from;
            const Mark cut = first.to.key <= next.key ? first.to : mark_towards(first, next);
            emit({first.from, cut, first.wall});
            first.from = cut;
        }
        if (!(l.from.key < l.to.key) && ++i < left.size())
            l = left[i];
        if (!(r.from.key < r.to.key) && ++j < right.size())
            r = right[j];
    }
    for (; i < left.size(); l = ++i < left.size() ? left[i] : l)
        emit(l);
    for (; j < right.size(); r = ++j < right.size() ? right[j] : r)
        emit(r);
}

/// What of a piece lies within the circle; false if nothing.
bool VisibleDisc::clip(const Piece& piece, double r2, Chord& chord) const
{
    const DiscWall& wall = walls_[piece.wall];
    const glm::dvec2 along = wall.b - wall.a;
    const double length = std::sqrt(glm::dot(along, along));
    const glm::dvec2 unit = along / length;
    const double distance = wall.cross / length;
    const double half2 = r2 - distance * distance;
    if (!(half2 > 0))
        return false;
    const double half = std::sqrt(half2);
    const double from = glm::dot(piece.from.point, unit);
    const double to = glm::dot(piece.to.point, unit);
    if (from >= half || to <= -half || from >= to)
        return false;

    const auto at = [&](double s) {
        const glm::dvec2 point = distance * glm::dvec2(unit.y, -unit.x) + s * unit;
        return Mark{point, std::clamp(direction_key(point), piece.from.key, piece.to.key)};
    };
    chord.from = from < -half ? at(-half) : piece.from;
    chord.to = to > half ? at(half) : piece.to;
    chord.area2 = distance * (std::min(to, half) - std::max(from, -half));
    return true;
}

/// A4: triangles behind which a wall stands, and sectors between them.  All terms are positive, so
/// that a small area keeps its digits.
double VisibleDisc::area_within_walls(float r) const
{
    const double r2 = double(r) * r;
    const double disc = std::numbers::pi * r2;
    if (r2 <= nearest2_)
        return disc;
    double area2 = 0.0;
    Mark first{}, last{};
    bool hidden = false;
    for (const Piece& piece : envelope_) {
        Chord chord;
        if (!clip(piece, r2, chord))
            continue;
        area2 += chord.area2;
        if (hidden)
            area2 += r2 * angle_between(last.point, chord.from.point, chord.from.key - last.key);
        else
            first = chord.from;
        last = chord.to;
        hidden = true;
    }
    if (!hidden)
        return disc;
    area2 += r2 * angle_between(last.point, first.point, first.key + 4 - last.key);
    return std::clamp(area2 / 2, std::numbers::pi * nearest2_, disc);
}

} // namespace hipmap
