#include "render/effects/drop_effects.h"
#include "tests/render/effects/plan_of.h"
#include "tests/support/tiny_rooms.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

/// A floor under a light, of a material by the model.
Scene modelled_floor(ReflectionModel model)
{
    Scene scene = tiny::diffuse_floor();
    tiny::add(scene, tiny::floor_at(0.3f, 0.2f), tiny::emissive(Rgb(1)));
    Material& floor = scene.materials[0];
    floor.name = "floor";
    floor.reflection_model = model;
    floor.lobe_exponent = 200;
    floor.lobe_specular = Rgb(0.5f);
    floor.roughness = 0.3f;
    floor.isotropy = 0.5f;
    floor.ward_slopes = {0.1f, 0.4f};
    floor.lafortune_coefficients = {-1, -0.5f, 1};
    return scene;
}

const PlannedEffect& models_in(const EffectPlan& plan)
{
    return plan.effects[static_cast<std::size_t>(Effect::reflection_models)];
}

} // namespace

TEST_CASE("effect plan: reflection models are named with what they call for", "[effects]")
{
    const EffectPlan phong = plan_of(modelled_floor(ReflectionModel::phong));
    CHECK(list_effects(phong) == "soft-shadows, indirect, glossy, caustics, reflection-models");
    CHECK(describe(models_in(phong)) ==
          "reflection-models: on; 'floor' use the reflection model of "
          "Phong; costs another formula at each hit");
    const Scene foil = modelled_floor(ReflectionModel::schlick);
    CHECK(list_effects(plan_of(foil)) ==
          "soft-shadows, indirect, mirror, glossy, caustics, reflection-models");
    Scene brushed = foil;
    brushed.mesh.attributes.tangents.assign(brushed.mesh.positions.size(), glm::vec4(1, 0, 0, 1));
    CHECK(plan_of(brushed).has(Effect::anisotropy));
    for (const auto& [model, author] : {std::pair(ReflectionModel::ward, "Ward"),
                                        std::pair(ReflectionModel::lafortune, "Lafortune")}) {
        Scene directed = modelled_floor(model);
        CHECK(models_in(plan_of(directed)).reason ==
              std::string("'floor' use the reflection model of ") + author);
        CHECK_FALSE(plan_of(directed).has(Effect::anisotropy));
        directed.mesh.attributes.tangents = brushed.mesh.attributes.tangents;
        CHECK(plan_of(directed).has(Effect::anisotropy));
    }
    CHECK_FALSE(models_in(plan_of(modelled_floor(ReflectionModel::metallic_roughness))).on);
}

TEST_CASE("effect plan: without reflection models materials are glTF's", "[effects]")
{
    EffectOptions options;
    options.switches = parse_effect_switches("-reflection-models,-anisotropy");
    Scene scene = modelled_floor(ReflectionModel::schlick);
    drop_effects(scene, plan_of(scene, options));
    CHECK(scene.materials[0].reflection_model == ReflectionModel::metallic_roughness);
    CHECK(scene.materials[0].isotropy == 1.0f);
    CHECK(scene.materials[0].ward_slopes.x == Approx(0.2f));
    CHECK(scene.materials[0].ward_slopes.x == scene.materials[0].ward_slopes.y);
    CHECK(scene.materials[0].lafortune_coefficients == glm::vec3(-0.75f, -0.75f, 1));
    CHECK(list_effects(plan_of(scene)) == "soft-shadows, indirect");
}
