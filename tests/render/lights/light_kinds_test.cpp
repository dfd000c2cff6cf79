#include "common/math/sampling.h"
#include "render/lights/emission.h"
#include "tests/support/statistics.h"
#include "tests/support/tiny_media.h"
#include "tests/support/tiny_rooms.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <set>
#include <vector>

using namespace hipmap;

namespace {

enum class Kind {
    point,
    spot,
    web, ///< an IES light
    sphere,
    spot_sphere,
    sun,
    wide_sun,
    rectangle,
    ellipse,
    narrow,     ///< a rectangle with a spread
    beam,       ///< a sheared rectangle of parallel light
    panel,      ///< an emissive mesh of two faces
    ball,       ///< one of many, selected by their tree
    even_world, ///< a constant environment
    image_world,
    emissive_media,
};
const std::vector<Kind> kKinds = {
    Kind::point,       Kind::spot,       Kind::web,         Kind::sphere,
    Kind::spot_sphere, Kind::sun,        Kind::wide_sun,    Kind::rectangle,
    Kind::ellipse,     Kind::narrow,     Kind::beam,        Kind::panel,
    Kind::ball,        Kind::even_world, Kind::image_world, Kind::emissive_media};
const glm::vec3 kMiddle(0.1f, 0.25f, 0.05f); ///< of lights with a place

bool is_one_of(Kind kind, std::initializer_list<Kind> kinds)
{
    return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

/// Light arrives from one direction alone.
bool is_delta(Kind kind)
{
    return is_one_of(kind, {Kind::point, Kind::spot, Kind::web, Kind::sun, Kind::beam});
}

const glm::vec3 kDirection = glm::normalize(glm::vec3(-0.2f, -1, 0.1f));
const glm::vec3 kLight(1, 2, 3); ///< radiant intensity or irradiance

SceneLight punctual_light(Kind kind)
{
    const float radius = is_one_of(kind, {Kind::sphere, Kind::spot_sphere}) ? 0.1f : 0.0f;
    if (is_one_of(kind, {Kind::point, Kind::sphere}))
        return ScenePointLight{
            .name = "", .position = kMiddle, .intensity = kLight, .radius = radius};
    if (is_one_of(kind, {Kind::spot, Kind::spot_sphere}))
        return SceneSpotLight{.name = "",
                              .position = kMiddle,
                              .direction = kDirection,
                              .intensity = kLight,
                              .cos_inner = std::cos(0.4f),
                              .cos_outer = std::cos(0.8f),
                              .radius = radius};
    if (kind == Kind::web)
        return SceneIesLight{.name = "",
                             .position = kMiddle,
                             .direction = kDirection,
                             .start = glm::normalize(glm::cross(kDirection, {1, 0, 0})),
                             .intensity = kLight,
                             .web = {.polar = {0, 0.5, 1.2, 2},
                                     .azimuth = {0, 2, 2 * double{kPi}},
                                     .candela = {1, 1, 1, 2, 0.5, 2, 0.2, 3, 0.2, 0, 1, 0}}};
    return SceneSunLight{.name = "",
                         .direction = kDirection,
                         .irradiance = kLight,
                         .half_angle = kind == Kind::wide_sun ? 0.3f : 0.0f};
}

/// Sheared.
SceneAreaLight area_light(Kind kind)
{
    SceneAreaLight light;
    light.centre = kMiddle;
    light.half_right = {0.15f, 0, 0};
    light.half_up = {0.03f, 0.02f, -0.1f};
    light.direction = -glm::normalize(glm::cross(light.half_right, light.half_up));
    light.is_disc = kind == Kind::ellipse;
    light.radiance = {4, 3, 2};
    if (kind == Kind::narrow)
        light.half_spread = 1.3; // holds kPosition
    return light;
}

/// Wide enough for part of the floor to be beside it, and for kPosition to be in it.
SceneBeamLight beam_light()
{
    SceneBeamLight light;
    light.centre = kMiddle;
    light.right = kMiddle + glm::vec3(0.4f, 0, 0);
    light.up = kMiddle + glm::vec3(0.1f, 0.02f, -0.3f);
    light.direction =
        -glm::normalize(glm::cross(light.right - light.centre, light.up - light.centre));
    light.irradiance = kLight;
    return light;
}

TriangleMesh emissive_mesh(Kind kind)
{
    TriangleMesh mesh = kind == Kind::panel ? tiny::floor_at(0, -0.3f) : tiny::uv_sphere(12, 6);
    if (kind == Kind::ball)
        tiny::scale(mesh, 0.12f);
    tiny::move(mesh, kMiddle);
    return mesh;
}

/// A light of a kind over a diffuse floor of side 1.
Scene lit_scene(Kind kind)
{
    Scene scene = tiny::diffuse_floor();
    if (kind <= Kind::wide_sun)
        scene.lights = {punctual_light(kind)};
    else if (kind <= Kind::narrow)
        scene.lights = {area_light(kind)};
    else if (kind == Kind::beam)
        scene.lights = {beam_light()};
    else if (kind <= Kind::ball)
        tiny::add(scene, emissive_mesh(kind), tiny::emissive({4, 3, 2}));
    else if (kind == Kind::even_world)
        scene.environment = {0.5f, 1, 0.25f};
    else if (kind == Kind::emissive_media) {
        TriangleMesh cube = tiny::cube();
        tiny::scale(cube, 0.2f);
        tiny::move(cube, kMiddle);
        Medium medium;
        medium.emission = {1, 2, 3};
        tiny::add(scene, cube, tiny::fog(medium));
    }
    return scene;
}

EnvironmentMap map_of(Kind kind)
{
    if (kind != Kind::image_world)
        return {};
    Image image(16, 8);
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 16; ++x)
            image.at(x, y) = Rgb(0.2f, 0.4f, 0.3f) * static_cast<float>(1 + (x * y) % 7);
    image.at(3, 1) = Rgb(40);
    return make_environment_map(image, 1, 0.4f);
}

/// A scene, and its one light.
struct LitScene {
    std::unique_ptr<tiny::ReadyScene> ready;
    Light light;

    const RenderScene& scene() const { return *ready->render; }
    const LightSet& lights() const { return ready->render->lights; }
};

LitScene lit(Scene scene, Kind kind)
{
    LitScene out{tiny::ready(std::move(scene)), {}};
    out.ready->render =
        std::make_unique<RenderScene>(out.ready->scene, out.ready->partition, map_of(kind));
    REQUIRE(out.lights().lights.size() == 1);
    out.light = out.lights().lights[0];
    if (kind == Kind::ball)
        out.light = out.lights().faces;
    return out;
}

/// Where a ray meets the light, be it a mesh.
std::optional<LightHit> meet(const LitScene& lit, const Ray& ray)
{
    const auto* mesh = std::get_if<EmissiveMesh>(&lit.light);
    if (mesh == nullptr)
        return intersect(lit.light, ray);
    const std::optional<RayHit> hit = lit.scene().rays.nearest(ray);
    if (!hit)
        return std::nullopt;
    const SurfacePoint point = surface_point(lit.scene().mesh(), hit->face, hit->barycentric);
    const Rgb radiance = radiance_towards(*mesh, {point, hit->barycentric, 0}, -ray.direction);
    if (is_black(radiance))
        return std::nullopt;
    return LightHit{hit->distance, radiance,
                    pdf_li(*mesh, {ray.origin, {0, 1, 0}}, point, ray.direction, hit->distance)};
}

Ray ray_from(const glm::vec3& origin, const glm::vec3& direction)
{
    Ray ray;
    ray.origin = origin;
    ray.direction = direction;
    return ray;
}

/// Irradiance of a point that faces up, by one sample of the light.
double sampled_irradiance(const LitScene& lit, const glm::vec3& position, RandomSequence& random)
{
    const std::optional<LightSample> sample = sample_li(lit.light, {position, {0, 1, 0}}, random);
    return sample ? sample->light.y * std::max(0.0f, sample->direction.y) : 0;
}

/// Irradiance of such a point, by one direction of the whole sphere.
double met_irradiance(const LitScene& lit, const glm::vec3& position, RandomSequence& random)
{
    const Ray ray = ray_from(position, sample_sphere(random.next2()));
    const std::optional<LightHit> hit = meet(lit, ray);
    return hit ? hit->radiance.y * std::max(0.0f, ray.direction.y) * 4 * kPi : 0;
}

void check_equal(const RunningMean& a, const RunningMean& b)
{
    INFO(a.mean() << " +- " << a.standard_error() << " and " << b.mean() << " +- "
                  << b.standard_error());
    CHECK(a.mean() > 0);
    CHECK(std::abs(a.mean() - b.mean()) <
          kMostZ * std::hypot(a.standard_error(), b.standard_error()) + 1e-5 * a.mean());
}

const glm::vec3 kPosition(-0.2f, 0, 0.1f);

} // namespace

TEST_CASE("light kinds: these tests hold for all alternatives of Light", "[lights]")
{
    std::set<std::size_t> alternatives;
    for (const Kind kind : kKinds)
        alternatives.insert(lit(lit_scene(kind), kind).light.index());
    CHECK(alternatives.size() == std::variant_size_v<Light>);
}

TEST_CASE("light kinds: each is known to the queries that may find it", "[lights]")
{
    const Kind kind = GENERATE(from_range(kKinds));
    const LitScene at = lit(lit_scene(kind), kind);
    const LightSet& lights = at.lights();
    INFO("kind " << static_cast<int>(kind));
    const bool analytic = kind <= Kind::beam;
    CHECK((role(at.light) == LightRole::analytic) == analytic);
    CHECK(lights.sampled.size() == (analytic ? 1 : 0));
    CHECK(lights.met.size() == (analytic && !is_delta(kind) ? 1 : 0));
    CHECK(lights.environments.size() ==
          (is_one_of(kind, {Kind::even_world, Kind::image_world}) ? 1 : 0));
    CHECK(lights.faces.empty() == !is_one_of(kind, {Kind::panel, Kind::ball}));
    CHECK(bounds(at.light).has_value() ==
          !is_one_of(kind, {Kind::sun, Kind::wide_sun, Kind::even_world, Kind::image_world,
                            Kind::emissive_media}));
}

TEST_CASE("light kinds: the pdf of a sample is that of a ray that meets the light", "[lights]")
{
    const Kind kind = GENERATE(from_range(kKinds));
    const LitScene at = lit(lit_scene(kind), kind);
    INFO("kind " << static_cast<int>(kind));
    RandomSequence random(7, RandomStream::eye_paths, 0, 0);
    int met = 0;
    for (int i = 0; i < 2000; ++i) {
        const auto sample = sample_li(at.light, {kPosition, {0, 1, 0}}, random);
        if (!sample)
            continue;
        CHECK((sample->pdf == 0) == is_delta(kind));
        const std::optional<LightHit> hit = meet(at, ray_from(kPosition, sample->direction));
        if (!hit) // as rays at the very edge may
            continue;
        ++met;
        CHECK(hit->pdf == Approx(sample->pdf).epsilon(2e-3));
        CHECK((hit->radiance / hit->pdf).y == Approx(sample->light.y).epsilon(2e-3));
    }
    if (is_delta(kind) || is_one_of(kind, {Kind::even_world, Kind::emissive_media}))
        CHECK(met == 0);
    else
        CHECK(met > (kind == Kind::ball ? 500 : 1900)); // some points drawn face away
}

TEST_CASE("light kinds: the pdf integrates to one, or to less where samples are lost", "[lights]")
{
    const Kind kind = GENERATE(from_range(kKinds));
    const LitScene at = lit(lit_scene(kind), kind);
    INFO("kind " << static_cast<int>(kind));
    RunningMean whole;
    RandomSequence random(8, RandomStream::eye_paths, 0, 0);
    for (int i = 0; i < 200'000; ++i) {
        const auto hit = meet(at, ray_from(kPosition, sample_sphere(random.next2())));
        whole.add(hit ? hit->pdf * 4 * kPi : 0);
    }
    if (is_delta(kind) || is_one_of(kind, {Kind::even_world, Kind::emissive_media}))
        CHECK(whole.mean() == 0);
    else if (kind == Kind::ball)
        CHECK(whole.z_score(1) < kMostZ);
    else
        CHECK(std::abs(whole.z_score(1)) < kMostZ);
}

TEST_CASE("light kinds: samples bring the irradiance that uniform directions meet", "[lights]")
{
    const Kind kind =
        GENERATE(Kind::sphere, Kind::spot_sphere, Kind::wide_sun, Kind::rectangle, Kind::ellipse,
                 Kind::narrow, Kind::panel, Kind::ball, Kind::image_world);
    const LitScene at = lit(lit_scene(kind), kind);
    INFO("kind " << static_cast<int>(kind));
    RunningMean sampled, met;
    RandomSequence random(9, RandomStream::eye_paths, 0, 0);
    for (int i = 0; i < 200'000; ++i) {
        if (i < 20'000)
            sampled.add(sampled_irradiance(at, kPosition, random));
        met.add(met_irradiance(at, kPosition, random));
    }
    check_equal(sampled, met);
    CHECK(sampled.standard_error() < 0.02 * sampled.mean());
}

TEST_CASE("light kinds: lights without size bring their irradiance in closed form", "[lights]")
{
    const Kind kind = GENERATE(Kind::point, Kind::spot, Kind::sun, Kind::beam);
    const LitScene at = lit(lit_scene(kind), kind);
    INFO("kind " << static_cast<int>(kind));
    RandomSequence random(9, RandomStream::eye_paths, 0, 0);
    const glm::dvec3 way = glm::dvec3(kMiddle) - glm::dvec3(kPosition);
    const double distance = glm::length(way);
    double truth = 2 * way.y / std::pow(distance, 3);
    if (kind == Kind::spot) {
        const double cosine = -glm::dot(way, glm::dvec3(kDirection)) / distance;
        const double inner = std::cos(0.4), outer = std::cos(0.8);
        truth *= std::pow(std::clamp((cosine - outer) / (inner - outer), 0.0, 1.0), 2);
    }
    if (kind == Kind::sun)
        truth = -2.0 * kDirection.y;
    if (kind == Kind::beam)
        truth = -2.0 * beam_light().direction.y;
    CHECK(sampled_irradiance(at, kPosition, random) == Approx(truth).epsilon(1e-5));
}

TEST_CASE("light kinds: the moments of a sun are those of uniform directions", "[lights]")
{
    const LitScene at = lit(lit_scene(Kind::wide_sun), Kind::wide_sun);
    const std::optional<FarLight> sun = far_light(at.light);
    REQUIRE(sun);
    CHECK(glm::dot(sun->towards, kDirection) == Approx(-1));
    RunningMean first, second;
    RandomSequence random(9, RandomStream::eye_paths, 0, 0);
    for (int i = 0; i < 200'000; ++i) {
        const auto hit = intersect(at.light, ray_from(kPosition, sample_sphere(random.next2())));
        const double light = hit ? max_channel(hit->radiance) : 0;
        first.add(4 * double{kPi} * light);
        second.add(4 * double{kPi} * light * light);
    }
    CHECK(std::abs(first.z_score(sun->first)) < kMostZ);
    CHECK(std::abs(second.z_score(sun->second)) < kMostZ);
    CHECK(std::isinf(far_light(lit(lit_scene(Kind::sun), Kind::sun).light)->second));
    CHECK_FALSE(far_light(lit(lit_scene(Kind::even_world), Kind::even_world).light));
}

TEST_CASE("light kinds: light paths together carry the light's power", "[lights]")
{
    const Kind kind = GENERATE(from_range(kKinds));
    const LitScene at = lit(lit_scene(kind), kind);
    INFO("kind " << static_cast<int>(kind));
    const glm::dvec3 truth = power(at.light);
    constexpr std::uint64_t kPaths = 20'000;
    RunningMean sums[3];
    for (std::uint64_t i = 0; i < kPaths; ++i) {
        RandomSequence random(3, RandomStream::photons, 0, i);
        const EmittedPath path = sample_emission(at.light, {i, kPaths}, random);
        CHECK(path.from_medium == (kind == Kind::emissive_media));
        for (int c = 0; c < 3; ++c)
            sums[c].add(path.power[c]);
    }
    // The power of media is itself a mean of 1024 lines.
    const double lines = kind == Kind::emissive_media ? std::sqrt(1 + kPaths / 1024.0) : 1;
    for (int c = 0; c < 3; ++c) {
        INFO("channel " << c << ": " << sums[c].mean() << " and " << truth[c]);
        CHECK(truth[c] > 0);
        CHECK(std::abs(sums[c].mean() - truth[c]) <
              kMostZ * lines * sums[c].standard_error() + 1e-5 * truth[c]);
    }
}

TEST_CASE("light kinds: light paths bring a floor the light that samples bring", "[lights]")
{
    const Kind kind = GENERATE(from_range(kKinds));
    if (kind == Kind::emissive_media) // which no sample finds
        return;
    const LitScene at = lit(lit_scene(kind), kind);
    INFO("kind " << static_cast<int>(kind));
    constexpr std::uint64_t kPaths = 100'000;
    RunningMean landed, sampled; // power; the floor has area one
    for (std::uint64_t i = 0; i < kPaths; ++i) {
        RandomSequence random(4, RandomStream::photons, 0, i);
        const EmittedPath path = sample_emission(at.light, {i, kPaths}, random);
        const std::optional<RayHit> hit = at.scene().rays.nearest(path.ray);
        const bool on_floor = hit && hit->face < 2 && path.ray.direction.y < 0;
        landed.add(on_floor ? path.power.y : 0);
        const glm::vec2 u = random.next2() - 0.5f;
        const glm::vec3 position(u.x, 0, u.y);
        sampled.add(kind == Kind::even_world ? met_irradiance(at, position, random)
                                             : sampled_irradiance(at, position, random));
    }
    check_equal(landed, sampled);
}

TEST_CASE("light kinds: plain and aimed light paths bring the same power to a ball", "[lights]")
{
    const Kind kind = GENERATE(from_range(kKinds));
    Scene scene = lit_scene(kind);
    const auto first_face = static_cast<FaceId>(scene.mesh.face_count());
    TriangleMesh ball = tiny::uv_sphere(16, 8);
    tiny::scale(ball, 0.1f);
    tiny::move(ball, {-0.15f, 0.05f, 0});
    tiny::add(scene, ball, tiny::mirror(Rgb(1)));
    const LitScene at = lit(std::move(scene), kind);
    INFO("kind " << static_cast<int>(kind));
    const std::vector<TargetSphere>& targets = at.scene().specular_targets;
    constexpr std::uint64_t kPaths = 40'000;
    RunningMean means[2];
    for (const bool aimed : {false, true})
        for (std::uint64_t i = 0; i < kPaths; ++i) {
            RandomSequence random(3, RandomStream::photons, 0, i);
            const PathPlace place{i, kPaths};
            const EmittedPath path = aimed ? sample_aimed_emission(at.light, place, targets, random)
                                           : sample_emission(at.light, place, random);
            const std::optional<RayHit> hit = at.scene().rays.nearest(path.ray);
            means[aimed].add(hit && hit->face >= first_face ? path.power.y : 0);
        }
    if (kind == Kind::emissive_media)
        CHECK(means[true].mean() == 0); // it is not aimed
    else
        check_equal(means[false], means[true]);
}
