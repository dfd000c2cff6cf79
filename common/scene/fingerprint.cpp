#include "common/scene/fingerprint.h"

#include <xxhash.h>

#include <memory>
#include <new>
#include <type_traits>

namespace hipmap {

namespace {

struct FreeState {
    void operator()(XXH3_state_t* state) const { XXH3_freeState(state); }
};

/// Hashes values one after another.
class Hasher {
  public:
    Hasher() : state_(XXH3_createState())
    {
        if (!state_)
            throw std::bad_alloc();
        XXH3_128bits_reset(state_.get());
    }

    /// Numbers, enums and vectors of GLM: what has no padding.
    template <typename... Values>
    void add(const Values&... values)
    {
        (add_value(values), ...);
    }
    template <typename T>
    void add_array(const std::vector<T>& values)
    {
        static_assert(std::is_trivially_destructible_v<T>);
        const std::uint64_t size = values.size();
        XXH3_128bits_update(state_.get(), &size, sizeof size);
        XXH3_128bits_update(state_.get(), values.data(), values.size() * sizeof(T));
    }
    Fingerprint digest() const
    {
        const XXH128_hash_t hash = XXH3_128bits_digest(state_.get());
        return {{hash.low64, hash.high64}};
    }

  private:
    template <typename T>
    void add_value(const T& value)
    {
        static_assert(sizeof(glm::vec3) == 12 && sizeof(glm::dvec3) == 24 &&
                          sizeof(glm::mat3x2) == 24,
                      "padding would be hashed");
        static_assert(std::is_trivially_destructible_v<T>);
        XXH3_128bits_update(state_.get(), &value, sizeof value);
    }

    std::unique_ptr<XXH3_state_t, FreeState> state_;
};

// The bindings name every member, so that one that is added has to be thought of here.

void add_geometry(Hasher& hasher, const Scene& scene)
{
    const auto& [centre, metres_per_unit] = scene.frame;
    hasher.add(centre, metres_per_unit);
    hasher.add_array(scene.mesh.positions);
    hasher.add_array(scene.mesh.corners);
    for (const FaceCopy& copy : scene.mesh.copies) {
        const auto& [turn, scale, move] = copy.place;
        hasher.add(scene.mesh.shared[copy.shared].first, scene.mesh.shared[copy.shared].count, turn,
                   scale, move);
    }
}

void add_rest_of_mesh(Hasher& hasher, const TriangleMesh& mesh)
{
    const auto& [positions, normals, attributes, corners, materials, objects, names, shared, copies,
                 finder] = mesh;
    const auto& [uv, colours, tangents] = attributes;
    hasher.add_array(normals);
    for (const std::vector<glm::vec2>& set : uv)
        hasher.add_array(set);
    hasher.add_array(colours);
    hasher.add_array(tangents);
    hasher.add_array(materials);
}

void add_texture(Hasher& hasher, const TextureSlot& slot)
{
    const auto& [use, image, uv_set, sampler, uv_transform, strength] = slot;
    const auto& [wrap_u, wrap_v, magnify, minify, srgb] = sampler;
    hasher.add(use, image, uv_set, uv_transform, strength);
    hasher.add(wrap_u, wrap_v, magnify, minify, srgb);
}

void add_density(Hasher& hasher, const DensityGrid* density)
{
    if (density == nullptr)
        return;
    const auto& [nodes, values] = *density;
    hasher.add(nodes);
    hasher.add_array(values);
}

void add_material(Hasher& hasher, const Material& material)
{
    const auto& [name, base_color, metallic, roughness, emission, double_sided, transmission, ior,
                 specular, specular_color, absorption, thickness, scattering, medium_emission,
                 phase, density, boundary, priority, dispersion, clearcoat, clearcoat_roughness,
                 sheen_color, sheen_roughness, diffuse_transmission, diffuse_transmission_color,
                 anisotropy, anisotropy_rotation, energy_compensation, diffuse_model, coat_adds,
                 tint_by_root, reflection_model, lobe_exponent, lobe_specular, isotropy,
                 ward_slopes, lafortune_coefficients, alpha, alpha_mode, alpha_cutoff, unlit,
                 textures] = material;
    hasher.add(base_color, metallic, roughness, emission, double_sided, transmission, ior, specular,
               specular_color, absorption, thickness, scattering, medium_emission, phase.kind,
               phase.g, boundary, priority, dispersion, clearcoat, clearcoat_roughness, sheen_color,
               sheen_roughness, diffuse_transmission, diffuse_transmission_color, anisotropy,
               anisotropy_rotation, energy_compensation, diffuse_model, coat_adds, tint_by_root,
               reflection_model, lobe_exponent, lobe_specular, isotropy, ward_slopes,
               lafortune_coefficients, alpha, alpha_mode, alpha_cutoff, unlit);
    add_density(hasher, density.get());
    hasher.add(static_cast<std::uint64_t>(textures.size()));
    for (const TextureSlot& slot : textures)
        add_texture(hasher, slot);
}

void add_medium(Hasher& hasher, const Medium& medium)
{
    const auto& [absorption, scattering, emission, phase, density] = medium;
    const auto& [kind, g] = phase;
    hasher.add(absorption, scattering, emission, kind, g);
    add_density(hasher, density.get());
}

void add_image(Hasher& hasher, const TextureImage& texture)
{
    const auto& [name, width, height, rgba, cached] = texture;
    hasher.add(width, height, pixel_digest(texture));
}

/// Hashes the numbers of a light, whatever they are.
struct HashNumbers {
    Hasher& hasher;

    void position(const auto& value) { hasher.add(value); }
    void direction(const auto& value) { hasher.add(value); }
    void extent(const auto& value) { hasher.add(value); }
    void angle(const auto& value) { hasher.add(value); }
    void radiant_intensity(const auto& value) { hasher.add(value); }
    void irradiance(const auto& value) { hasher.add(value); }
    void radiance(const auto& value) { hasher.add(value); }
    void plain(const auto& value) { hasher.add(value); }
};

void add_light(Hasher& hasher, const SceneLight& light)
{
    hasher.add(static_cast<std::uint64_t>(light.index()));
    HashNumbers visit{hasher};
    each_number(light, visit);
}

void add_camera(Hasher& hasher, const Camera& camera)
{
    const auto& [name, projection, position, right, up, forward, tan_half_height, half_height,
                 aspect, shift, near_clip, far_clip, aperture_radius, focus_distance] = camera;
    hasher.add(projection, position, right, up, forward, tan_half_height, half_height, aspect,
               shift, near_clip, far_clip, aperture_radius, focus_distance);
}

template <typename T, typename Add>
void add_each(Hasher& hasher, const std::vector<T>& values, const Add& add)
{
    hasher.add(static_cast<std::uint64_t>(values.size()));
    for (const T& value : values)
        add(hasher, value);
}

/// Everything but the camera.
Hasher hash_still(const Scene& scene)
{
    const auto& [frame, mesh, materials, images, lights, environment, map_file, strength, turn_deg,
                 around, cameras, camera, look, nested] = scene;
    Hasher hasher;
    add_geometry(hasher, scene);
    add_rest_of_mesh(hasher, mesh);
    add_each(hasher, materials, add_material);
    add_each(hasher, images, add_image);
    add_each(hasher, lights, add_light);
    hasher.add(environment, strength, turn_deg, look);
    add_medium(hasher, around);
    hasher.add_array(std::vector<char>(map_file.begin(), map_file.end()));
    return hasher;
}

} // namespace

Fingerprint fingerprint(const Scene& scene)
{
    Hasher hasher;
    add_geometry(hasher, scene);
    return hasher.digest();
}

Fingerprint still_fingerprint(const Scene& scene)
{
    return hash_still(scene).digest();
}

Fingerprint content_fingerprint(const Scene& scene)
{
    Hasher hasher = hash_still(scene);
    add_camera(hasher, scene.cameras[scene.camera]);
    return hasher.digest();
}

} // namespace hipmap
