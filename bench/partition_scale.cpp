// How the cost of preprocess grows with the mesh: seconds, seconds of all threads, and peak bytes
// per triangle of every pass, beside OpenMesh building the same mesh and tinygltf and our loader
// reading it as a file.
//
//     partition_scale [TRIANGLES...]      default: 100000 1000000
//     partition_scale --scene FILE        of a scene file, and how its bytes grow pass by pass

#include "bench/memory_meter.h"
#include "common/command_line/command_line.h"
#include "common/file/output_file.h"
#include "common/scene/load_scene.h"
#include "common/stopwatch.h"
#include "preprocess/mesh/half_edges.h"
#include "preprocess/partition/build_partition.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <glm/gtc/constants.hpp>
#include <tiny_gltf.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <filesystem>

namespace hipmap {

namespace {

/// A grid of n by n squares, place(u, v) with u and v from 0 to 1.
template <typename Place>
TriangleMesh grid(std::uint32_t n, bool closed, const Place& place)
{
    TriangleMesh mesh;
    const std::uint32_t columns = closed ? n : n + 1;
    for (std::uint32_t j = 0; j <= n; ++j)
        for (std::uint32_t i = 0; i < columns; ++i)
            mesh.positions.push_back(place(float(i) / float(n), float(j) / float(n)));
    for (std::uint32_t j = 0; j < n; ++j)
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t a = j * columns + i, b = j * columns + (i + 1) % columns;
            mesh.corners.emplace_back(a, b, b + columns);
            mesh.corners.emplace_back(a, b + columns, a + columns);
        }
    mesh.normals.resize(mesh.positions.size());
    mesh.material_of_face.assign(mesh.face_count(), 0);
    mesh.object_of_face.assign(mesh.face_count(), 0);
    mesh.object_names = {"mesh"};
    return mesh;
}

TriangleMesh terrain(std::uint32_t n)
{
    return grid(n, false, [](float u, float v) {
        return glm::vec3(u - 0.5f, 0.02f * std::sin(31 * u) * std::sin(17 * v), v - 0.5f);
    });
}

/// Closed round, open at the poles by less than a face.
TriangleMesh globe(std::uint32_t n)
{
    return grid(n, true, [n](float u, float v) {
        const float phi = glm::two_pi<float>() * u;
        const float theta = glm::pi<float>() * (v * float(n) + 0.5f) / (float(n) + 1);
        return 0.5f * glm::vec3(std::sin(theta) * std::cos(phi), std::cos(theta),
                                std::sin(theta) * std::sin(phi));
    });
}

void build_openmesh(const TriangleMesh& mesh)
{
    OpenMesh::TriMesh_ArrayKernelT<> built;
    built.reserve(mesh.positions.size(), mesh.positions.size() + mesh.face_count(),
                  mesh.face_count());
    for (const glm::vec3& p : mesh.positions)
        built.add_vertex({p.x, p.y, p.z});
    for (const glm::uvec3& c : mesh.corners)
        built.add_face(OpenMesh::VertexHandle(int(c.x)), OpenMesh::VertexHandle(int(c.y)),
                       OpenMesh::VertexHandle(int(c.z)));
    if (built.n_faces() != mesh.face_count())
        throw std::runtime_error("OpenMesh lost faces");
}

/// The mesh as a .glb file of one indexed primitive.
void write_glb(const std::filesystem::path& path, const TriangleMesh& mesh)
{
    const std::size_t positions = mesh.positions.size() * sizeof(glm::vec3);
    const std::size_t indices = mesh.corners.size() * sizeof(glm::uvec3);
    const auto number = [](std::size_t n) { return std::to_string(n); };
    std::string json =
        R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)"
        R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],)"
        R"("accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":)" +
        number(mesh.positions.size()) +
        R"(,"min":[-1,-1,-1],"max":[1,1,1]},{"bufferView":1,"componentType":5125,)"
        R"("type":"SCALAR","count":)" +
        number(3 * mesh.corners.size()) + R"(}],"bufferViews":[{"buffer":0,"byteLength":)" +
        number(positions) + R"(},{"buffer":0,"byteOffset":)" + number(positions) +
        R"(,"byteLength":)" + number(indices) + R"(}],"buffers":[{"byteLength":)" +
        number(positions + indices) + "}]}";
    json.resize((json.size() + 3) / 4 * 4, ' ');
    std::vector<std::byte> bytes(28 + json.size() + positions + indices);
    std::byte* out = bytes.data();
    const auto append = [&](const void* data, std::size_t size) {
        std::memcpy(out, data, size);
        out += size;
    };
    const auto word = [&](std::size_t value) {
        const auto w = static_cast<std::uint32_t>(value);
        append(&w, 4);
    };
    for (const std::size_t w : {std::size_t{0x46546c67}, std::size_t{2}, bytes.size(), json.size(),
                                std::size_t{0x4e4f534a}})
        word(w);
    append(json.data(), json.size());
    word(positions + indices);
    word(0x004e4942);
    append(mesh.positions.data(), positions);
    append(mesh.corners.data(), indices);
    write_file(path, bytes);
}

void read_by_tinygltf(const std::filesystem::path& path)
{
    tinygltf::TinyGLTF reader;
    tinygltf::Model model;
    std::string error, warning;
    if (!reader.LoadBinaryFromFile(&model, &error, &warning, path.string()))
        throw std::runtime_error("tinygltf: " + error);
}

/// What something takes.
struct Time {
    double wall = 0.0;    ///< s
    double threads = 0.0; ///< s, of all threads: says more on a machine that others use
};

Time operator-(const Time& l, const Time& r)
{
    return {l.wall - r.wall, l.threads - r.threads};
}

Time since(const Stopwatch& watch)
{
    return {watch.seconds(), static_cast<double>(std::clock()) / CLOCKS_PER_SEC};
}

void print_row(const char* name, const Time& time, std::size_t peak, std::size_t faces)
{
    const double per_face = 1e6 / double(faces);
    std::printf("  %-26s %9.3f s  %7.3f us  %7.3f us of threads  %7.0f bytes\n", name, time.wall,
                time.wall * per_face, time.threads * per_face, double(peak) / double(faces));
}

template <typename Work>
Time measure(const char* name, std::size_t faces, const Work& work)
{
    const std::size_t before = memory_in_use();
    start_memory_peak();
    const Stopwatch watch;
    const Time start = since(watch);
    work();
    const Time time = since(watch) - start;
    print_row(name, time, memory_peak() - before, faces);
    return time;
}

/// Prints what each pass of build_partition takes; returns the time of all and of adjacency.
std::pair<Time, Time> measure_passes(const Scene& scene)
{
    const std::size_t faces = scene.mesh.face_count();
    std::size_t peak = 0;
    const std::size_t before = memory_in_use();
    start_memory_peak();
    const Stopwatch watch;
    const Time start = since(watch);
    Time last = start, adjacency;
    PartitionOptions options;
    options.after_pass = [&](const PartitionPass& pass) {
        const Time now = since(watch);
        print_row(std::string(pass.name).c_str(), now - last, memory_peak() - before, faces);
        peak = std::max(peak, memory_peak() - before);
        if (pass.name == "find half-edges")
            adjacency = now - start;
        start_memory_peak();
        last = now;
    };
    build_partition(scene, options);
    const Time whole = since(watch) - start;
    print_row("build_partition in all", whole, peak, faces);
    return {whole, adjacency};
}

void measure_mesh(const char* name, TriangleMesh&& made, const std::filesystem::path& folder)
{
    Scene scene;
    scene.mesh = std::move(made);
    scene.materials.resize(1);
    scene.cameras.resize(1);
    const std::size_t faces = scene.mesh.face_count();
    std::printf("%s, %zu triangles: in all, a triangle, peak a triangle\n", name, faces);

    const std::filesystem::path file = folder / "mesh.glb";
    write_glb(file, scene.mesh);
    measure("tinygltf reads it", faces, [&] { read_by_tinygltf(file); });
    measure("our loader reads it", faces, [&] { load_scene(file, {}); });
    const Time openmesh = measure("OpenMesh builds it", faces, [&] { build_openmesh(scene.mesh); });
    const auto [whole, adjacency] = measure_passes(scene);
    std::printf("  adjacency %.2f, all %.2f times OpenMesh; of threads %.2f and %.2f times\n",
                adjacency.wall / openmesh.wall, whole.wall / openmesh.wall,
                adjacency.threads / openmesh.threads, whole.threads / openmesh.threads);
}
int measure_scene(const std::filesystem::path& file)
{
    LoadedScene loaded;
    const std::size_t faces = load_scene(file, {}).scene.mesh.face_count();
    std::printf("%s, %zu triangles: in all, a triangle, peak a triangle\n", file.c_str(), faces);
    measure("our loader reads it", faces, [&] { loaded = load_scene(file, {}); });
    std::printf("  %-26s %67.0f bytes\n", "the scene itself",
                double(memory_in_use()) / double(faces));
    measure_passes(loaded.scene);
    return kExitDone;
}

int partition_scale(const std::vector<double>& sizes)
{
    const std::filesystem::path folder = std::filesystem::temp_directory_path() /
                                         ("hipmap-partition-scale-" + std::to_string(getpid()));
    std::filesystem::create_directories(folder);
    for (const double size : sizes) {
        const auto n = static_cast<std::uint32_t>(std::lround(std::sqrt(size / 2)));
        measure_mesh("terrain", terrain(n), folder);
        measure_mesh("globe", globe(n), folder);
    }
    std::filesystem::remove_all(folder);
    return kExitDone;
}

} // namespace

} // namespace hipmap

int main(int argc, char** argv)
{
    return hipmap::run_tool([&] {
        std::vector<double> sizes{1e5, 1e6};
        std::filesystem::path scene;
        CLI::App app("Measures how the cost of a partition grows with its mesh.",
                     "partition_scale");
        app.add_option("TRIANGLES", sizes, "Sizes of the meshes [100000 1000000]")
            ->check(hipmap::finite_in(8, 2e8));
        app.add_option("--scene", scene, "A scene file to measure instead");
        if (const std::optional<int> code = hipmap::parse_arguments(app, argc, argv))
            return *code;
        return scene.empty() ? hipmap::partition_scale(sizes) : hipmap::measure_scene(scene);
    });
}
