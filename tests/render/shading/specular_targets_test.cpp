#include "common/math/sampling.h"
#include "render/shading/specular_targets.h"
#include "tests/support/statistics.h"
#include "tests/support/tiny_rooms.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

bool holds(const TargetSphere& sphere, const TriangleMesh& mesh, FaceId face)
{
    const glm::uvec3 corners = mesh.corners[face];
    for (int c = 0; c < 3; ++c)
        if (glm::distance(mesh.positions[corners[c]], sphere.centre) > sphere.radius)
            return false;
    return true;
}

/// Whether a ray from `origin` meets the ball of radius r about c.
bool meets(const glm::vec3& origin, const glm::vec3& direction, const glm::vec3& c, float r)
{
    const glm::vec3 way = c - origin;
    const glm::vec3 across = glm::cross(way, direction);
    return glm::dot(across, across) < r * r &&
           (glm::dot(way, direction) > 0 || glm::dot(way, way) < r * r);
}

const std::vector<TargetSphere> kOverlapping = {
    {{1, 0, 0}, 0.5f}, {{1.2f, 0.3f, 0}, 0.4f}, {{-2, 0, 0}, 0.1f}, {{0, 40, 0}, 0.01f}};

} // namespace

TEST_CASE("specular targets hold every face with a specular lobe, and no scene without has any",
          "[photons]")
{
    const auto ready = tiny::ready(tiny::room());
    const TriangleMesh& mesh = ready->scene.mesh;
    const std::vector<TargetSphere> targets = ready->render->specular_targets;
    CHECK(targets.size() == 2); // the balls
    for (FaceId face = 0; face < mesh.face_count(); ++face) {
        const Bsdf& bsdf = ready->render->bsdfs[mesh.material_of_face[face]];
        const bool specular = bsdf.is_specular;
        const bool held = std::any_of(targets.begin(), targets.end(), [&](const TargetSphere& at) {
            return holds(at, mesh, face);
        });
        CHECK((!specular || held));
    }
    CHECK(tiny::ready(tiny::furnace())->render->specular_targets.empty());
}

TEST_CASE("specular targets: aimed directions measure solid angles, from outside and inside",
          "[photons]")
{
    for (const glm::vec3& origin : {glm::vec3(0), glm::vec3(1.1f, 0.1f, 0), glm::vec3(0, 0, 9)})
        for (const TargetSphere& ball : kOverlapping) {
            RunningMean mean;
            for (std::uint64_t i = 0; i < 20000; ++i) {
                RandomSequence random(5, RandomStream::caustics, 0, i);
                const AimedRay aimed = aim_from_point(kOverlapping, origin, {}, random);
                CHECK(std::abs(glm::length(aimed.direction) - 1) < 1e-5f);
                const bool hit = meets(origin, aimed.direction, ball.centre, ball.radius);
                mean.add(hit ? aimed.weight : 0);
            }
            const double distance = glm::distance(origin, ball.centre);
            const double sine = ball.radius / distance;
            const double truth = sine >= 1 ? 4 * kPi : 2 * kPi * (1 - std::sqrt(1 - sine * sine));
            INFO("from " << origin.x << ", solid angle " << truth << ", found " << mean.mean());
            // A far small ball may be hit by no ray: then nothing can be said of it.
            CHECK((mean.mean() == 0 || std::abs(mean.z_score(truth)) < kMostZ));
            CHECK((mean.mean() > 0 || truth < 1e-5));
        }
}

TEST_CASE("specular targets: parallel light measures their cross sections", "[photons]")
{
    const glm::vec3 direction = glm::normalize(glm::vec3(0.5f, -1, 0.2f));
    for (const TargetSphere& ball : kOverlapping) {
        RunningMean mean;
        for (std::uint64_t i = 0; i < 20000; ++i) {
            RandomSequence random(6, RandomStream::caustics, 0, i);
            const AimedPoint aimed = aim_parallel(kOverlapping, direction, random);
            const glm::vec3 across = glm::cross(aimed.position - ball.centre, direction);
            mean.add(glm::length(across) < ball.radius ? aimed.weight : 0);
        }
        const double truth = kPi * ball.radius * ball.radius;
        CHECK((mean.mean() == 0 || std::abs(mean.z_score(truth)) < kMostZ));
        CHECK((mean.mean() > 0 || truth < 1e-3));
    }
}
