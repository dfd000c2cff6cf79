#include "render/effects/effect_findings.h"

#include "common/scene/reflection_models.h"
#include "common/scene/scene_names.h"
#include "render/shading/anisotropy_tangent.h"
#include "render/shading/opacity.h"
#include "render/shading/textured_material.h"

#include <algorithm>
#include <utility>

namespace hipmap {

namespace {

bool has_texture(const Material& material, TextureUse use)
{
    return find_texture(material.textures, use) != nullptr;
}

/// Materials of the file that have something the renderer does not show.
template <typename Has>
std::string names_of(const SceneFacts& facts, const Has& has)
{
    return facts.materials_where(
        [&](const Material& material, const Bsdf&, bool) { return has(material); });
}

/// A layer of opaque materials.  glass: materials that transmit and have it too.
Finding layer_finding(const std::string& names, const std::string& glass, const char* cost)
{
    const std::string rest = glass.empty() ? "" : "not rendered on glass (" + glass + ")";
    if (names.empty())
        return {false, rest.empty() ? "no material has one" : rest, ""};
    return {true, names + " have one" + (rest.empty() ? "" : "; " + rest), cost};
}

} // namespace

Finding find_mirror(const SceneFacts& facts)
{
    const std::string names =
        facts.materials_where([](const Material& material, const Bsdf& bsdf, bool) {
            const bool may_be_smooth = has_texture(material, TextureUse::metallic_roughness);
            return has_mirror(bsdf) || (has_reflection(bsdf) && may_be_smooth);
        });
    if (names.empty())
        return {false, "no surface is smooth and reflects", ""};
    return {true, names + " may reflect like a mirror", "an extra ray"};
}

Finding find_glossy(const SceneFacts& facts)
{
    const std::string followed =
        facts.materials_where([](const Material&, const Bsdf& bsdf, bool) { return bsdf.follows; });
    const std::string gathered = facts.materials_where(
        [](const Material&, const Bsdf& bsdf, bool) { return reflects(bsdf, Lobes::gathered); });
    const std::string limit = "roughness " + short_number(kFollowedRoughness);
    Finding out;
    if (!followed.empty()) {
        out.reason = "glossy reflections up to " + limit +
                     " and rough glass are traced by rays: " + followed;
        out.cost = "a ray for each of these reflections";
    }
    if (!gathered.empty()) {
        out.reason += (followed.empty() ? "" : "; ") +
                      ("reflections above " + limit + " are gathered from photons: ") + gathered;
        out.cost += (followed.empty() ? std::string() : "; ") + "photons store their direction";
    }
    out.on = !out.reason.empty();
    if (!out.on)
        out.reason = "no reflection is glossy, and no glass is rough";
    return out;
}

Finding find_refraction(const SceneFacts& facts)
{
    const std::string solid =
        facts.materials_where([](const Material&, const Bsdf& bsdf, bool is_solid) {
            return bsdf.transmits && is_solid;
        });
    const std::string thin =
        facts.materials_where([](const Material&, const Bsdf& bsdf, bool is_solid) {
            return bsdf.transmits && !is_solid;
        });
    if (solid.empty() && thin.empty())
        return {false, "no surface transmits", ""};
    if (solid.empty())
        return {false, "rays go straight through " + thin + ": open surfaces, so thin panes", ""};
    return {true, "rays refract in " + solid, "a reflected and a transmitted ray at clear glass"};
}

Finding find_dispersion(const SceneFacts& facts)
{
    const std::string names = facts.materials_where(
        [](const Material&, const Bsdf& bsdf, bool solid) { return solid && bsdf.dispersion > 0; });
    if (names.empty())
        return {false, "no solid glass is dispersive", ""};
    return {true, names + " refract colours differently",
            "colour noise: paths that meet them continue with one wavelength"};
}

Finding find_textures(const SceneFacts& facts)
{
    const std::string names = names_of(facts, [](const Material& m) { return varies(m); });
    if (names.empty())
        return {false, "no material has a texture that is rendered", ""};
    return {true, names + " have textures", "texture lookups at each hit"};
}

Finding find_normal_maps(const SceneFacts& facts)
{
    const std::string names = names_of(facts, [](const Material& m) { return tilts(m); });
    if (names.empty())
        return {false, "no material has one", ""};
    return {true, names + " have one", "a texture lookup at each hit"};
}

Finding find_vertex_colours(const SceneFacts& facts)
{
    const std::vector<glm::vec4>& colours = facts.scene.mesh.attributes.colours;
    if (std::none_of(colours.begin(), colours.end(),
                     [](const glm::vec4& colour) { return colour != glm::vec4(1); }))
        return {false,
                colours.empty() ? "no mesh has vertex colours" : "all vertex colours are white",
                ""};
    return {true, "meshes have vertex colours (COLOR_0), which multiply the base colour",
            "interpolation of three colours at each hit"};
}

Finding find_alpha(const SceneFacts& facts)
{
    const std::string names =
        names_of(facts, [&](const Material& m) { return may_let_light_pass(facts.scene, m); });
    if (names.empty())
        return {false, "every face is opaque", ""};
    return {true, names + " let a share of all rays pass",
            "an alpha lookup at each face on the way of a ray"};
}

Finding find_clearcoat(const SceneFacts& facts)
{
    const std::string names = facts.materials_where(
        [](const Material&, const Bsdf& bsdf, bool) { return bsdf.layers.clearcoat > 0; });
    const std::string glass =
        names_of(facts, [](const Material& m) { return m.clearcoat > 0 && m.transmission > 0; });
    return layer_finding(names, glass, "an extra reflection on these surfaces");
}

Finding find_sheen(const SceneFacts& facts)
{
    const std::string names = facts.materials_where(
        [](const Material&, const Bsdf& bsdf, bool) { return bsdf.layers.sheen > 0; });
    const std::string glass = names_of(
        facts, [](const Material& m) { return !is_black(m.sheen_color) && m.transmission > 0; });
    return layer_finding(names, glass,
                         "an extra lobe on these surfaces; photons store their direction");
}

Finding find_diffuse_transmission(const SceneFacts& facts)
{
    const std::string names = facts.materials_where(
        [](const Material&, const Bsdf& bsdf, bool) { return bsdf.transmits_diffusely; });
    const std::string glass = names_of(
        facts, [](const Material& m) { return m.diffuse_transmission > 0 && m.transmission > 0; });
    return layer_finding(names, glass, "light and photons of both sides at each hit");
}

Finding find_anisotropy(const SceneFacts& facts)
{
    const TriangleMesh& mesh = facts.scene.mesh;
    std::vector<std::uint8_t> directed(facts.scene.materials.size(), 0);
    const glm::vec2 middle(1.0f / 3);
    for (FaceId face = 0; face < mesh.face_count(); ++face) {
        const MaterialId material = mesh.material_of(face);
        if (directed[material] == 0 && facts.bsdfs[material].is_directed)
            directed[material] =
                anisotropy_tangent(facts.scene, surface_point(mesh, face, middle), middle)
                    .has_value();
    }
    const auto names = [&](std::uint8_t wanted) {
        return facts.materials_where([&](const Material& material, const Bsdf& bsdf, bool) {
            const auto index = static_cast<std::size_t>(&material - facts.scene.materials.data());
            return bsdf.is_directed && directed[index] == wanted;
        });
    };
    const std::string rest =
        names(0).empty()
            ? ""
            : names(0) + " need texture coordinates for the direction of their anisotropy";
    if (names(1).empty())
        return {false, rest.empty() ? "no reflection is anisotropic" : rest, ""};
    return {true, names(1) + " are anisotropic" + (rest.empty() ? "" : "; " + rest),
            "a tangent at each hit, and a longer formula"};
}

Finding find_reflection_models(const SceneFacts& facts)
{
    const auto names = [&](ReflectionModel wanted) {
        return facts.materials_where([wanted](const Material& material, const Bsdf&, bool) {
            return material.boundary && material.reflection_model == wanted;
        });
    };
    std::string reason;
    for (const auto& [model, key, author] : kNamedReflectionModels)
        if (const std::string worn = names(model); !worn.empty())
            reason +=
                (reason.empty() ? "" : "; ") + worn + " use the reflection model of " + author;
    if (reason.empty())
        return {false, "all materials use the standard model", ""};
    return {true, reason, "another formula at each hit"};
}

} // namespace hipmap
