#include "bench/query_methods.h"
#include "render/maps/wide_sums.h"

namespace hipmap {

namespace {

class Wide : public QueryMethod {
  public:
    Wide(const std::vector<RoomPoint>& photons, const std::vector<Photon>& powered, bool by_map)
        : by_map_(by_map), points_(points_by_map(photons, by_map))
    {
        const PowerScale scale = power_scale(powered);
        for (std::vector<TreePoint>& points : points_) {
            trees_.push_back(build_wide_tree(points));
            powers_.push_back(build_powers(trees_.back(), points, powered, scale));
        }
    }
    const char* name() const override { return by_map_ ? "wide, by map" : "wide"; }
    void prepare(std::size_t k) override { k_ = k; }
    void search(const RoomPoint& query) override
    {
        map_ = by_map_ ? query.map : 0;
        found_ = find_nearest(trees_[map_], {query.position, k_}, scratch_);
        summed_ = false;
    }
    void sum(const RoomPoint& query) override
    {
        map_ = by_map_ ? query.map : 0;
        sum_ = sum_nearest(trees_[map_], powers_[map_], {query.position, k_}, scratch_);
        summed_ = true;
    }
    std::optional<Traffic> traffic() const override
    {
        constexpr double kOfBox = 17, kOfPhoton = 8; // operations for a square distance
        Traffic out;
        out.nodes = static_cast<double>(scratch_.kept);
        out.blocks = static_cast<double>(scratch_.filled);
        out.whole = summed_ ? static_cast<double>(scratch_.wholes) : 0;
        const double added = summed_ ? out.blocks + out.whole : 0;
        out.bytes = out.nodes * sizeof(BoxNode) + out.blocks * sizeof(PhotonBlock) +
                    added * sizeof(PowerBlock);
        out.operations = kTreeWidth * (kOfBox * out.nodes + kOfPhoton * out.blocks);
        return out;
    }
    bool sum_is_right(const RoomPoint& query) override
    {
        sum(query);
        search(query);
        PowerSum listed(0);
        const bool all = found_.slots.size() < k_; // else without the farthest
        for (const std::uint32_t slot : found_.slots.first(found_.slots.size() - (all ? 0 : 1)))
            listed += powers_[map_].of(slot);
        return sum_.power == listed && sum_.photons == found_.slots.size() &&
               sum_.farthest2 == found_.farthest2;
    }
    std::vector<std::uint32_t> found() const override
    {
        std::vector<std::uint32_t> out;
        for (const std::uint32_t slot : found_.slots)
            out.push_back(points_[map_][slot].photon);
        return out;
    }
    std::size_t bytes() const override
    {
        std::size_t bytes = 0;
        for (std::size_t map = 0; map < trees_.size(); ++map)
            bytes += trees_[map].bytes() + powers_[map].bytes() + trees_[map].size * sizeof(FaceId);
        return bytes;
    }
    bool by_map() const override { return by_map_; }
    bool breaks_ties() const override { return false; }

  private:
    bool by_map_;
    std::vector<std::vector<TreePoint>> points_; ///< by map and slot, to check what is found
    std::vector<WideTree> trees_;
    std::vector<PhotonPowers> powers_;
    std::size_t map_ = 0;
    std::size_t k_ = 0;
    TreeScratch scratch_;
    FoundSlots found_;
    NearestSum sum_;
    bool summed_ = false;
};

} // namespace

std::unique_ptr<QueryMethod> make_wide(const std::vector<RoomPoint>& photons,
                                       const std::vector<Photon>& powered, bool by_map)
{
    return std::make_unique<Wide>(photons, powered, by_map);
}

} // namespace hipmap
