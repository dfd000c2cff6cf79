#pragma once

#include "common/math/rgb.h"
#include "common/scene/look.h"
#include "common/scene/medium.h"
#include "common/scene/mesh.h"
#include "common/scene/scene_light.h"
#include "common/scene/texture.h"

#include <cstdint>
#include <string>
#include <vector>

namespace hipmap {

/// Where the scene lies in the world.  Inside hipmap all lengths are scene units: the world is
/// moved so that the bounding box of its faces is centred on the origin and divided by a power of
/// two so that the longest side of the box is in (1/2, 1].
///     world metres = centre + metres_per_unit * scene units
struct SceneFrame {
    glm::dvec3 centre{0.0};
    double metres_per_unit = 1.0;
};

/// The meaning of a base colour's alpha: none, a cut at alpha_cutoff, or the share of light that
/// the surface stops.
enum class AlphaMode : std::uint8_t { opaque, mask, blend };

/// How a surface reflects, docs/light_transport.md.
enum class ReflectionModel : std::uint8_t {
    metallic_roughness, ///< glTF's, with all its layers
    phong,              ///< a lobe about the mirror direction over a diffuse base (35)
    schlick,            ///< one layer, even, spread and mirror by its roughness (36)
    ward,               ///< a Gaussian lobe of two widths over a diffuse base (45)
    lafortune,          ///< a lobe about any axis over a diffuse base (46)
};

/// The shape of the diffuse lobe.
enum class DiffuseModel : std::uint8_t {
    lambert,    ///< glTF's
    burley,     ///< of Blender's Principled BSDF up to version 3, rough surfaces brighter towards
                ///< grazing
    oren_nayar, ///< of clay and stone, rough surfaces brighter towards where light comes from
};

/// A material of glTF metallic-roughness with the extensions read so far.  Textures multiply the
/// factors.
struct Material {
    std::string name;
    Rgb base_color{1.0f};
    float metallic = 1.0f;
    float roughness = 1.0f;
    Rgb emission{0.0f};        ///< radiance, W/(m2 sr)
    bool double_sided = false; ///< emits from the back too (scattering is always two-sided)
    float transmission = 0.0f;
    float ior = 1.5f;
    float specular = 1.0f; ///< KHR_materials_specular
    Rgb specular_color{1.0f};
    Rgb absorption{0.0f};      ///< of the inside, per scene unit (Beer-Lambert)
    float thickness = 0.0f;    ///< KHR_materials_volume, scene units; the mesh has one of its own
    Rgb scattering{0.0f};      ///< of the inside, per scene unit
    Rgb medium_emission{0.0f}; ///< of the inside, as Medium has it
    PhaseFunction phase;       ///< of the inside
    std::shared_ptr<const DensityGrid> density; ///< of the inside, as Medium has it
    bool boundary = true;    ///< false: nothing but where its inside begins, rays go on
    float priority = 0.0f;   ///< of the inside: the highest of overlapping ones counts
    float dispersion = 0.0f; ///< KHR_materials_dispersion: 20 / Abbe number
    float clearcoat = 0.0f;  ///< KHR_materials_clearcoat
    float clearcoat_roughness = 0.0f;
    Rgb sheen_color{0.0f}; ///< KHR_materials_sheen
    float sheen_roughness = 0.0f;
    float diffuse_transmission = 0.0f; ///< KHR_materials_diffuse_transmission
    Rgb diffuse_transmission_color{1.0f};
    float anisotropy = 0.0f;          ///< KHR_materials_anisotropy
    float anisotropy_rotation = 0.0f; ///< radians from the tangent towards the bitangent
    bool energy_compensation = false; ///< adds multiple scattering between facets
    DiffuseModel diffuse_model = DiffuseModel::lambert;
    bool coat_adds = false;    ///< coats leave the base whole, docs/light_transport.md (38)
    bool tint_by_root = false; ///< transmitted light is multiplied by the base colour's square
                               ///<   root at each crossing, so that a solid's two have the colour
    ReflectionModel reflection_model = ReflectionModel::metallic_roughness;
    float lobe_exponent = 0.0f;  ///< of Phong's and Lafortune's models
    Rgb lobe_specular{0.0f};     ///< of Phong's, Ward's and Lafortune's models, 0 to 1
    float isotropy = 1.0f;       ///< of Schlick's model, above 0; 1: alike all round
    glm::vec2 ward_slopes{0.5f}; ///< along the tangent and across it, above 0, at most 1
    glm::vec3 lafortune_coefficients{-1, -1, 1}; ///< the largest of them is 1 or -1
    float alpha = 1.0f;
    AlphaMode alpha_mode = AlphaMode::opaque;
    float alpha_cutoff = 0.5f;
    bool unlit = false;                ///< its colour is in `emission`, whatever the light
    std::vector<TextureSlot> textures; ///< one of a use at most

    Medium inside() const { return {absorption, scattering, medium_emission, phase, density}; }
    /// Returns whether the inside does more than absorb, or the material has no surface.
    bool holds_medium() const
    {
        return !is_black(scattering) || !is_black(medium_emission) || density || !boundary;
    }
};

enum class Projection : std::uint8_t { perspective, orthographic };

struct Camera {
    std::string name;
    Projection projection = Projection::perspective;
    glm::vec3 position{0.0f}; ///< scene units
    glm::vec3 right{1, 0, 0}; ///< unit; right, up and -forward are right-handed
    glm::vec3 up{0, 1, 0};
    glm::vec3 forward{0, 0, -1};
    float tan_half_height = 0.5f; ///< perspective: tangent of half the vertical angle of view
    float half_height = 1.0f;     ///< orthographic: half the height seen, scene units
    float aspect = 0.0f;          ///< width over height; 0: as the image
    glm::vec2 shift{0.0f};        ///< of the image in its plane, right and up, in its heights
    float near_clip = 0.0f;       ///< along forward, scene units
    float far_clip = 0.0f;        ///< 0: none
    float aperture_radius = 0.0f; ///< of the lens, scene units; 0: a pinhole
    float focus_distance = 0.0f;  ///< along forward, scene units; 0: everything is sharp
};

/// Everything that is rendered, in scene units.  Read-only after loading.
struct Scene {
    SceneFrame frame;
    TriangleMesh mesh;
    std::vector<Material> materials;  ///< [M], at least one
    std::vector<TextureImage> images; ///< those that materials' textures name
    std::vector<SceneLight> lights;
    Rgb environment{0.0f};             ///< radiance of a uniform sky, W/(m2 sr)
    std::string environment_map_file;  ///< path of an environment map; empty: none
    float environment_strength = 1.0f; ///< its factor
    float environment_turn_deg = 0.0f; ///< its turn about +y, counter-clockwise from above
    Medium around;                     ///< the medium outside closed meshes, docs/media.md
    std::vector<Camera> cameras;       ///< at least one
    std::size_t camera = 0;            ///< the one to render from
    Look look = Look::gltf;            ///< which materials and lights have
    bool nested_dielectrics = false;   ///< rays are to know which dielectrics they are in, as some
                                       ///<   lie in one another; the effect plan says so
};

} // namespace hipmap
