#include "common/input_error.h"
#include "render/effects/drop_effects.h"
#include "tests/render/effects/plan_of.h"
#include "tests/support/tiny_rooms.h"

#include <catch2/catch.hpp>

#include <set>

using namespace hipmap;

namespace {

Material named(Material material, const char* name)
{
    material.name = name;
    return material;
}

/// A diffuse floor under a point light: nothing but indirect light is called for.
Scene plain_floor()
{
    Scene scene = tiny::diffuse_floor();
    scene.materials[0].name = "floor";
    ScenePointLight light;
    light.position = {0, 0.3f, 0};
    light.intensity = Rgb(1);
    scene.lights.push_back(light);
    return scene;
}

Scene with_ball(const Material& material)
{
    Scene scene = plain_floor();
    TriangleMesh ball = tiny::uv_sphere(8, 4);
    tiny::scale(ball, 0.1f);
    tiny::move(ball, {0, 0.2f, 0});
    tiny::add(scene, ball, material);
    return scene;
}

Scene with_pane(const Material& material)
{
    Scene scene = plain_floor();
    tiny::add(scene, tiny::floor_at(0.2f, 0.2f), material);
    return scene;
}

Material rough(Material material, float roughness)
{
    material.roughness = roughness;
    return material;
}

Material with_texture(TextureUse use)
{
    Material material = tiny::diffuse(Rgb(0.5f));
    TextureSlot slot;
    slot.use = use;
    material.textures.push_back(slot);
    return material;
}

std::set<Effect> on_in(const EffectPlan& plan)
{
    std::set<Effect> out;
    for (const PlannedEffect& effect : plan.effects)
        if (effect.on)
            out.insert(effect.effect);
    return out;
}

using Effects = std::set<Effect>;

} // namespace

TEST_CASE("effect plan: an effect is on if and only if the scene calls for it", "[effects]")
{
    const Effects plain = {Effect::indirect};
    CHECK(on_in(plan_of(plain_floor())) == plain);
    CHECK(on_in(plan_of(tiny::diffuse_floor())).empty()); // nothing emits

    CHECK(on_in(plan_of(with_pane(tiny::mirror(Rgb(0.9f))))) ==
          Effects{Effect::indirect, Effect::mirror, Effect::caustics});
    CHECK(on_in(plan_of(with_pane(rough(tiny::mirror(Rgb(0.9f)), 0.2f)))) ==
          Effects{Effect::indirect, Effect::glossy, Effect::caustics});
    CHECK(on_in(plan_of(with_pane(rough(tiny::mirror(Rgb(0.9f)), 0.5f)))) ==
          Effects{Effect::indirect, Effect::glossy});

    Material glass = tiny::glass(1.5f);
    CHECK(on_in(plan_of(with_pane(glass))) == Effects{Effect::indirect, Effect::caustics});
    CHECK(on_in(plan_of(with_ball(glass))) ==
          Effects{Effect::indirect, Effect::refraction, Effect::caustics});
    glass.absorption = Rgb(1, 0, 0);
    CHECK(on_in(plan_of(with_pane(glass))) == Effects{Effect::indirect, Effect::caustics});
    CHECK(on_in(plan_of(with_ball(glass))) ==
          Effects{Effect::indirect, Effect::refraction, Effect::caustics, Effect::absorption});

    CHECK(on_in(plan_of(with_pane(tiny::emissive(Rgb(1))))) ==
          Effects{Effect::soft_shadows, Effect::indirect});
    CHECK(on_in(plan_of(with_pane(with_texture(TextureUse::base_color)))) ==
          Effects{Effect::indirect, Effect::textures});
    Material half = tiny::diffuse(Rgb(0.5f));
    half.alpha = 0.5f; // which without a mode says nothing
    CHECK(on_in(plan_of(with_pane(half))) == plain);
    half.alpha_mode = AlphaMode::blend;
    CHECK(on_in(plan_of(with_pane(half))) == Effects{Effect::indirect, Effect::alpha});
    half.alpha_mode = AlphaMode::mask;
    half.alpha_cutoff = 0.5f; // which it reaches
    CHECK(on_in(plan_of(with_pane(half))) == plain);
    CHECK(on_in(plan_of(with_pane(with_texture(TextureUse::normal)))) ==
          Effects{Effect::indirect, Effect::normal_maps});
    Scene coloured = plain_floor();
    coloured.mesh.attributes.colours.assign(4, glm::vec4(1));
    CHECK(on_in(plan_of(coloured)) == plain);
    coloured.mesh.attributes.colours[0].x = 0;
    CHECK(on_in(plan_of(coloured)) == Effects{Effect::indirect, Effect::vertex_colours});
    Material flint = tiny::glass(1.6f);
    flint.dispersion = 1;
    CHECK(on_in(plan_of(with_ball(flint))).contains(Effect::dispersion));
    CHECK_FALSE(on_in(plan_of(with_pane(flint))).contains(Effect::dispersion));
    Material lacquer = tiny::diffuse(Rgb(0.5f));
    lacquer.clearcoat = 1;
    CHECK(on_in(plan_of(with_pane(lacquer))) ==
          Effects{Effect::indirect, Effect::mirror, Effect::caustics, Effect::clearcoat});
    lacquer.clearcoat_roughness = 0.6f;
    CHECK(on_in(plan_of(with_pane(lacquer))) ==
          Effects{Effect::indirect, Effect::glossy, Effect::clearcoat});
    Material brushed = named(rough(tiny::mirror(Rgb(0.9f)), 0.5f), "brushed");
    brushed.anisotropy = 1;
    Scene anisotropic = with_pane(brushed);
    CHECK_THAT(plan_of(anisotropic).effects[static_cast<std::size_t>(Effect::anisotropy)].reason,
               Catch::Contains("'brushed' need texture coordinates"));
    anisotropic.mesh.attributes.tangents.assign(anisotropic.mesh.positions.size(),
                                                glm::vec4(1, 0, 0, 1));
    CHECK(on_in(plan_of(anisotropic)) ==
          Effects{Effect::indirect, Effect::glossy, Effect::anisotropy});
    Material velvet = tiny::diffuse(Rgb(0.5f));
    velvet.sheen_color = Rgb(1);
    CHECK(on_in(plan_of(with_pane(velvet))) == Effects{Effect::indirect, Effect::sheen});
    velvet.transmission = 1;
    CHECK_FALSE(plan_of(with_pane(velvet)).has(Effect::sheen));
    Material paper = tiny::diffuse(Rgb(0.5f));
    paper.diffuse_transmission = 0.5f;
    CHECK(on_in(plan_of(with_pane(paper))) ==
          Effects{Effect::indirect, Effect::diffuse_transmission});
    paper.transmission = 1;
    CHECK_FALSE(plan_of(with_pane(paper)).has(Effect::diffuse_transmission));
    Scene through_lens = plain_floor();
    through_lens.cameras[0].aperture_radius = 0.1f;
    CHECK(on_in(plan_of(through_lens)) == plain);
    through_lens.cameras[0].focus_distance = 1;
    CHECK(on_in(plan_of(through_lens)) == Effects{Effect::indirect, Effect::depth_of_field});
    Scene under_sky = plain_floor();
    under_sky.environment = Rgb(1);
    const Effects of_sky{Effect::soft_shadows, Effect::indirect, Effect::environment};
    CHECK(on_in(plan_of(under_sky)) == of_sky);
    under_sky.environment = Rgb(0);
    under_sky.environment_map_file = "sky.hdr";
    under_sky.lights.clear();
    CHECK(on_in(plan_of(under_sky)) == of_sky);
    Scene under_ball = plain_floor();
    auto& ball = std::get<ScenePointLight>(under_ball.lights[0]);
    ball.radius = 0.1;
    ball.name = "Bulb";
    CHECK(on_in(plan_of(under_ball)) == Effects{Effect::soft_shadows, Effect::indirect});
    CHECK(plan_of(under_ball).effects[0].reason ==
          "light comes from the area of the lights 'Bulb'");
    Scene under_panel = plain_floor();
    under_panel.lights.clear();
    CHECK(on_in(plan_of(under_panel)) == Effects{});
    SceneAreaLight panel;
    panel.radiance = Rgb(1);
    under_panel.lights = {panel};
    CHECK(on_in(plan_of(under_panel)) == Effects{Effect::soft_shadows, Effect::indirect});
}

TEST_CASE("effect plan: without light or diffuse surfaces there are no caustics", "[effects]")
{
    Scene scene = with_pane(tiny::mirror(Rgb(0.9f)));
    scene.lights.clear();
    CHECK(describe(plan_of(scene).effects[static_cast<std::size_t>(Effect::caustics)]) ==
          "caustics: off; no specular surface is lit");
    Scene mirrors = plain_floor();
    mirrors.materials[0] = tiny::mirror(Rgb(0.9f));
    CHECK(on_in(plan_of(mirrors)) == Effects{Effect::mirror});
}

TEST_CASE("effect plan: materials that no face wears call for nothing", "[effects]")
{
    Scene scene = plain_floor();
    scene.materials.push_back(tiny::glass(1.5f));
    scene.materials.push_back(tiny::emissive(Rgb(1)));
    CHECK(on_in(plan_of(scene)) == Effects{Effect::indirect});
}

TEST_CASE("effect plan: reasons name what becomes of reflections", "[effects]")
{
    Scene scene = with_pane(named(rough(tiny::mirror(Rgb(0.9f)), 0.2f), "steel"));
    tiny::add(scene, tiny::floor_at(0.1f, 0.2f), named(rough(tiny::glass(1.5f), 0.6f), "frosted"));
    tiny::add(scene, tiny::floor_at(0.3f, 0.2f),
              named(rough(tiny::mirror(Rgb(0.9f)), 0.5f), "tin"));
    CHECK(plan_of(scene).effects[static_cast<std::size_t>(Effect::glossy)].reason ==
          "glossy reflections up to roughness 0.3 and rough glass are traced by rays: 'steel' "
          "and 'frosted'; reflections above roughness 0.3 are gathered from photons: 'tin'");
}

TEST_CASE("effect plan: what the file has and no light gets into is off, and said", "[effects]")
{
    Material material = named(tiny::diffuse(Rgb(0.5f)), "wax");
    material.scattering = Rgb(1);
    Scene scene = with_pane(material);
    const EffectPlan plan = plan_of(scene);
    CHECK(on_in(plan) == Effects{Effect::indirect});
    CHECK(plan.effects[static_cast<std::size_t>(Effect::subsurface)].reason ==
          "no light enters 'wax': opaque or not closed");
}

TEST_CASE("effect plan: names are in the order of the effects, all different", "[effects]")
{
    const EffectPlan plan = plan_of(plain_floor());
    std::set<std::string_view> names;
    for (std::size_t i = 0; i < kEffects; ++i) {
        CHECK(static_cast<std::size_t>(plan.effects[i].effect) == i);
        CHECK_FALSE(plan.effects[i].reason.empty());
        CHECK(plan.effects[i].on == !plan.effects[i].cost.empty());
        names.insert(name_of(plan.effects[i].effect));
    }
    CHECK(names.size() == kEffects);
    CHECK(list_effects(plan) == "indirect");
}

TEST_CASE("effect plan: switches leave effects out, the last word counts", "[effects]")
{
    const Scene scene = with_pane(tiny::mirror(Rgb(0.9f)));
    EffectOptions options;
    options.switches = parse_effect_switches("-caustics,-indirect,+indirect");
    const EffectPlan plan = plan_of(scene, options);
    CHECK(on_in(plan) == Effects{Effect::indirect, Effect::mirror});
    CHECK_FALSE(light_classes(plan).caustic);
    CHECK(light_classes(plan).indirect);
    options.switches = parse_effect_switches("+absorption"); // which the scene has not
    CHECK(on_in(plan_of(scene, options)) == on_in(plan_of(scene)));
    options.bounces = false;
    CHECK(on_in(plan_of(scene, options)) == Effects{Effect::mirror});
}

TEST_CASE("effect plan: switches that make no sense are refused with the names there are",
          "[effects]")
{
    for (const char* text :
         {"", "caustics", "-", "-caustic", "-caustics,", "-mirror", "-caustics,,-indirect"}) {
        INFO(text);
        CHECK_THROWS_WITH(parse_effect_switches(text),
                          Catch::Contains("indirect, caustics, absorption, dispersion, nested"));
    }
}

TEST_CASE("effect plan: what is left out is not in the scene that is rendered", "[effects]")
{
    Material glass = tiny::glass(1.5f);
    glass.absorption = Rgb(1);
    glass.dispersion = 1;
    Scene scene = with_ball(glass);
    tiny::add(scene, tiny::floor_at(0.1f, 0.2f), with_texture(TextureUse::base_color));
    scene.environment = Rgb(1);
    scene.environment_map_file = "sky.hdr";
    const Scene before = scene;
    drop_effects(scene, plan_of(scene));
    CHECK(scene.materials[1].absorption == before.materials[1].absorption);
    CHECK(scene.materials[1].dispersion == 1);
    CHECK(scene.materials[2].textures.size() == 1);
    CHECK(scene.environment == before.environment);
    CHECK_FALSE(scene.environment_map_file.empty());
    EffectOptions options;
    options.switches = parse_effect_switches("-absorption,-dispersion,-textures,-environment");
    drop_effects(scene, plan_of(scene, options));
    CHECK(scene.materials[1].absorption == Rgb(0));
    CHECK(scene.materials[1].dispersion == 0);
    CHECK(scene.materials[2].textures.empty());
    CHECK(scene.environment == Rgb(0));
    CHECK(scene.environment_map_file.empty());
}
