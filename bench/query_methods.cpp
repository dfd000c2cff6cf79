#include "bench/query_methods.h"

#include "render/dissertation/kd_tree.h"
#include "render/dissertation/midpoint_tree.h"

#include <nanoflann.hpp>

#include <cmath>
#include <ctime>

namespace hipmap {

namespace {

using Photons = std::vector<RoomPoint>;

std::vector<std::uint32_t> photons_of(std::span<const Neighbour> found)
{
    std::vector<std::uint32_t> out;
    for (const Neighbour& neighbour : found)
        out.push_back(neighbour.photon);
    return out;
}

/// What nanoflann asks of points.
struct PositionsForNanoflann {
    std::vector<glm::vec3> positions;

    std::size_t kdtree_get_point_count() const { return positions.size(); }
    float kdtree_get_pt(std::uint32_t i, std::size_t axis) const
    {
        return positions[i][static_cast<int>(axis)];
    }
    template <class Box>
    bool kdtree_get_bbox(Box&) const
    {
        return false;
    }
};

using NanoflannTree =
    nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, PositionsForNanoflann>,
                                        PositionsForNanoflann, 3, std::uint32_t>;

struct NanoflannIndex {
    PositionsForNanoflann points;
    std::unique_ptr<NanoflannTree> tree;

    explicit NanoflannIndex(const Photons& photons)
    {
        for (const RoomPoint& photon : photons)
            points.positions.push_back(photon.position);
        tree = std::make_unique<NanoflannTree>(3, points);
    }
    std::size_t bytes() const
    {
        return tree->usedMemory(*tree) + points.positions.size() * sizeof(glm::vec3);
    }
};

class Nanoflann : public QueryMethod {
  public:
    Nanoflann(const Photons& photons, const Powers& powers) : powers_(powers), index_(photons) {}
    const char* name() const override { return "nanoflann, KNNResultSet"; }
    void prepare(std::size_t k) override
    {
        photons_.resize(k);
        distances2_.resize(k);
    }
    void search(const RoomPoint& query) override
    {
        nanoflann::KNNResultSet<float, std::uint32_t> result(photons_.size());
        result.init(photons_.data(), distances2_.data());
        index_.tree->findNeighbors(result, &query.position[0], {});
        found_ = result.size();
    }
    glm::vec4 power() const { return sum_powers(powers_, std::span(photons_).first(found_)); }
    void sum(const RoomPoint& query) override
    {
        search(query);
        sum_ = power();
    }
    std::vector<std::uint32_t> found() const override
    {
        return {photons_.begin(), photons_.begin() + static_cast<std::ptrdiff_t>(found_)};
    }
    std::size_t bytes() const override { return index_.bytes(); }
    bool breaks_ties() const override { return false; }

  private:
    glm::vec4 sum_;
    const Powers& powers_;
    NanoflannIndex index_;
    std::vector<std::uint32_t> photons_;
    std::vector<float> distances2_;
    std::size_t found_ = 0;
};

/// A heap as nanoflann's result set.
struct HeapResultSet {
    using DistanceType = float;
    NeighbourHeap heap;

    std::size_t size() const { return heap.size(); }
    bool full() const { return heap.full(); }
    bool addPoint(float distance2, std::uint32_t photon)
    {
        heap.offer({distance2, photon});
        return true;
    }
    float worstDist() const { return heap.bound2(); }
};

/// The radius of a search begins at that of the last one and the step from there.
class SeededNanoflann : public QueryMethod {
  public:
    SeededNanoflann(const Photons& photons, const Powers& powers) : powers_(powers), index_(photons)
    {
    }
    const char* name() const override { return "nanoflann, seeded heap"; }
    void prepare(std::size_t k) override
    {
        storage_.resize(k);
        last_radius_ = std::numeric_limits<float>::infinity();
    }
    void search(const RoomPoint& query) override
    {
        const float radius = last_radius_ + glm::distance(query.position, last_point_);
        HeapResultSet result{{storage_, radius * radius * 1.00001f}};
        index_.tree->findNeighbors(result, &query.position[0], {});
        found_ = result.heap.sorted();
        last_point_ = query.position;
        if (found_.size() == storage_.size())
            last_radius_ = std::sqrt(found_.back().distance2);
    }
    glm::vec4 power() const { return sum_powers(powers_, found_); }
    void sum(const RoomPoint& query) override
    {
        search(query);
        sum_ = power();
    }
    std::vector<std::uint32_t> found() const override { return photons_of(found_); }
    std::size_t bytes() const override { return index_.bytes(); }
    bool breaks_ties() const override { return false; }

  private:
    glm::vec4 sum_;
    const Powers& powers_;
    NanoflannIndex index_;
    std::vector<Neighbour> storage_;
    std::span<const Neighbour> found_;
    glm::vec3 last_point_{0.0f};
    float last_radius_ = 0;
};

/// A tree of the dissertation's time with a heap.
class Textbook : public QueryMethod {
  public:
    Textbook(const Photons& photons, const Powers& powers, TreeKind kind, bool by_map)
        : powers_(powers), kind_(kind), by_map_(by_map)
    {
        for (std::vector<TreePoint>& points : points_by_map(photons, by_map))
            if (kind == TreeKind::balanced)
                balanced_.push_back(build_balanced_tree(std::move(points)));
            else
                unbalanced_.push_back(kind == TreeKind::midpoint ? build_midpoint_tree(points)
                                                                 : build_insertion_tree(points));
    }
    const char* name() const override
    {
        if (kind_ == TreeKind::unbalanced)
            return by_map_ ? "unbalanced, by map" : "unbalanced";
        if (kind_ == TreeKind::midpoint)
            return by_map_ ? "midpoint, by map" : "midpoint";
        return by_map_ ? "textbook, by map" : "textbook";
    }
    void prepare(std::size_t k) override { storage_.resize(k); }
    void search(const RoomPoint& query) override
    {
        const std::size_t map = by_map_ ? query.map : 0;
        NeighbourHeap heap(storage_, std::numeric_limits<float>::infinity());
        if (kind_ == TreeKind::balanced)
            search_tree(balanced_[map], query.position, AcceptAll(), heap);
        else
            search_tree(unbalanced_[map], query.position, AcceptAll(), heap, pending_);
        found_ = heap.farthest_last();
    }
    glm::vec4 power() const { return sum_powers(powers_, found_); }
    void sum(const RoomPoint& query) override
    {
        search(query);
        sum_ = power();
    }
    std::vector<std::uint32_t> found() const override { return photons_of(found_); }
    std::size_t bytes() const override
    {
        std::size_t bytes = 0;
        for (const BalancedTree& tree : balanced_)
            bytes += tree.bytes();
        for (const InsertionTree& tree : unbalanced_)
            bytes += tree.bytes();
        return bytes;
    }
    bool by_map() const override { return by_map_; }

  private:
    glm::vec4 sum_;
    const Powers& powers_;
    TreeKind kind_;
    bool by_map_;
    std::vector<BalancedTree> balanced_; ///< by map; or those of the other kind
    std::vector<InsertionTree> unbalanced_;
    std::vector<Neighbour> storage_;
    std::vector<PendingNode> pending_;
    std::span<const Neighbour> found_;
};

template <typename Make>
BuiltMethod build(const Make& make)
{
    const std::clock_t start = std::clock();
    std::unique_ptr<QueryMethod> method = make();
    const double seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
    return {std::move(method), seconds};
}

} // namespace

std::vector<std::vector<TreePoint>> points_by_map(const Photons& photons, bool by_map)
{
    std::vector<std::vector<TreePoint>> points(by_map ? kRoomMaps : 1);
    for (std::uint32_t i = 0; i < photons.size(); ++i)
        points[by_map ? photons[i].map : 0].push_back({photons[i].position, i});
    return points;
}

std::vector<BuiltMethod> build_methods(const std::vector<RoomPoint>& photons, const Powers& powers)
{
    std::vector<Photon> powered;
    for (std::size_t i = 0; i < photons.size(); ++i)
        powered.push_back({photons[i].position, Rgb(powers[i]), {0, 1, 0}, photons[i].map, 0});
    std::vector<BuiltMethod> methods;
    methods.push_back(build([&] { return std::make_unique<Nanoflann>(photons, powers); }));
    methods.push_back(build([&] { return std::make_unique<SeededNanoflann>(photons, powers); }));
    for (const TreeKind kind : {TreeKind::balanced, TreeKind::unbalanced, TreeKind::midpoint})
        for (const bool by_map : {false, true})
            methods.push_back(
                build([&] { return std::make_unique<Textbook>(photons, powers, kind, by_map); }));
    for (const bool by_map : {false, true})
        methods.push_back(build([&] { return make_wide(photons, powered, by_map); }));
    return methods;
}

} // namespace hipmap
