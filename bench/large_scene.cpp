// Writes large scenes as .glb files, to measure what preprocess and render cost by size.
//
//     large_scene terrain|objects|soup TRIANGLES OUT.glb
//     large_scene forest|wood TREES OUT.glb [TRIANGLES OF A TREE]
//
// The trees of a forest stand free; those of a wood are rooted in hills, which their trunks cut.

#include "common/command_line/command_line.h"
#include "common/file/output_file.h"
#include "common/input_error.h"
#include "common/math/random.h"

#include <glm/glm.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/quaternion.hpp>

#include <cmath>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace hipmap {

namespace {

/// Vertices and corners of triangles, as in the file.
struct Mesh {
    std::vector<glm::vec3> positions;
    std::vector<glm::uvec3> corners;
};

/// Random numbers by place, so that a scene is the same on every machine.
class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed) {}
    /// Returns a number from 0 to 1.
    float next() { return static_cast<float>(mix_bits(++state_) >> 40) * 0x1p-24f; }
    glm::vec3 point()
    {
        const float x = next(), y = next();
        return {x, y, next()};
    }
    glm::quat rotation()
    {
        const glm::vec3 u = point();
        const float a = std::sqrt(1 - u.x), b = std::sqrt(u.x);
        const float phi = glm::two_pi<float>() * u.y, psi = glm::two_pi<float>() * u.z;
        return {a * std::sin(phi), a * std::cos(phi), b * std::sin(psi), b * std::cos(psi)};
    }

  private:
    std::uint64_t state_;
};

/// Appends a grid of columns x rows squares, place(u, v) with u and v from 0 to 1.
void append_grid(Mesh& mesh, std::uint32_t columns, std::uint32_t rows,
                 const std::function<glm::vec3(float, float)>& place)
{
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (std::uint32_t j = 0; j <= rows; ++j)
        for (std::uint32_t i = 0; i <= columns; ++i)
            mesh.positions.push_back(place(static_cast<float>(i) / static_cast<float>(columns),
                                           static_cast<float>(j) / static_cast<float>(rows)));
    for (std::uint32_t j = 0; j < rows; ++j)
        for (std::uint32_t i = 0; i < columns; ++i) {
            const std::uint32_t a = first + j * (columns + 1) + i, b = a + columns + 1;
            mesh.corners.emplace_back(a, b, b + 1);
            mesh.corners.emplace_back(a, b + 1, a + 1);
        }
}

/// Hills of 1 km by 1 km.
Mesh terrain(double triangles)
{
    Mesh mesh;
    const auto n = static_cast<std::uint32_t>(std::lround(std::sqrt(triangles / 2)));
    append_grid(mesh, n, n, [](float u, float v) {
        return glm::vec3(1000 * u, 20 * std::sin(31 * u) * std::sin(17 * v), 1000 * v);
    });
    return mesh;
}

/// Cubes that do not touch, each of 12 triangles and 6 shared maps.
Mesh objects(double triangles)
{
    Mesh mesh;
    const auto side = static_cast<std::uint32_t>(std::lround(std::cbrt(triangles / 12)));
    Random random(1);
    for (std::uint32_t i = 0; i < side * side * side; ++i) {
        const glm::vec3 centre(i % side, i / side % side, i / side / side);
        const glm::quat turn = random.rotation();
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (std::uint32_t c = 0; c < 8; ++c)
            mesh.positions.push_back(centre +
                                     turn * (0.5f * glm::vec3(c & 1, c >> 1 & 1, c >> 2) - 0.25f));
        for (const glm::uvec4& q : {glm::uvec4(0, 2, 3, 1),
                                    {4, 5, 7, 6},
                                    {0, 1, 5, 4},
                                    {2, 6, 7, 3},
                                    {0, 4, 6, 2},
                                    {1, 3, 7, 5}}) {
            mesh.corners.emplace_back(first + glm::uvec3(q.x, q.y, q.z));
            mesh.corners.emplace_back(first + glm::uvec3(q.x, q.z, q.w));
        }
    }
    return mesh;
}

/// Triangles at random, about as large as they are apart, so that most cut through others.
Mesh soup(double triangles)
{
    Mesh mesh;
    Random random(2);
    const float size = static_cast<float>(std::cbrt(1 / triangles));
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(triangles); ++i) {
        const glm::vec3 centre = random.point();
        for (int c = 0; c < 3; ++c)
            mesh.positions.push_back(centre + 2 * size * (random.point() - 0.5f));
        mesh.corners.emplace_back(3 * i + glm::uvec3(0, 1, 2));
    }
    return mesh;
}

/// A trunk and a wrinkled crown, 1 m high: nine tenths of the triangles are the crown's.
Mesh tree(double triangles)
{
    Mesh mesh;
    const auto round = [](float u) {
        const float phi = glm::two_pi<float>() * u;
        return glm::vec3(std::cos(phi), 0.0f, -std::sin(phi));
    };
    const auto trunk = static_cast<std::uint32_t>(std::max(4.0, std::sqrt(triangles / 20)));
    append_grid(mesh, trunk, trunk,
                [&](float u, float v) { return 0.03f * round(u) + glm::vec3(0, 0.4f * v, 0); });
    const auto crown = static_cast<std::uint32_t>(std::max(4.0, std::sqrt(triangles * 0.45)));
    append_grid(mesh, crown, crown, [&](float u, float v) {
        const float theta = glm::pi<float>() * (0.001f + 0.998f * v);
        const float wrinkled = 0.3f + 0.01f * std::sin(40 * theta) * std::sin(20 * 3.14159265f * u);
        return wrinkled * (std::sin(theta) * round(u) - glm::vec3(0, std::cos(theta), 0)) +
               glm::vec3(0, 0.65f, 0);
    });
    return mesh;
}

std::string number(double value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.9g", value);
    return text;
}

std::string triple(const glm::vec3& v)
{
    return "[" + number(v.x) + "," + number(v.y) + "," + number(v.z) + "]";
}

/// The height of the ground of a wood.
float hill(float x, float z)
{
    return 0.5f * std::sin(0.31f * x) * std::sin(0.23f * z);
}

/// The nodes of trees on a square of as many square metres, each its own size and turn.
std::string tree_nodes(std::uint32_t trees, bool rooted)
{
    Random random(3);
    const auto side = static_cast<std::uint32_t>(std::ceil(std::sqrt(trees)));
    std::string nodes;
    for (std::uint32_t i = 0; i < trees; ++i) {
        const glm::vec3 jitter = random.point();
        glm::vec3 place(static_cast<float>(i % side) + 0.3f * jitter.x, 0.0f,
                        static_cast<float>(i / side) + 0.3f * jitter.z);
        if (rooted)
            place.y = hill(place.x, place.z) - 0.1f;
        const float half_turn = glm::pi<float>() * random.next();
        const float size = 0.8f + 0.4f * jitter.y;
        nodes += (i > 0 ? ",{\"mesh\":0,\"translation\":" : "{\"mesh\":0,\"translation\":") +
                 triple(place) + ",\"rotation\":[0," + number(std::sin(half_turn)) + ",0," +
                 number(std::cos(half_turn)) + "],\"scale\":" + triple(glm::vec3(size)) + "}";
    }
    return nodes;
}

/// What a file says of one mesh, of which the data begins at `offset`.
struct MeshJson {
    std::string mesh, accessors, views;
};

MeshJson mesh_json(const Mesh& mesh, std::size_t index, std::size_t offset)
{
    glm::vec3 low(1e30f), high(-1e30f);
    for (const glm::vec3& p : mesh.positions) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    const std::size_t positions = mesh.positions.size() * sizeof(glm::vec3);
    const std::size_t indices = mesh.corners.size() * sizeof(glm::uvec3);
    const std::string at = std::to_string(2 * index), next = std::to_string(2 * index + 1);
    return {R"({"primitives":[{"attributes":{"POSITION":)" + at + R"(},"indices":)" + next +
                R"(,"material":0}]})",
            R"({"bufferView":)" + at + R"(,"componentType":5126,"type":"VEC3","count":)" +
                std::to_string(mesh.positions.size()) + R"(,"min":)" + triple(low) + R"(,"max":)" +
                triple(high) + R"(},{"bufferView":)" + next +
                R"(,"componentType":5125,"type":"SCALAR","count":)" +
                std::to_string(3 * mesh.corners.size()) + "}",
            R"({"buffer":0,"byteOffset":)" + std::to_string(offset) + R"(,"byteLength":)" +
                std::to_string(positions) + R"(},{"buffer":0,"byteOffset":)" +
                std::to_string(offset + positions) + R"(,"byteLength":)" + std::to_string(indices) +
                "}"};
}

std::size_t bytes_of(const Mesh& mesh)
{
    return mesh.positions.size() * sizeof(glm::vec3) + mesh.corners.size() * sizeof(glm::uvec3);
}

std::string header_json(std::span<const Mesh> meshes, const std::string& nodes,
                        std::size_t node_count)
{
    std::string roots;
    for (std::size_t i = 0; i < node_count; ++i)
        roots += (i > 0 ? "," : "") + std::to_string(i);
    MeshJson all;
    std::size_t offset = 0;
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        const MeshJson one = mesh_json(meshes[i], i, offset);
        const char* const comma = i > 0 ? "," : "";
        all.mesh += comma + one.mesh;
        all.accessors += comma + one.accessors;
        all.views += comma + one.views;
        offset += bytes_of(meshes[i]);
    }
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[)" + roots +
           R"(]}],"nodes":[)" + nodes +
           R"(],"materials":[{"pbrMetallicRoughness":{"metallicFactor":0,)"
           R"("baseColorFactor":[0.6,0.6,0.6,1]},"doubleSided":true}],"meshes":[)" +
           all.mesh + R"(],"accessors":[)" + all.accessors + R"(],"bufferViews":[)" + all.views +
           R"(],"buffers":[{"byteLength":)" + std::to_string(offset) + "}]}";
}

void write_glb(const std::filesystem::path& path, std::span<const Mesh> meshes, std::string json)
{
    json.resize((json.size() + 3) / 4 * 4, ' ');
    std::size_t data = 0;
    for (const Mesh& mesh : meshes)
        data += bytes_of(mesh);
    const std::size_t total = 28 + json.size() + data;
    if (total > 0xffffffffu)
        throw InputError(path.string() +
                         ": a .glb file holds at most 4 GiB; write fewer triangles");
    WholeFile file(path);
    const auto words = [&](const std::vector<std::size_t>& values) {
        std::vector<std::uint32_t> out;
        for (const std::size_t value : values)
            out.push_back(static_cast<std::uint32_t>(value));
        file.write(std::as_bytes(std::span(out)));
    };
    words({0x46546c67, 2, total, json.size(), 0x4e4f534a});
    file.write(std::as_bytes(std::span(json)));
    words({data, 0x004e4942});
    for (const Mesh& mesh : meshes) {
        file.write(std::as_bytes(std::span(mesh.positions)));
        file.write(std::as_bytes(std::span(mesh.corners)));
    }
    file.commit();
}

/// Trees on level ground, or, if they are rooted, on hills that their trunks go into.
void write_trees(const std::filesystem::path& path, std::uint32_t trees, double tree_triangles,
                 bool rooted)
{
    std::vector<Mesh> meshes{tree(tree_triangles)};
    std::string nodes = tree_nodes(trees, rooted);
    if (rooted) {
        const float side = std::ceil(std::sqrt(static_cast<float>(trees)));
        const auto squares = static_cast<std::uint32_t>(std::min(1000.0f, side));
        append_grid(meshes.emplace_back(), squares, squares, [side](float u, float v) {
            const float x = (side + 2) * u - 1, z = (side + 2) * v - 1;
            return glm::vec3(x, hill(x, z), z);
        });
        nodes += R"(,{"mesh":1})";
    }
    write_glb(path, meshes, header_json(meshes, nodes, trees + (rooted ? 1u : 0u)));
}

int large_scene(const std::string& kind, double count, const std::filesystem::path& path,
                double tree_triangles)
{
    if (kind == "forest" || kind == "wood") {
        write_trees(path, static_cast<std::uint32_t>(count), tree_triangles, kind == "wood");
        return kExitDone;
    }
    const std::vector<Mesh> meshes{kind == "terrain"   ? terrain(count)
                                   : kind == "objects" ? objects(count)
                                                       : soup(count)};
    write_glb(path, meshes, header_json(meshes, R"({"mesh":0})", 1));
    return kExitDone;
}

} // namespace

} // namespace hipmap

int main(int argc, char** argv)
{
    return hipmap::run_tool([&] {
        std::string kind;
        double count = 0, tree_triangles = 10000;
        std::filesystem::path path;
        CLI::App app("Writes a large scene.", "large_scene");
        app.add_option("KIND", kind, "What to write")
            ->required()
            ->check(CLI::IsMember({"terrain", "objects", "soup", "forest", "wood"}));
        app.add_option("COUNT", count, "Triangles, or trees of a forest or wood")
            ->required()
            ->check(hipmap::finite_in(12, 2e8));
        app.add_option("OUT", path, "The .glb file")->required();
        app.add_option("TREE", tree_triangles, "Triangles of a tree [10000]")
            ->check(hipmap::finite_in(100, 1e7));
        if (const std::optional<int> code = hipmap::parse_arguments(app, argc, argv))
            return *code;
        return hipmap::large_scene(kind, count, path, tree_triangles);
    });
}
