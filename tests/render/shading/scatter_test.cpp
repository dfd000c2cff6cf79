#include "render/lobes/glossy_albedo.h"
#include "render/shading/photon_lobes.h"
#include "tests/render/shading/plastic.h"
#include "tests/support/drawn_directions.h"
#include "tests/support/lit_surface.h"
#include "tests/support/statistics.h"
#include "tests/support/tiny_scenes.h"

#include <catch2/catch.hpp>

#include <vector>

using namespace hipmap;

namespace {

Material rough(Material material, float roughness)
{
    material.roughness = roughness;
    return material;
}

/// A part of each: metal, coat over diffuse, glass.
Material mixture(float roughness)
{
    Material material = tiny::plastic(roughness);
    material.metallic = 0.3f;
    material.transmission = 0.5f;
    return material;
}

struct Case {
    const char* name;
    Interaction at;
};

Material as_in_blender_3(Material material)
{
    shade_like(Look::blender_3_4, material);
    return material;
}

/// Surfaces of every lobe, seen steeply, aslant and nearly along the surface.
std::vector<Case> all_surfaces()
{
    std::vector<Case> out;
    for (const glm::vec3& back :
         {glm::vec3(0.1f, 0, 1), glm::vec3(0.7f, -0.4f, 0.6f), glm::vec3(-1, 0.2f, 0.15f)}) {
        const glm::vec3 below(back.x, back.y, -back.z);
        const Material gold = rough(tiny::mirror({1, 0.8f, 0.3f}), 0.45f);
        out.push_back({"plastic", tiny::lit_surface(tiny::plastic(0.5f), back)});
        out.push_back({"plastic of Blender 3",
                       tiny::lit_surface(as_in_blender_3(tiny::plastic(0.7f)), back)});
        out.push_back({"gold of Blender 3", tiny::lit_surface(as_in_blender_3(gold), back)});
        out.push_back({"smoother plastic", tiny::lit_surface(tiny::plastic(0.3f), back)});
        out.push_back({"gold", tiny::lit_surface(gold, back)});
        out.push_back({"smoother gold", tiny::lit_surface(rough(gold, 0.25f), back)});
        out.push_back({"glass", tiny::lit_surface(rough(tiny::glass(1.5f), 0.5f), back)});
        out.push_back(
            {"glass from inside", tiny::lit_surface(rough(tiny::glass(1.5f), 0.4f), below)});
        out.push_back({"pane", tiny::lit_surface(rough(tiny::glass(1.5f), 0.6f), back, false)});
        out.push_back({"gold, tilted", tiny::tilted_surface(gold, glm::vec3(0.8f, 0, 0.6f))});
        out.push_back({"glass, tilted",
                       tiny::tilted_surface(rough(tiny::glass(1.5f), 0.5f), {0.8f, 0.1f, 0.5f})});
        out.push_back({"mixture", tiny::lit_surface(mixture(0.6f), back)});
        out.push_back({"smoother mixture", tiny::lit_surface(mixture(0.3f), below)});
    }
    return out;
}

} // namespace

TEST_CASE("scatter: directions are drawn with the pdf that is returned", "[shading]")
{
    for (const Case& surface : all_surfaces())
        for (const Lobes lobes : {Lobes::gathered, Lobes::followed}) {
            if (lobes == Lobes::gathered ? !surface.at.gathers() : !surface.at.follows())
                continue;
            INFO(surface.name << ", cosine " << surface.at.cosine << ", set " << int(lobes));
            CHECK(tiny::chi_square_z(surface.at, lobes) < kMostZ);
        }
}

TEST_CASE("scatter: the mean weight is the integral of the lobes", "[shading]")
{
    for (const Case& surface : all_surfaces())
        for (const Lobes lobes : {Lobes::gathered, Lobes::followed}) {
            double integral = 0;
            tiny::over_sphere(250, [&](const glm::vec3& in, double solid_angle) {
                integral += double{scattered(surface.at, in, lobes).value.y} * solid_angle;
            });
            if (lobes == Lobes::gathered ? !surface.at.gathers() : !surface.at.follows()) {
                CHECK(integral == 0);
                continue;
            }
            RunningMean mean;
            for (std::uint64_t i = 0; i < 20000; ++i) {
                RandomSequence random(5, RandomStream::pictures, 0, i);
                const ScatterSample sample = sample_scatter(surface.at, lobes, random);
                mean.add(sample.weight.y / (sample.eta * sample.eta));
            }
            INFO(surface.name << ", cosine " << surface.at.cosine << ", set " << int(lobes));
            CHECK(std::abs(mean.mean() - integral) < 0.002 + kMostZ * mean.standard_error());
            CHECK(mean.standard_error() < 0.01);
        }
}

TEST_CASE("scatter: a weight drawn is value over pdf, and facets send on no more than all",
          "[shading]")
{
    for (const Case& surface : all_surfaces())
        for (std::uint64_t i = 0; i < 300; ++i) {
            RandomSequence random(7, RandomStream::pictures, 0, i);
            if (surface.at.follows()) {
                const ScatterSample sample = sample_scatter(surface.at, Lobes::followed, random);
                CHECK(max_channel(sample.weight) <= 1 + 1e-4f);
                if (is_black(sample.weight) || surface.at.shading_normal != surface.at.normal)
                    continue;
                const Scattered there = scattered(surface.at, sample.direction, Lobes::followed);
                CHECK(there.value.x * sample.eta * sample.eta / there.pdf ==
                      Approx(sample.weight.x).epsilon(1e-3));
            }
            for (const PlacedLobe& lobe : surface.at.bsdf().lobes())
                if (lobe.depth == Depth::reflection)
                    CHECK(max_channel(sample_lobe(surface.at, lobe, random).weight) <= 1 + 1e-4f);
        }
}

TEST_CASE("scatter: light takes the same way back", "[shading]")
{
    const std::vector<Material> materials{tiny::plastic(0.5f), tiny::plastic(0.2f),
                                          rough(tiny::glass(1.4f), 0.5f), mixture(0.4f)};
    for (std::uint64_t i = 0; i < 4000; ++i) {
        RandomSequence random(11, RandomStream::pictures, 0, i);
        const Material& material = materials[i % materials.size()];
        const bool solid = random.next() < 0.7f;
        const glm::vec3 a = sample_sphere(random.next2()), b = sample_sphere(random.next2());
        const Interaction from_a = tiny::lit_surface(material, a, solid);
        const Interaction from_b = tiny::lit_surface(material, b, solid);
        // Radiance over the square of the index is what is the same both ways.
        const bool across = solid && (a.z > 0) != (b.z > 0);
        const float index_a = across && a.z < 0 ? material.ior : 1;
        const float index_b = across && b.z < 0 ? material.ior : 1;
        for (const Lobes lobes : {Lobes::gathered, Lobes::followed}) {
            const float there = scattered(from_a, b, lobes).value.x / std::abs(b.z);
            const float back = scattered(from_b, a, lobes).value.x / std::abs(a.z);
            CHECK(there / (index_a * index_a) ==
                  Approx(back / (index_b * index_b)).epsilon(2e-3).margin(1e-5));
        }
    }
}

TEST_CASE("scatter: what a shading normal bends past the face is folded back, not lost",
          "[shading]")
{
    const Material white = rough(tiny::mirror(Rgb(1)), 0.4f);
    const Interaction at = tiny::tilted_surface(white, {0.8f, 0, 0.6f});
    REQUIRE(at.cosine > 0);
    CHECK(glm::dot(reflect(at.back, at.shading_normal), at.normal) < 0);
    double sent = 0;
    tiny::over_sphere(400, [&](const glm::vec3& in, double solid_angle) {
        sent += scattered(at, in, Lobes::gathered).value.x * solid_angle;
    });
    CHECK(sent == Approx(glossy_albedo(at.cosine, 0.16f).white()).margin(0.008));
}

TEST_CASE("scatter: a white base under a rough coat absorbs nothing", "[shading]")
{
    Material white = tiny::diffuse(Rgb(1));
    white.specular = 1;
    for (const float roughness : {0.2f, 0.3f, 0.5f, 1.0f})
        for (const float cosine : {0.15f, 0.5f, 0.9f}) {
            white.roughness = roughness;
            const glm::vec3 back(std::sqrt(1 - cosine * cosine), 0, cosine);
            const Interaction at = tiny::lit_surface(white, back);
            double sent = 0;
            tiny::over_sphere(400, [&](const glm::vec3& in, double solid_angle) {
                sent += (scattered(at, in, Lobes::gathered).value.x +
                         scattered(at, in, Lobes::followed).value.x) *
                        solid_angle;
            });
            INFO("roughness " << roughness << ", cosine " << cosine);
            CHECK(sent == Approx(1).margin(0.003)); // the table of albedos
        }
}

TEST_CASE("glossy albedo: the table is the integral, its average that of the table", "[shading]")
{
    const Material white = tiny::mirror(Rgb(1));
    for (const float roughness : {0.2f, 0.31f, 0.62f, 0.97f}) {
        const float alpha = roughness * roughness;
        for (const float cosine : {0.13f, 0.48f, 0.95f}) {
            const Interaction at = tiny::lit_surface(rough(white, roughness),
                                                     {std::sqrt(1 - cosine * cosine), 0, cosine});
            double sum = 0;
            tiny::over_sphere(600, [&](const glm::vec3& in, double solid_angle) {
                sum += (scattered(at, in, Lobes::gathered).value.x +
                        scattered(at, in, Lobes::followed).value.x) *
                       solid_angle;
            });
            INFO("roughness " << roughness << ", cosine " << cosine);
            CHECK(glossy_albedo(cosine, alpha).white() == Approx(sum).margin(0.003));
        }
        double mean = 0;
        constexpr int kPoints = 20000;
        for (int i = 0; i < kPoints; ++i) // cosine-weighted: the square of the cosine is uniform
            mean += glossy_albedo(std::sqrt((i + 0.5f) / kPoints), alpha).f90 / kPoints;
        CHECK(average_glossy_albedo(alpha).f90 == Approx(mean).epsilon(1e-4));
    }
}

TEST_CASE("scatter: photons from below a tilted face, as faces beside have them, are not magnified",
          "[shading]")
{
    Interaction at =
        tiny::lit_surface(rough(tiny::mirror({1, 0.8f, 0.3f}), 0.45f), {0.4f, 0, 0.9f});
    at.shading_normal = glm::normalize(glm::vec3(0.1f, 0, 1));
    at.cosine = glm::dot(at.back, at.shading_normal);
    const PhotonLobes lobes(at);
    for (const float above : {1e-7f, 1e-5f, 1e-3f, 0.01f, 0.09f}) {
        const float slope = std::asin(above) - std::atan(0.1f);
        const glm::vec3 in(std::cos(slope), 0, std::sin(slope));
        const Rgb alone = eval(at.bsdf().all[0].lobe, view_of(at, Depth::reflection), in);
        CAPTURE(above, in.z);
        CHECK(max_channel(lobes(in)) <= 1.001f * max_channel(alone));
    }
}

TEST_CASE("scatter: a diffuse surface scatters the same bits as by the formulas of all lobes",
          "[shading]")
{
    std::vector<Interaction> surfaces;
    for (const DiffuseModel model :
         {DiffuseModel::lambert, DiffuseModel::burley, DiffuseModel::oren_nayar}) {
        Material material = tiny::diffuse({0.8f, 0.5f, 0.2f});
        material.diffuse_model = model;
        material.roughness = 0.6f;
        surfaces.push_back(tiny::lit_surface(material, {0.1f, 0, 1}));
        surfaces.push_back(tiny::lit_surface(material, {-1, 0.2f, 0.15f}));
        surfaces.push_back(tiny::tilted_surface(material, {0.8f, 0, 0.6f}));
    }
    for (const Interaction& at : surfaces) {
        REQUIRE(at.is_diffuse());
        Interaction general = at;
        general.own->is_diffuse = false;
        for (std::uint64_t i = 0; i < 500; ++i) {
            RandomSequence random(2, RandomStream::pictures, 0, i);
            RandomSequence same = random, again = random;
            const ScatterSample a = sample_scatter(at, Lobes::gathered, random);
            const ScatterSample b = sample_scatter(general, Lobes::gathered, same);
            CHECK(a.direction == b.direction);
            CHECK(a.weight == b.weight);
            CHECK(a.pdf == b.pdf);
            CHECK(sample_lobe(at, at.bsdf().all[0], again).weight == b.weight);
            const glm::vec3 in = sample_sphere(random.next2());
            const Scattered one = scattered(at, in, Lobes::gathered);
            const Scattered other = scattered(general, in, Lobes::gathered);
            CHECK(one.value == other.value);
            CHECK(one.pdf == other.pdf);
        }
    }
}

TEST_CASE("scatter: light finds the same way through tilted glass and mirrors as the eye does",
          "[shading]")
{
    RandomSequence random(1, RandomStream::pictures, 0, 0);
    const auto direction = [&](float side) {
        glm::vec3 out = sample_sphere(random.next2());
        out.z = side * std::abs(out.z);
        return out;
    };
    const auto met_from = [](const glm::vec3& back, const glm::vec3& tilted) {
        Interaction at = tiny::lit_surface(tiny::glass(1.5f), back);
        at.shading_normal = glm::dot(back, tilted) < 0 ? -tilted : tilted;
        at.cosine = glm::dot(back, at.shading_normal);
        return at;
    };
    float largest = 0;
    for (int i = 0; i < 20000; ++i) {
        const glm::vec3 tilted = glm::normalize(direction(1) + glm::vec3(0, 0, 1));
        const glm::vec3 from = direction(1),
                        towards = direction(random.next() < 0.5f ? 1.0f : -1.0f);
        const Interaction lit = met_from(from, tilted), seen = met_from(towards, tilted);
        const float sent = specular_correction(lit, towards);
        const float wanted = specular_share(seen, from) * particle_correction(lit, towards);
        REQUIRE(sent == Approx(wanted).epsilon(1e-3));
        REQUIRE(sent <= 16);
        largest = std::max(largest, particle_correction(lit, towards));
    }
    CHECK(largest > 100);
}
