#include "preprocess/colouring/coloured_glb.h"

#include "common/file/output_file.h"
#include "common/input_error.h"
#include "common/math/bounds.h"
#include "preprocess/colouring/map_colours.h"
#include "preprocess/colouring/painters.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstring>
#include <limits>
#include <numeric>

namespace hipmap {

namespace {

using Json = nlohmann::ordered_json;

/// Numbers of the glTF 2.0 specification.
constexpr int kFloat = 5126;
constexpr int kArrayBuffer = 34962;
constexpr int kTriangles = 4;
constexpr std::uint32_t kMagic = 0x46546c67;
constexpr std::uint32_t kJsonChunk = 0x4e4f534a;
constexpr std::uint32_t kBinaryChunk = 0x004e4942;

/// The vertices of all faces, object by object.
struct ColouredFaces {
    std::vector<glm::vec3> positions; ///< metres from the scene's centre
    std::vector<glm::vec3> colours;   ///< linear
    std::vector<ObjectId> object_of_vertex;
};

ColouredFaces colour_faces(const Scene& scene, const Partition& partition)
{
    const TriangleMesh& mesh = scene.mesh;
    std::vector<FaceId> order(mesh.face_count());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::stable_sort(order, {}, [&](FaceId face) { return mesh.object_of_face[face]; });
    const std::vector<Rgb> colours = map_colours(partition);
    ColouredFaces out;
    for (const FaceId face : order) {
        const MapId map = partition.map_of_face[face];
        for (int c = 0; c < 3; ++c) {
            const glm::dvec3 p(mesh.positions[mesh.corners[face][c]]);
            out.positions.emplace_back(p * scene.frame.metres_per_unit);
            out.colours.push_back(map == kNone ? kPlainFace : colours[map]);
            out.object_of_vertex.push_back(mesh.object_of_face[face]);
        }
    }
    return out;
}

Json array_of(const glm::dvec3& v)
{
    return Json::array({v.x, v.y, v.z});
}

/// Adds the node, mesh and accessors of the object of vertices `begin` to `end`.
void add_object(Json& json, const ColouredFaces& faces, std::size_t begin, std::size_t end,
                const Scene& scene)
{
    Bounds<glm::vec3> box;
    for (std::size_t i = begin; i < end; ++i)
        box.add(faces.positions[i]);
    const std::size_t accessor = json["accessors"].size();
    const auto add_accessor = [&](int view) -> Json& {
        json["accessors"].push_back({{"bufferView", view},
                                     {"byteOffset", begin * sizeof(glm::vec3)},
                                     {"componentType", kFloat},
                                     {"count", end - begin},
                                     {"type", "VEC3"}});
        return json["accessors"].back();
    };
    Json& positions = add_accessor(0);
    positions["min"] = array_of(glm::dvec3(box.low));
    positions["max"] = array_of(glm::dvec3(box.high));
    add_accessor(1);
    const std::string& name = scene.mesh.object_names[faces.object_of_vertex[begin]];
    const std::size_t number = json["nodes"].size();
    json["nodes"].push_back(
        {{"name", name}, {"mesh", number}, {"translation", array_of(scene.frame.centre)}});
    json["scenes"][0]["nodes"].push_back(number);
    const Json primitive{{"attributes", {{"POSITION", accessor}, {"COLOR_0", accessor + 1}}},
                         {"mode", kTriangles},
                         {"material", 0}};
    json["meshes"].push_back({{"name", name}, {"primitives", Json::array({primitive})}});
}

std::string describe_model(const ColouredFaces& faces, const Scene& scene)
{
    const std::size_t bytes = faces.positions.size() * sizeof(glm::vec3);
    Json json;
    json["asset"] = {{"version", "2.0"}, {"generator", "hipmap preprocess"}};
    json["scene"] = 0;
    json["scenes"].push_back({{"nodes", Json::array()}});
    json["materials"].push_back(
        {{"name", "Shared maps"},
         {"doubleSided", true},
         {"pbrMetallicRoughness", {{"metallicFactor", 0}, {"roughnessFactor", 1}}}});
    json["buffers"].push_back({{"byteLength", 2 * bytes}});
    for (const std::size_t offset : {std::size_t{0}, bytes})
        json["bufferViews"].push_back({{"buffer", 0},
                                       {"byteOffset", offset},
                                       {"byteLength", bytes},
                                       {"byteStride", sizeof(glm::vec3)},
                                       {"target", kArrayBuffer}});
    for (std::size_t begin = 0; begin < faces.positions.size();) {
        const auto end =
            std::ranges::upper_bound(faces.object_of_vertex, faces.object_of_vertex[begin]) -
            faces.object_of_vertex.begin();
        add_object(json, faces, begin, static_cast<std::size_t>(end), scene);
        begin = static_cast<std::size_t>(end);
    }
    std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
    text.resize((text.size() + 3) / 4 * 4, ' '); // chunks are whole words
    return text;
}

void append(std::vector<std::byte>& bytes, const void* data, std::size_t size)
{
    const auto* first = static_cast<const std::byte*>(data);
    bytes.insert(bytes.end(), first, first + size);
}

void append_word(std::vector<std::byte>& bytes, std::size_t word)
{
    const auto value = static_cast<std::uint32_t>(word);
    append(bytes, &value, sizeof value);
}

} // namespace

void write_coloured_glb(const std::filesystem::path& path, const Scene& scene,
                        const Partition& partition)
{
    const ColouredFaces faces = colour_faces(scene, partition);
    const std::string json = describe_model(faces, scene);
    const std::size_t half = faces.positions.size() * sizeof(glm::vec3);
    const std::size_t total = 12 + 8 + json.size() + 8 + 2 * half;
    if (total > std::numeric_limits<std::uint32_t>::max())
        throw InputError(path.string() + ": a coloured model of " +
                         std::to_string(scene.mesh.face_count()) +
                         " faces exceeds the 4 GiB of a .glb file; leave objects out (--exclude)");
    std::vector<std::byte> bytes;
    bytes.reserve(total);
    for (const std::size_t word :
         {std::size_t{kMagic}, std::size_t{2}, total, json.size(), std::size_t{kJsonChunk}})
        append_word(bytes, word);
    append(bytes, json.data(), json.size());
    append_word(bytes, 2 * half);
    append_word(bytes, kBinaryChunk);
    append(bytes, faces.positions.data(), half);
    append(bytes, faces.colours.data(), half);
    write_file(path, bytes);
}

} // namespace hipmap
