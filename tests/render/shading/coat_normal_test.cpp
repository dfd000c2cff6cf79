#include "tests/support/drawn_directions.h"
#include "tests/support/drawn_weights.h"
#include "tests/support/statistics.h"
#include "tests/support/tiny_scenes.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

const glm::vec3 kCoatNormal = glm::normalize(glm::vec3(0.25f, 0.1f, 1));
const glm::vec3 kTiltedBacks[] = {{0.1f, 0, 1}, {0.7f, -0.4f, 0.6f}, {-0.4f, 0.3f, 1}};

/// Diffuse, coated and metal, below coats that are followed and gathered.
std::vector<Material> tilted_lacquers()
{
    Material plastic = tiny::diffuse({0.8f, 0.5f, 0.2f});
    plastic.specular = 1;
    const Material gold = tiny::mirror({1, 0.8f, 0.3f}),
                   diffuse = tiny::diffuse({0.8f, 0.5f, 0.2f});
    return {tiny::lacquered(diffuse, 1, 0.2f),    tiny::lacquered(plastic, 0.6f, 0.2f),
            tiny::lacquered(gold, 0.25f, 0.2f),   tiny::lacquered(gold, 0.6f, 0.2f),
            tiny::lacquered(plastic, 0.6f, 0.5f), tiny::lacquered(gold, 0.25f, 0.5f)};
}

/// A flat surface of which the coat alone is tilted.
Interaction below_tilted_coat(const Material& material, const glm::vec3& back)
{
    Interaction at = tiny::lit_surface(material, back);
    at.coat_normal = kCoatNormal;
    return at;
}

/// The unit square with a texture of one pixel for it all, tilted to the right by 0.6.
Scene lacquered_quad(std::initializer_list<TextureUse> uses)
{
    Scene scene = tiny::make_scene(tiny::quad());
    scene.mesh.attributes.uv[0] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}}; // v runs down
    scene.images.push_back({"bumps", 1, 1, {204, 128, 230, 255}});
    scene.materials[0] = tiny::lacquered(tiny::diffuse(Rgb(0.5f)), 1, 0);
    for (const TextureUse use : uses) {
        TextureSlot slot;
        slot.use = use;
        scene.materials[0].textures.push_back(slot);
    }
    return scene;
}

Interaction met(const Scene& scene, float side)
{
    const auto ready = tiny::ready(scene);
    Ray ray;
    ray.origin = {0.6f, 0.3f, side};
    ray.direction = {0, 0, -side};
    const std::optional<RayHit> hit = ready->render->rays.nearest(ray);
    REQUIRE(hit);
    return tiny::kept(interact(*ready->render, ray, *hit));
}

bool is_close(const glm::vec3& a, const glm::vec3& b)
{
    return glm::distance(a, b) < 0.01f;
}

} // namespace

TEST_CASE("coat normal: the coat has its own map or none, and so has what is below", "[shading]")
{
    for (const float side : {1.0f, -1.0f}) {
        const glm::vec3 flat(0, 0, side), tilted = side * glm::vec3(0.6f, 0, 0.8f);
        Interaction at = met(lacquered_quad({TextureUse::clearcoat_normal}), side);
        CHECK(at.shading_normal == flat);
        CHECK(is_close(at.coat_normal, tilted));
        CHECK(at.seen().coat == Approx(0.8f).margin(0.01));
        at = met(lacquered_quad({TextureUse::normal}), side);
        CHECK(is_close(at.shading_normal, tilted));
        CHECK(at.coat_normal == flat);
        CHECK(at.seen().coat == Approx(1));
        at = met(lacquered_quad({TextureUse::normal, TextureUse::clearcoat_normal}), side);
        CHECK(is_close(at.shading_normal, tilted));
        CHECK_FALSE(at.has_coat_normal());
        CHECK(at.seen().coat == at.cosine);
    }
}

TEST_CASE("coat normal: a coat that may be tilted is followed, an even one a mirror", "[shading]")
{
    CHECK(met(lacquered_quad({}), 1).bsdf().single(Lobes::specular) != nullptr);
    CHECK(met(lacquered_quad({TextureUse::clearcoat_normal}), 1).bsdf().single(Lobes::followed) !=
          nullptr);
    Scene bare = lacquered_quad({TextureUse::clearcoat_normal});
    bare.materials[0].clearcoat = 0;
    CHECK(tiny::ready(bare)->render->bumpy[0] == 0);
}

TEST_CASE("coat normal: the coat reflects about its own normal", "[shading]")
{
    for (const glm::vec3& back : kTiltedBacks) {
        const Interaction at =
            below_tilted_coat(tiny::lacquered(tiny::diffuse(Rgb(0.5f)), 1, 0.03f), back);
        const glm::vec3 expected = reflect(at.back, kCoatNormal);
        if (expected.z < 0.1f)
            continue;
        int near = 0;
        for (std::uint64_t i = 0; i < 200; ++i) {
            RandomSequence random(2, RandomStream::pictures, 0, i);
            near += glm::dot(sample_scatter(at, Lobes::followed, random).direction, expected) >
                    std::cos(0.03f);
        }
        CHECK(near >= 195);
    }
}

TEST_CASE("coat normal: directions are drawn with the pdf that is returned", "[shading]")
{
    for (const Material& material : tilted_lacquers())
        for (const Lobes lobes : {Lobes::gathered, Lobes::followed}) {
            const Interaction at = below_tilted_coat(material, kTiltedBacks[1]);
            if (lobes == Lobes::gathered ? !at.gathers() : !at.follows())
                continue;
            INFO("base " << material.roughness << ", coat " << material.clearcoat_roughness
                         << ", set " << int(lobes));
            CHECK(tiny::chi_square_z(at, lobes) < kMostZ);
        }
}

TEST_CASE("coat normal: the mean weight is the integral of the lobes", "[shading]")
{
    for (const Material& material : tilted_lacquers())
        for (const Lobes lobes : {Lobes::gathered, Lobes::followed}) {
            const Interaction at = below_tilted_coat(material, kTiltedBacks[1]);
            if (lobes == Lobes::gathered ? !at.gathers() : !at.follows())
                continue;
            const auto [integral, mean] = tiny::integral_and_weights(at, lobes);
            INFO("base " << material.roughness << ", coat " << material.clearcoat_roughness
                         << ", set " << int(lobes));
            CHECK(std::abs(mean.mean() - integral) < 0.002 + kMostZ * mean.standard_error());
        }
}

TEST_CASE("coat normal: light takes the same way back, by the coat and below it", "[shading]")
{
    const Material material = tiny::lacquered(tiny::diffuse({0.8f, 0.5f, 0.2f}), 1, 0.28f);
    for (std::uint64_t i = 0; i < 4000; ++i) {
        RandomSequence random(11, RandomStream::pictures, 0, i);
        // High enough that nothing is folded.
        const glm::vec3 a = direction_from_cosine(0.5f + 0.5f * random.next(), random.next());
        const glm::vec3 b = direction_from_cosine(0.5f + 0.5f * random.next(), random.next());
        const Interaction from_a = below_tilted_coat(material, a),
                          from_b = below_tilted_coat(material, b);
        CHECK(scattered(from_a, b, Lobes::gathered).value.x / b.z ==
              Approx(scattered(from_b, a, Lobes::gathered).value.x / a.z).epsilon(2e-3));
        const float on_a = glm::dot(a, kCoatNormal), on_b = glm::dot(b, kCoatNormal);
        CHECK(scattered(from_a, b, Lobes::followed).value.x / on_b ==
              Approx(scattered(from_b, a, Lobes::followed).value.x / on_a)
                  .epsilon(2e-3)
                  .margin(1e-5));
    }
}

TEST_CASE("coat normal: no surface sends on more than all", "[shading]")
{
    Material plastic = tiny::diffuse(Rgb(1));
    plastic.specular = 1;
    for (const Material& base : {tiny::diffuse(Rgb(1)), plastic, tiny::mirror(Rgb(1))})
        for (const float coat : {0.2f, 0.6f})
            for (const float height : {0.05f, 0.2f, 0.5f, 1.0f})
                for (const float toward : {1.0f, -0.2f}) {
                    const Interaction at = below_tilted_coat(tiny::lacquered(base, 0.4f, coat),
                                                             {toward, 0.1f, height});
                    if (!(at.seen().coat > 0))
                        continue;
                    RunningMean sent; // drawn: no grid resolves a coat at grazing angles
                    for (std::uint64_t i = 0; i < 4000; ++i) {
                        RandomSequence random(5, RandomStream::pictures, 0, i);
                        sent.add(sample_scatter(at, Lobes::gathered, random).weight.x +
                                 (at.follows()
                                      ? sample_scatter(at, Lobes::followed, random).weight.x
                                      : 0));
                    }
                    INFO("coat " << coat << ", height " << at.back.z << ", towards " << toward);
                    CHECK(sent.mean() <= 1.008 + kMostZ * sent.standard_error()); // the table
                    CHECK(sent.mean() > 0.5);
                    CHECK(sent.standard_error() < 0.02);
                }
}

TEST_CASE("coat normal: a mirror below a tilted coat loses as much both ways", "[shading]")
{
    const Material chrome = tiny::lacquered(tiny::mirror(Rgb(1)), 0, 0.2f);
    const Interaction there = below_tilted_coat(chrome, kTiltedBacks[1]);
    const Interaction back = below_tilted_coat(chrome, reflect(there.back, there.normal));
    const Rgb sent = specular_lobes(there).mirror;
    CHECK(sent.x == Approx(specular_lobes(back).mirror.x));
    const Layers& layers = there.bsdf().layers;
    CHECK(sent.x == Approx(transmitted_by(layers, Depth::reflection, there.seen()).x *
                           transmitted_by(layers, Depth::reflection, back.seen()).x));
}

TEST_CASE("coat normal: nothing that is drawn weighs more than all, however grazing", "[shading]")
{
    const Material lacquer = tiny::lacquered(tiny::diffuse(Rgb(0.5f)), 1, 0.03f);
    for (std::uint64_t i = 0; i < 40000; ++i) {
        RandomSequence random(11, RandomStream::pictures, 0, i);
        glm::vec3 back = sample_sphere(random.next2());
        back.z = std::abs(back.z);
        Interaction at = tiny::lit_surface(lacquer, back);
        // Tilted until it is all but seen from its edge.
        const glm::vec3 across = glm::normalize(glm::cross(at.back, sample_sphere(random.next2())));
        const float cosine = std::pow(10.0f, -2 - 4 * random.next());
        at.coat_normal = glm::normalize(across + cosine * at.back);
        const ScatterSample sample = sample_scatter(at, Lobes::followed, random);
        INFO(i << ": " << sample.pdf);
        REQUIRE(max_channel(sample.weight) < 1.01f);
        REQUIRE(max_channel(scattered(at, sample.direction, Lobes::followed).value) <=
                1.01f * sample.pdf);
    }
}
