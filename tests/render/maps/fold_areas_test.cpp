#include "common/math/sampling.h"
#include "common/rays/surface_point.h"
#include "render/maps/estimate.h"
#include "tests/support/hard_surfaces.h"
#include "tests/support/instruction_sets.h"
#include "tests/support/statistics.h"
#include "tests/support/tiny_scenes.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace hipmap;

namespace {

struct BothAreas {
    FoldAreas surface{}, projection{};
};

/// The areas within three radii by many points on each face of the query's map.
BothAreas by_points(const MapSurfaces& surfaces, const PhotonQuery& query,
                    const std::array<float, 3>& radii)
{
    constexpr std::uint64_t kPoints = 400'000;
    constexpr double kGolden = 0.618033988749895;
    const TriangleMesh& mesh = surfaces.mesh;
    const std::uint64_t of_face = 1 + kPoints / mesh.face_count();
    BothAreas out;
    for (FaceId face = 0; face < mesh.face_count(); ++face) {
        const double along = glm::dot(surfaces.normals[face], query.normal);
        if (!(along > 0) ||
            surfaces.partition.map_of(face) != surfaces.partition.map_of(query.face))
            continue;
        const double each = face_area(mesh, face) / static_cast<double>(of_face);
        for (std::uint64_t i = 0; i < of_face; ++i) {
            const auto n = static_cast<double>(i);
            const glm::vec2 uv((n + 0.5) / static_cast<double>(of_face),
                               std::fmod(0.5 + kGolden * n, 1.0));
            const glm::vec3 at = surface_point(mesh, face, sample_triangle(uv)).position;
            for (std::size_t r = 0; r < radii.size(); ++r)
                if (glm::distance(at, query.position) <= radii[r]) {
                    out.surface[r] += each;
                    out.projection[r] += each * along;
                }
        }
    }
    return out;
}

struct Shape {
    TriangleMesh mesh;
    double error; ///< of an area, root of the mean square
};

TriangleMesh ellipsoid(std::uint32_t segments, const glm::vec3& half_axes)
{
    TriangleMesh mesh = tiny::uv_sphere(segments, segments / 2);
    for (glm::vec3& position : mesh.positions)
        position *= half_axes;
    return mesh;
}

std::vector<Shape> shapes()
{
    return {{tiny::uv_sphere(24, 13), 0.01},       {tiny::uv_sphere(200, 100), 0.025},
            {tiny::torus(64, 16, 0.2f), 0.03},     {tiny::torus(200, 40, 0.1f), 0.025},
            {tiny::torus(6, 300, 0.1f), 0.04},     {ellipsoid(48, {2, 0.1f, 0.1f}), 0.025},
            {tiny::thin_shell(300, 0.05f), 0.025}, {tiny::hairpin(8, 0.1f), 0.025},
            {tiny::hairpin(64, 0.3f), 0.025}};
}

} // namespace

TEST_CASE("fold areas: those of points on the faces that look to the side", "[maps]")
{
    RandomSequence random(3, RandomStream::photons, 0, 0);
    for (const Shape& shape : shapes()) {
        const auto ready = tiny::ready(tiny::make_scene(shape.mesh));
        const MapSurfaces surfaces(shape.mesh, ready->partition);
        const auto faces = static_cast<float>(shape.mesh.face_count());
        RunningMean off, off2;
        for (int i = 0; i < 12; ++i) {
            const auto face = static_cast<FaceId>(random.next() * faces);
            REQUIRE(surfaces.may_fold(face));
            const SurfacePoint at =
                surface_point(shape.mesh, face, sample_triangle(random.next2()));
            const float widest = 0.1f * std::pow(20.0f, random.next());
            const std::array<float, 3> radii{widest, 0.75f * widest, 0.5f * widest};
            const BothAreas truth =
                by_points(surfaces, {at.position, surfaces.normals[face], face, 0}, radii);
            const FoldAreas surface =
                surfaces.facing_areas(face, at.position, radii, AreaOf::surface);
            const FoldAreas projection =
                surfaces.facing_areas(face, at.position, radii, AreaOf::projection);
            for (std::size_t r = 0; r < radii.size(); ++r)
                for (const double error :
                     {surface[r] / truth.surface[r] - 1, projection[r] / truth.projection[r] - 1}) {
                    off.add(error);
                    off2.add(error * error);
                }
        }
        INFO(shape.mesh.face_count()
             << " faces, mean " << off.mean() << ", rms " << std::sqrt(off2.mean()));
        CHECK(std::sqrt(off2.mean()) < shape.error);
        CHECK(std::abs(off.mean()) < 0.015);
    }
}

TEST_CASE("fold areas: part of a triangle within a radius", "[maps]")
{
    RandomSequence random(5, RandomStream::photons, 0, 0);
    const auto corner = [&] { return glm::vec3(random.next(), random.next(), random.next()); };
    for (int i = 0; i < 100; ++i) {
        const TriangleMesh mesh = tiny::make_mesh({corner(), corner(), corner()}, {{0, 1, 2}});
        const glm::vec3 point(i % 3 == 0 ? mesh.positions[0] : corner());
        const float radius = 0.8f * random.next();
        const auto ready = tiny::ready(tiny::make_scene(mesh));
        const FoldTrees trees = build_fold_trees(mesh, ready->partition, std::array{0u});
        const glm::vec3 normal(glm::normalize(scaled_normal(mesh, 0)));
        const double found =
            fold_areas(trees, {0, point, normal, AreaOf::surface}, {&radius, 1})[0];
        constexpr int kPoints = 20'000;
        int inside = 0;
        for (int k = 0; k < kPoints; ++k) {
            const glm::vec2 uv((k + 0.5) / kPoints, std::fmod(0.618033988749895 * k, 1.0));
            const glm::vec3 at = surface_point(mesh, 0, sample_triangle(uv)).position;
            inside += glm::distance(at, point) <= radius ? 1 : 0;
        }
        const double area = face_area(mesh, 0);
        CHECK(found == Approx(area * inside / kPoints).margin(0.004 * area));
    }
}

TEST_CASE("fold areas: of more slivers than may be opened, no more than there are", "[maps]")
{
    const TriangleMesh mesh = tiny::torus(6, 4000, 0.1f);
    const auto ready = tiny::ready(tiny::make_scene(mesh));
    const MapSurfaces surfaces(mesh, ready->partition);
    RandomSequence random(7, RandomStream::photons, 0, 0);
    for (int i = 0; i < 100; ++i) {
        const auto face =
            static_cast<FaceId>(random.next() * static_cast<float>(mesh.face_count()));
        const SurfacePoint at = surface_point(mesh, face, sample_triangle(random.next2()));
        const std::array<float, 3> radii{2 * random.next(), 0.05f, 0.02f};
        for (const AreaOf of : {AreaOf::surface, AreaOf::projection})
            for (const double area : surfaces.facing_areas(face, at.position, radii, of)) {
                CHECK(area > 0);
                CHECK(area < 1.001 * surfaces.area_at(face));
            }
    }
}

TEST_CASE("fold areas: the same bits on every processor", "[maps]")
{
    const TriangleMesh mesh = ellipsoid(48, {1, 0.5f, 0.1f});
    const auto ready = tiny::ready(tiny::make_scene(mesh));
    const MapSurfaces surfaces(mesh, ready->partition);
    const auto areas_of = [&](FaceId face) {
        const SurfacePoint at = surface_point(mesh, face, {0.3f, 0.3f});
        return surfaces.facing_areas(face, at.position, std::array{0.4f, 0.3f, 0.1f},
                                     face % 2 == 0 ? AreaOf::surface : AreaOf::projection);
    };
    std::vector<FoldAreas> first;
    for (FaceId face = 0; face < mesh.face_count(); ++face)
        first.push_back(areas_of(face));
    with_each_instruction_set([&] {
        for (FaceId face = 0; face < mesh.face_count(); ++face)
            CHECK(areas_of(face) == first[face]);
    });
}

TEST_CASE("fold areas: the same where faces are turned round", "[maps]")
{
    const TriangleMesh mesh = tiny::torus(64, 16, 0.2f);
    TriangleMesh turned = mesh;
    for (FaceId face = 1; face < mesh.face_count(); face += 3)
        std::swap(turned.corners[face].y, turned.corners[face].z);
    const auto ready = tiny::ready(tiny::make_scene(mesh));
    const auto ready_turned = tiny::ready(tiny::make_scene(turned));
    const MapSurfaces surfaces(mesh, ready->partition);
    const MapSurfaces surfaces_turned(turned, ready_turned->partition);
    REQUIRE(ready_turned->partition.is_flipped(1) != ready_turned->partition.is_flipped(0));
    const std::array<float, 3> radii{0.3f, 0.2f, 0.1f};
    for (FaceId face = 0; face < mesh.face_count(); ++face) {
        REQUIRE(surfaces.may_fold(face));
        REQUIRE(surfaces_turned.may_fold(face));
        const glm::vec3 at = surface_point(mesh, face, {0.3f, 0.3f}).position;
        const FoldAreas expected = surfaces.facing_areas(face, at, radii, AreaOf::surface);
        const FoldAreas found = surfaces_turned.facing_areas(face, at, radii, AreaOf::surface);
        for (std::size_t r = 0; r < radii.size(); ++r)
            CHECK(found[r] == Approx(expected[r]).epsilon(1e-3));
    }
}
