#pragma once

#include "bench/machine_limits.h"
#include "bench/power_sum.h"
#include "bench/query_scene.h"
#include "render/maps/wide_tree.h"
#include "render/photons/photon.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace hipmap {

/// A way to find the k photons nearest to a point.
class QueryMethod {
  public:
    virtual ~QueryMethod() = default;
    virtual const char* name() const = 0;
    /// Wants k photons of each search from now on.
    virtual void prepare(std::size_t k) = 0;
    virtual void search(const RoomPoint& query) = 0;
    /// Searches, and adds the powers of what it finds.
    virtual void sum(const RoomPoint& query) = 0;
    /// Whether the sum of the photons last searched is what a list of them has.
    virtual bool sum_is_right(const RoomPoint&) { return true; }
    /// Numbers of the photons of the last search, in any order.
    virtual std::vector<std::uint32_t> found() const = 0;
    virtual std::size_t bytes() const = 0;
    /// What the last search read, powers too if it added them; none: it is not counted.
    virtual std::optional<Traffic> traffic() const { return {}; }
    /// Whether it searches the query's map alone.
    virtual bool by_map() const { return false; }
    /// Whether equally far photons are told apart by their numbers.
    virtual bool breaks_ties() const { return true; }
};

struct BuiltMethod {
    std::unique_ptr<QueryMethod> method;
    double build_seconds;
};

/// Every method over the same photons, built one after the other.  Borrows the powers, by photon.
std::vector<BuiltMethod> build_methods(const std::vector<RoomPoint>& photons, const Powers& powers);

/// The photons of each map, or all of them as one.
std::vector<std::vector<TreePoint>> points_by_map(const std::vector<RoomPoint>& photons,
                                                  bool by_map);

/// The wide tree with the powers beside it.
std::unique_ptr<QueryMethod> make_wide(const std::vector<RoomPoint>& photons,
                                       const std::vector<Photon>& powered, bool by_map);

} // namespace hipmap
