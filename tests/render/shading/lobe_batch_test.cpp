#include "render/shading/photon_lobes.h"
#include "tests/support/instruction_sets.h"
#include "tests/support/lit_surface.h"
#include "tests/support/tiny_scenes.h"

#include <catch2/catch.hpp>

#include <limits>
#include <vector>

using namespace hipmap;

namespace {

std::vector<Material> materials()
{
    Material plastic = tiny::diffuse({0.8f, 0.5f, 0.2f});
    plastic.specular = 1;
    plastic.roughness = 0.5f;
    Material glossier = plastic;
    glossier.roughness = 0.2f;
    Material metal = tiny::mirror({1, 0.8f, 0.3f});
    metal.roughness = 0.6f;
    Material part_metal = plastic;
    part_metal.metallic = 0.4f;
    Material plaster = tiny::diffuse({0.9f, 0.9f, 0.8f});
    plaster.diffuse_model = DiffuseModel::oren_nayar;
    plaster.roughness = 1;
    Material cloth = plastic;
    cloth.sheen_color = Rgb(0.5f);
    cloth.sheen_roughness = 0.4f;
    Material paper = plastic;
    paper.diffuse_transmission = 0.5f;
    Material phong = tiny::diffuse({0.4f, 0.3f, 0.2f});
    phong.reflection_model = ReflectionModel::phong;
    phong.lobe_specular = Rgb(0.3f);
    phong.lobe_exponent = 5;
    Material brushed = metal;
    brushed.anisotropy = 0.8f;
    std::vector<Material> out{tiny::diffuse({0.7f, 0.6f, 0.1f}),
                              plastic,
                              glossier,
                              metal,
                              part_metal,
                              plaster,
                              cloth,
                              paper,
                              phong,
                              brushed,
                              tiny::lacquered(plastic, 0.6f, 0.1f)};
    for (std::size_t i = 0, count = out.size(); i < count; ++i) {
        out.push_back(out[i]);
        shade_like(Look::blender_3_4, out.back());
    }
    return out;
}

/// Seen from above and below, with the shading normal of the face and with another.
std::vector<Interaction> surfaces()
{
    std::vector<Interaction> out;
    for (const Material& material : materials())
        for (const glm::vec3& back :
             {glm::vec3(0.1f, 0, 1), glm::vec3(0.7f, -0.4f, -0.6f), glm::vec3(-1, 0.2f, 0.15f)}) {
            out.push_back(tiny::lit_surface(material, back));
            out.push_back(tiny::tilted_surface(material, back));
            out.back().tangent = glm::vec3(0, 1, 0);
        }
    return out;
}

/// Lanes that are not in use hold no numbers.
DirectionBatch random_directions(std::uint64_t seed, std::size_t count)
{
    DirectionBatch out;
    for (auto* axis : {&out.x, &out.y, &out.z})
        axis->fill(std::numeric_limits<float>::quiet_NaN());
    for (std::size_t lane = 0; lane < count; ++lane) {
        RandomSequence random(seed, RandomStream::pictures, 0, lane);
        const glm::vec3 direction = sample_sphere(random.next2());
        out.x[lane] = direction.x, out.y[lane] = direction.y, out.z[lane] = direction.z;
    }
    return out;
}

} // namespace

TEST_CASE("lobe batch: photons weighed together have the bits of those weighed one by one",
          "[shading]")
{
    const std::vector<Interaction> all = surfaces();
    with_each_instruction_set([&] {
        std::size_t asked = 0, known = 0, different = 0;
        for (std::size_t i = 0; i < all.size(); ++i)
            for (const Lobes handled : {Lobes::gathered, Lobes::followed}) {
                const Interaction& at = all[i];
                if (handled == Lobes::gathered ? !at.gathers() : !at.follows())
                    continue;
                ++asked;
                const PhotonLobes lobes(at, handled);
                const SeenLobes seen{
                    at.bsdf(), handled, view_of(at, Depth::diffuse), at.normal, {}};
                known += can_weigh_batch(seen) ? 1 : 0;
                const std::size_t count = 1 + i % kBatch;
                const DirectionBatch in = random_directions(i, count);
                RgbBatch out;
                lobes.weigh(in, count, out);
                for (std::size_t lane = 0; lane < count; ++lane)
                    different += out.at(lane) == lobes(in.at(lane)) ? 0 : 1;
            }
        CHECK(different == 0);
        CHECK(known > 50);
        CHECK(known < asked); // others go one by one
    });
}
