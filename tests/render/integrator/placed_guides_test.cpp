#include "common/math/frame.h"
#include "render/integrator/integrators.h"
#include "render/integrator/placed_guides.h"
#include "render/integrator/sky_guide.h"
#include "tests/support/one_map.h"
#include "tests/support/statistics.h"
#include "tests/support/tiny_rooms.h"

#include <catch2/catch.hpp>
#include <tbb/global_control.h>

using namespace hipmap;

namespace {

/// A room with a strip open to the sky along one wall.
Scene room_below_a_lid()
{
    TriangleMesh mesh = tiny::open_box();
    tiny::turn_inside_out(mesh);
    Scene scene = tiny::make_scene(mesh);
    scene.materials[0] = tiny::diffuse(Rgb(0.5f));
    TriangleMesh lid = tiny::floor_at(0.49f, -0.8f);
    tiny::move(lid, {0.1f, 0, 0});
    tiny::add(scene, lid, tiny::diffuse(Rgb(0.5f)));
    scene.cameras[0].position = {0, 0, 0.48f};
    scene.environment = Rgb(3);
    return scene;
}

RenderOptions small_options(GatherDirections gather,
                            Integrator integrator = Integrator::progressive)
{
    RenderOptions options;
    options.integrator = integrator;
    options.width = options.height = 32;
    options.photons = 20000;
    options.samples = 4;
    options.gather = gather;
    return options;
}

struct GatheredMeans {
    RunningMean radiance;
    RunningMean noise; ///< square of the relative difference of a pixel between two passes
};

GatheredMeans mean_of_passes(const tiny::ReadyScene& ready, GatherDirections gather,
                             Integrator integrator)
{
    RenderStatistics ignored;
    const RenderOptions options = small_options(gather, integrator);
    const PassSource source = make_pass_source(*ready.render, options, ignored);
    GatheredMeans out;
    Image last;
    for (std::uint64_t pass = 0; pass < 12; ++pass) {
        const Image now = source.render(pass, {}).images.radiance;
        for (std::size_t i = 0; i < last.pixels.size(); ++i) {
            const Rgb off = now.pixels[i] - last.pixels[i];
            out.noise.add(glm::dot(off, off) / (1e-4 + glm::dot(last.pixels[i], last.pixels[i]) +
                                                glm::dot(now.pixels[i], now.pixels[i])));
        }
        last = now;
        out.radiance.add(mean_of(now));
    }
    return out;
}

/// Checks that guides leave the light of passes as it is and lessen their noise.
void check_guided(Integrator integrator)
{
    const auto room = tiny::ready(room_below_a_lid());
    const GatheredMeans guided = mean_of_passes(*room, GatherDirections::guided, integrator);
    const GatheredMeans by_lobes = mean_of_passes(*room, GatherDirections::by_lobes, integrator);
    const double noise =
        std::hypot(guided.radiance.standard_error(), by_lobes.radiance.standard_error());
    CHECK(std::abs(guided.radiance.mean() - by_lobes.radiance.mean()) < kMostZ * noise);
    CHECK(kMostZ * noise < 0.1 * by_lobes.radiance.mean());
    CHECK(guided.noise.mean() < 0.8 * by_lobes.noise.mean());
}

/// Records of one face, drawn by a Lambertian lobe about +y; light comes from within a cone alone.
std::vector<GatherRecord> records_below(const glm::vec3& window, float cosine, std::size_t count)
{
    std::vector<GatherRecord> out;
    RandomSequence random(1, RandomStream::pictures, 0, 0);
    for (std::size_t i = 0; i < count; ++i) {
        GatherRecord record{.at = {{random.next(), 0, random.next()}, 0}};
        record.direction =
            Frame(glm::vec3(0, 1, 0)).to_world(sample_cosine_hemisphere(random.next2()));
        record.pdf = record.direction.y / kPi;
        record.light = glm::dot(record.direction, window) > cosine ? 1.0f : 0.0f;
        out.push_back(record);
    }
    return out;
}

PhotonQuery query_on_side(std::uint8_t side)
{
    PhotonQuery out;
    out.position = {0.5f, 0, 0.5f};
    out.face = 0;
    out.side = side;
    return out;
}

} // namespace

TEST_CASE("gather guide: rays go where records found light", "[integrator]")
{
    const glm::vec3 window = glm::normalize(glm::vec3(1, 0.7f, 0));
    std::vector<GatherRecord> records = records_below(window, 0.95f, 4000);
    const Partition partition = tiny::one_map();
    const PlacedGuides guide = learn_directions(partition, records);
    const DirectionGuide* const found = directions_at(guide, partition, query_on_side(0));
    REQUIRE(found != nullptr);
    RandomSequence random(2, RandomStream::pictures, 0, 0);
    int inside = 0;
    for (int i = 0; i < 1000; ++i)
        inside += glm::dot(draw(*found, random.next2()), window) > 0.95f ? 1 : 0;
    CHECK(inside > 350); // the grid is coarse; by the lobe 14
    CHECK(directions_at(guide, partition, query_on_side(1)) == nullptr);
}

TEST_CASE("gather guide: there is none where lobes are as good, or nothing is known",
          "[integrator]")
{
    const Partition partition = tiny::one_map();
    std::vector<GatherRecord> even = records_below({0, 1, 0}, -1, 4000), none;
    CHECK(learn_directions(partition, even).values.empty());
    CHECK(learn_directions(partition, none).values.empty());
    std::vector<GatherRecord> dark = records_below({0, 1, 0}, 2, 4000);
    CHECK(learn_directions(partition, dark).values.empty());
}

TEST_CASE("gather guide: the image is that of rays by the lobes, with less noise", "[integrator]")
{
    check_guided(Integrator::progressive);
}

TEST_CASE("sky guide: where little of the sky is seen, its samples go there", "[integrator]")
{
    const auto room = tiny::ready(room_below_a_lid());
    const FaceId floor = room->render->rays.nearest({.direction = {0, -1, 0}})->face;
    const PhotonQuery query{{0.1f, -0.5f, 0}, {0, 1, 0}, floor, 0};
    RandomSequence random(4, RandomStream::pictures, 0, 0);
    std::vector<Photon> importons;
    for (int i = 0; i < 2000; ++i) {
        const glm::vec3 place{random.next() - 0.5f, -0.5f, random.next() - 0.5f};
        importons.push_back({place, Rgb(1), query.normal, floor, query.side});
    }
    const PlacedGuides guide = learn_sky(*room->render, importons, 1);
    const DirectionGuide* const found = directions_at(guide, room->partition, query);
    REQUIRE(found != nullptr);
    const auto sees_sky = [&](const glm::vec3& direction) {
        Ray ray;
        ray.origin = query.position + 1e-4f * query.normal;
        ray.direction = direction;
        return !room->render->rays.nearest(ray);
    };
    int by_guide = 0, by_cosine = 0;
    for (int i = 0; i < 1000; ++i) {
        by_guide += sees_sky(draw(*found, random.next2())) ? 1 : 0;
        by_cosine +=
            sees_sky(Frame(query.normal).to_world(sample_cosine_hemisphere(random.next2())));
    }
    INFO(by_guide << " and by the cosine " << by_cosine);
    CHECK(by_guide > 2 * by_cosine);
    Scene open = tiny::diffuse_floor();
    open.environment = Rgb(3);
    for (Photon& importon : importons)
        importon.face = 0;
    CHECK(learn_sky(*tiny::ready(open)->render, importons, 1).values.empty());
    CHECK(learn_sky(*room->render, {}, 1).values.empty());
}

TEST_CASE("gather guide: a pass has the same bits by however many threads", "[integrator]")
{
    const auto room = tiny::ready(room_below_a_lid());
    const RenderOptions options = small_options(GatherDirections::guided);
    const auto second_pass = [&](std::size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        RenderStatistics ignored;
        return make_pass_source(*room->render, options, ignored).render(2, {}).images;
    };
    const PassImages one = second_pass(1);
    CHECK(mean_of(one.radiance) > 0);
    for (const std::size_t threads : {2, 7})
        CHECK(one.radiance.pixels == second_pass(threads).radiance.pixels);
}

TEST_CASE("sky guide: direct estimates are those without it, with less noise", "[integrator]")
{
    check_guided(Integrator::direct);
}
