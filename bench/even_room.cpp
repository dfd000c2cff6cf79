#include "bench/even_room.h"

#include "common/math/frame.h"
#include "common/math/random.h"
#include "common/math/sampling.h"
#include "common/rays/surface_point.h"
#include "preprocess/partition/build_partition.h"

namespace hipmap {

namespace {

/// Fronts inward; the floor, z = 0, is the first two faces.
TriangleMesh unit_room()
{
    TriangleMesh mesh;
    for (int i = 0; i < 8; ++i)
        mesh.positions.emplace_back(i & 1, i >> 1 & 1, i >> 2 & 1);
    constexpr std::uint32_t kWalls[6][4] = {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 2, 6, 4},
                                            {1, 5, 7, 3}, {0, 4, 5, 1}, {2, 3, 7, 6}};
    for (const auto& w : kWalls) {
        mesh.corners.emplace_back(w[0], w[1], w[2]);
        mesh.corners.emplace_back(w[0], w[2], w[3]);
    }
    mesh.normals.assign(mesh.positions.size(), glm::vec3(0.0f));
    mesh.material_of_face.assign(mesh.face_count(), 0);
    mesh.object_of_face.assign(mesh.face_count(), 0);
    return mesh;
}

std::vector<Photon> even_photons(const TriangleMesh& mesh, const EvenRoomOptions& options,
                                 std::uint64_t set)
{
    std::vector<Photon> photons;
    for (std::size_t i = 0; i < options.photons; ++i) {
        RandomSequence random(0, RandomStream::photons, static_cast<std::uint32_t>(set), i);
        const std::size_t wall = i % 6;
        if (options.dark_floor && wall == 0)
            continue;
        const auto face = static_cast<FaceId>(2 * wall + (random.next() < 0.5f ? 0 : 1));
        const SurfacePoint at = surface_point(mesh, face, sample_triangle(random.next2()));
        const float power = 6.0f / static_cast<float>(options.photons);
        const glm::vec3 from =
            Frame(at.geometric_normal).to_world(sample_cosine_hemisphere(random.next2()));
        photons.push_back({at.position, Rgb(power), from, face, 0});
    }
    return photons;
}

} // namespace

std::vector<std::vector<double>> estimates_in_even_room(const std::vector<glm::vec2>& points,
                                                        const EvenRoomOptions& options)
{
    Scene scene;
    scene.mesh = unit_room();
    const Partition partition = build_partition(scene, {}).partition;
    const MapSurfaces surfaces(scene.mesh, partition);
    ChosenScratch scratch;
    std::vector<std::vector<double>> estimates(points.size());
    for (std::size_t set = 0; set < options.sets; ++set) {
        const ChosenMaps maps = build_chosen_maps(even_photons(scene.mesh, options, set), surfaces,
                                                  options.maps, options.dissertation);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const FaceId face = points[i].y <= points[i].x ? 0 : 1;
            const PhotonQuery query{glm::vec3(points[i], 0), {0, 0, 1}, face, 0};
            estimates[i].push_back(estimate_irradiance(maps, surfaces, query, scratch).y);
        }
    }
    return estimates;
}

} // namespace hipmap
