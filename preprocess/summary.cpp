#include "preprocess/summary.h"

#include "common/image/picture_json.h"
#include "common/report.h"
#include "common/scene/scene_names.h"
#include "preprocess/partition/summarise.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <functional>
#include <iomanip>
#include <map>
#include <set>
#include <span>
#include <sstream>

namespace hipmap {

namespace {

constexpr std::array<const char*, 5> kClassNames{"connected", "unconnected", "border",
                                                 "non_manifold", "degenerate"};

std::string describe_largest(const PartitionSummary& summary)
{
    const PartitionSummary::Map& largest = summary.largest;
    std::ostringstream text;
    text << "the largest, map " << largest.id << ", has " << counted(largest.faces, "face")
         << " and " << std::fixed << std::setprecision(1) << 100 * largest.area / summary.area
         << " % of the area";
    return text.str();
}

} // namespace

std::string describe_maps(const PartitionSummary& summary)
{
    return counted(summary.map_count, "shared map") +
           (summary.maps.empty() ? "" : "; " + describe_largest(summary));
}

std::string describe_candidates(const PartitionSummary& summary)
{
    const ExpectedUse& expected = summary.expected;
    std::ostringstream text;
    text << "candidates: " << grouped(summary.candidates) << " of "
         << counted(summary.faces, "face") << " for local maps";
    if (summary.groups > 0)
        text << ", " << counted(summary.groups, "group") << " over "
             << counted(summary.grouped_faces, "face") << " for group maps";
    if (expected.is_known)
        text << "; each is expected to hold about " << expected.least
             << " photons or more in a pass of " << grouped(expected.photons) << " light paths";
    else
        text << "; by shape alone, as no light emits";
    return text.str();
}

std::vector<std::string> describe(const PartitionSummary& summary, double angle_deg)
{
    std::ostringstream angle;
    angle << angle_deg;
    std::vector<std::string> lines;
    lines.push_back("mesh: " + counted(summary.faces, "face") + ", " +
                    grouped(summary.welded_vertices) + " vertices after welding " +
                    grouped(summary.vertices) + ", " + grouped(summary.closed_faces) +
                    " faces on closed surfaces");
    lines.push_back("edges: " + grouped(summary.edges[0]) + " connected, " +
                    grouped(summary.edges[1]) + " unconnected (faces at " + angle.str() +
                    " degrees or more), " + grouped(summary.edges[2]) + " border, " +
                    grouped(summary.edges[3]) + " non-manifold");
    if (summary.edges_in_band > 0)
        lines.push_back("edges: " + grouped(summary.edges_in_band) + " at " + angle.str() +
                        " degrees up to rounding, counted as unconnected");
    lines.push_back(describe_maps(summary));
    if (summary.bridged_edges > 0)
        lines.push_back("seams: " + counted(summary.bridged_edges, "edge") +
                        " across which a surface continues without shared vertices; " +
                        counted(summary.joined_maps, "map") + " joined there");
    if (summary.contacts > 0)
        lines.push_back("contacts: " + counted(summary.contacts, "piece") +
                        " of boundary where one surface stands on another or intersects it");
    lines.push_back(describe_candidates(summary));
    return lines;
}

std::vector<std::string> describe_defects(const PartitionSummary& summary)
{
    const MeshDefects& defects = summary.defects;
    std::vector<std::string> lines;
    if (defects.degenerate_faces > 0)
        lines.push_back(counted(defects.degenerate_faces, "face") +
                        " without area: kept, but without a map");
    if (defects.flipped_faces > 0)
        lines.push_back(counted(defects.flipped_faces, "face") +
                        " with reversed winding: treated as flipped");
    if (defects.non_manifold_edges > 0)
        lines.push_back(counted(defects.non_manifold_edges, "edge") +
                        " of three or more faces: no photons are shared across them");
    if (defects.cut_edges > 0)
        lines.push_back(counted(defects.cut_edges, "edge") +
                        " of one-sided surfaces (such as a Moebius strip): cut open there");
    if (defects.refused_faces > 0)
        lines.push_back(counted(defects.refused_faces, "face") +
                        " rejected by the half-edge mesh: kept, without neighbours");
    if (summary.given_up > 0)
        lines.push_back(
            counted(summary.given_up, "place") +
            " where too many faces touch a face or edge: boundaries may be missing there");
    return lines;
}

namespace {

/// Maps beyond this are only counted: a file that lists ten million is of no use to anyone.
constexpr std::size_t kMostMapsListed = 1000;

/// A map that is listed.
struct ListedMap {
    PartitionSummary::Map map;
    MapId stored = 0;      ///< the map itself, or that which it is a copy of
    ObjectId copy = kNone; ///< the object that has the copy
};

/// The maps of the largest area, at most kMostMapsListed, by id.
std::vector<ListedMap> maps_to_list(const Scene& scene, const Partition& partition,
                                    const PartitionSummary& summary)
{
    std::vector<ListedMap> maps;
    const auto keep_largest = [&](std::size_t most) {
        if (maps.size() < most)
            return;
        const std::size_t kept = std::min(maps.size(), kMostMapsListed);
        std::ranges::partial_sort(maps, maps.begin() + static_cast<std::ptrdiff_t>(kept),
                                  [](const ListedMap& a, const ListedMap& b) {
                                      return a.map.area != b.map.area ? a.map.area > b.map.area
                                                                      : a.map.id < b.map.id;
                                  });
        maps.resize(kept);
    };
    const auto add = [&](const ListedMap& map) {
        maps.push_back(map);
        keep_largest(1024 * kMostMapsListed);
    };
    for (const PartitionSummary::Map& map : summary.maps)
        add({map, map.id, kNone});
    for_each_copied_map(summary, partition, scene.mesh,
                        [&](const PartitionSummary::Map& map, MapId stored) {
                            add({map, stored, kNone});
                        });
    keep_largest(0);
    std::ranges::sort(maps, {}, [](const ListedMap& map) { return map.map.id; });
    const auto& first = partition.first_map_of_copy;
    for (ListedMap& map : maps)
        if (map.map.id >= partition.map_count)
            map.copy = scene.mesh
                           .copies[static_cast<std::size_t>(
                               std::ranges::upper_bound(first, map.map.id) - first.begin() - 1)]
                           .object;
    return maps;
}

/// [maps] the names of what the faces of each of some maps have, in order of the names' ids, none
/// twice.  id_of_face: [F].
std::vector<std::vector<std::string>>
names_by_map(const Partition& partition, std::span<const ListedMap> maps,
             std::span<const std::uint32_t> id_of_face,
             const std::function<std::string(std::uint32_t)>& name)
{
    std::map<MapId, std::set<std::uint32_t>> ids;
    for (const ListedMap& map : maps)
        ids[map.stored];
    for (std::size_t face = 0; face < id_of_face.size(); ++face)
        if (const auto map = ids.find(partition.map_of_face[face]); map != ids.end())
            map->second.insert(id_of_face[face]);
    std::vector<std::vector<std::string>> out(maps.size());
    for (std::size_t i = 0; i < maps.size(); ++i)
        for (const std::uint32_t id : ids[maps[i].stored])
            out[i].push_back(name(id));
    return out;
}

nlohmann::ordered_json maps_json(const Scene& scene, const Partition& partition,
                                 std::span<const ListedMap> maps)
{
    const auto object_name = [&](std::uint32_t id) { return scene.mesh.object_names[id]; };
    const auto objects = names_by_map(partition, maps, scene.mesh.object_of_face, object_name);
    const auto materials = names_by_map(partition, maps, scene.mesh.material_of_face,
                                        [&](std::uint32_t id) { return scene.materials[id].name; });
    const double square_metres = scene.frame.metres_per_unit * scene.frame.metres_per_unit;
    nlohmann::ordered_json out = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < maps.size(); ++i) {
        const auto [map, stored, copy] = maps[i];
        out.push_back({{"id", map.id},
                       {"faces", map.faces},
                       {"area_m2", map.area * square_metres},
                       {"objects", copy == kNone ? objects[i] : std::vector{object_name(copy)}},
                       {"materials", materials[i]}});
    }
    return out;
}

/// The sums over all maps that are not listed.
nlohmann::ordered_json unlisted_json(const Scene& scene, const PartitionSummary& summary,
                                     const Partition& partition, std::span<const ListedMap> listed)
{
    std::size_t faces = 0;
    const auto add = [&](const PartitionSummary::Map& map, MapId = 0) { faces += map.faces; };
    for (const PartitionSummary::Map& map : summary.maps)
        add(map);
    for_each_copied_map(summary, partition, scene.mesh, add);
    double area = summary.area;
    for (const ListedMap& map : listed) {
        faces -= map.map.faces;
        area -= map.map.area;
    }
    const double square_metres = scene.frame.metres_per_unit * scene.frame.metres_per_unit;
    return {{"maps", summary.map_count - listed.size()},
            {"faces", faces},
            {"area_m2", std::max(area, 0.0) * square_metres}};
}

nlohmann::ordered_json expected_json(const ExpectedUse& expected)
{
    nlohmann::ordered_json out{{"is_known", expected.is_known},
                               {"light_paths", expected.photons},
                               {"photons_at_least", expected.least},
                               {"local_maps", expected.local_maps},
                               {"candidates_by_shape", expected.by_shape}};
    return out;
}

} // namespace

std::string summary_json(const PreprocessArguments& arguments, const Scene& scene,
                         const Partition& partition, const PartitionSummary& summary,
                         const std::vector<LegendedPicture>& pictures)
{
    nlohmann::ordered_json json;
    json["command"] = arguments.command;
    json["scene"] = arguments.scene.string();
    json["partition"] = arguments.output.string();
    json["angle_deg"] = arguments.angle_deg;
    json["split"] = name_of<SplitBy>(kSplits, arguments.split);
    json["weld_m"] = arguments.weld_metres;
    json["faces"] = summary.faces;
    json["vertices"] = summary.vertices;
    json["welded_vertices"] = summary.welded_vertices;
    json["closed_faces"] = summary.closed_faces;
    for (std::size_t i = 0; i < kClassNames.size(); ++i)
        json["edges"][kClassNames[i]] = summary.edges[i];
    json["edges"]["in_tolerance_band"] = summary.edges_in_band;
    json["defects"] = {{"degenerate_faces", summary.defects.degenerate_faces},
                       {"flipped_faces", summary.defects.flipped_faces},
                       {"non_manifold_edges", summary.defects.non_manifold_edges},
                       {"cut_edges", summary.defects.cut_edges},
                       {"refused_faces", summary.defects.refused_faces}};
    json["joined_maps"] = summary.joined_maps;
    json["bridged_edges"] = summary.bridged_edges;
    json["contacts"] = summary.contacts;
    json["given_up"] = summary.given_up;
    json["candidates"] = summary.candidates;
    json["groups"] = summary.groups;
    json["grouped_faces"] = summary.grouped_faces;
    json["expected"] = expected_json(summary.expected);
    json["shared_maps"] = summary.map_count;
    const std::vector<ListedMap> listed = maps_to_list(scene, partition, summary);
    json["maps"] = maps_json(scene, partition, listed);
    if (listed.size() < summary.map_count)
        json["unlisted_maps"] = unlisted_json(scene, summary, partition, listed);
    json["pictures"] = nlohmann::ordered_json::array();
    for (const LegendedPicture& picture : pictures)
        json["pictures"].push_back(picture_json(picture));
    for (const PartitionPass& pass : summary.passes)
        json["seconds"][std::string(pass.name)] = pass.seconds;
    return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

} // namespace hipmap
