#include "common/scene/exclude_objects.h"

#include "common/scene/scene_names.h"

#include <algorithm>
#include <cctype>
#include <numeric>

namespace hipmap {

namespace {

/// Levenshtein's distance between two words, ignoring case.
std::size_t edit_distance(const std::string& a, const std::string& b)
{
    const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t changed = diagonal + (lower(a[i - 1]) != lower(b[j - 1]) ? 1 : 0);
            diagonal = row[j];
            row[j] = std::min({row[j] + 1, row[j - 1] + 1, changed});
        }
    }
    return row[b.size()];
}

/// The names of the objects, the most like `wanted` first.
std::vector<std::string> similar_names(const RawScene& scene, const std::string& wanted)
{
    constexpr std::size_t kMost = 1000; // enough to choose from, cheap to compare
    constexpr std::size_t kLongest = 200;
    std::vector<std::pair<std::size_t, std::string>> ranked;
    for (const RawObject& object : scene.objects)
        if (ranked.size() < kMost)
            ranked.emplace_back(
                edit_distance(wanted.substr(0, kLongest), object.name.substr(0, kLongest)),
                object.name);
    std::stable_sort(ranked.begin(), ranked.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<std::string> names;
    for (auto& [distance, name] : ranked)
        names.push_back(std::move(name));
    return names;
}

std::vector<bool> find_excluded(const RawScene& scene, std::span<const std::string> names)
{
    std::vector<bool> excluded(scene.objects.size(), false);
    for (const std::string& name : names) {
        bool found = false;
        for (std::size_t i = 0; i < scene.objects.size(); ++i)
            if (scene.objects[i].name == name || scene.objects[i].mesh_name == name)
                found = excluded[i] = true;
        if (!found)
            throw scene_error(scene.path, "--exclude " + quote_name(name),
                              "no such object; choose one of " +
                                  list_names(similar_names(scene, name)));
    }
    return excluded;
}

/// Keeps the elements whose `place` is not kNone, in order; an empty array stays so.
template <typename T>
void keep_placed(std::vector<T>& elements, const std::vector<std::uint32_t>& place)
{
    std::size_t kept = 0;
    for (std::size_t i = 0; i < elements.size(); ++i)
        if (place[i] != kNone)
            elements[kept++] = elements[i];
    elements.resize(kept);
}

/// Drops the vertices that no face uses, keeping the order of the rest.
void drop_unused_vertices(RawScene& scene)
{
    std::vector<std::uint32_t> place(scene.positions.size(), kNone);
    for (const glm::uvec3& face : scene.corners)
        for (int c = 0; c < 3; ++c)
            place[face[c]] = 0;
    std::uint32_t kept = 0;
    for (std::uint32_t& vertex : place)
        if (vertex != kNone)
            vertex = kept++;
    keep_placed(scene.positions, place);
    keep_placed(scene.normals, place);
    for (std::vector<glm::vec2>& uv : scene.attributes.uv)
        keep_placed(uv, place);
    keep_placed(scene.attributes.colours, place);
    keep_placed(scene.attributes.tangents, place);
    for (glm::uvec3& face : scene.corners)
        face = {place[face.x], place[face.y], place[face.z]};
}

} // namespace

void exclude_objects(RawScene& scene, std::span<const std::string> names)
{
    if (names.empty())
        return;
    const std::vector<bool> excluded = find_excluded(scene, names);
    std::size_t kept = 0;
    for (std::size_t face = 0; face < scene.corners.size(); ++face) {
        if (excluded[scene.object_of_face[face]])
            continue;
        scene.corners[kept] = scene.corners[face];
        scene.material_of_face[kept] = scene.material_of_face[face];
        scene.object_of_face[kept] = scene.object_of_face[face];
        ++kept;
    }
    const std::size_t left_out = scene.corners.size() - kept;
    scene.corners.resize(kept);
    scene.material_of_face.resize(kept);
    scene.object_of_face.resize(kept);
    drop_unused_vertices(scene);
    scene.audit.found.push_back("excluded: " + list_names(names) + ", " +
                                counted(left_out, "face"));
}

} // namespace hipmap
