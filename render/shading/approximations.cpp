#include "render/shading/approximations.h"

#include "render/shading/bsdf.h"

#include <sstream>

namespace hipmap {

namespace {

/// Below this a reflection is part of what makes a matt surface.
constexpr float kMattRoughness = 0.9f;

void append_name(std::string& names, const std::string& name)
{
    names += (names.empty() ? "'" : ", '") + name + "'";
}

std::string sentence(const std::string& names, const std::string& what)
{
    std::ostringstream out;
    out << what << " (roughness above " << kSpecularRoughness << "): " << names;
    return out.str();
}

} // namespace

std::vector<std::string> describe_approximations(const Scene& scene)
{
    std::vector<bool> used(scene.materials.size(), false);
    for (const MaterialId material : scene.mesh.material_of_face)
        used[material] = true;

    std::string reflections, glasses;
    for (std::size_t m = 0; m < scene.materials.size(); ++m) {
        const Material& material = scene.materials[m];
        if (!used[m] || is_specular(material.roughness))
            continue;
        const float glass = (1 - material.metallic) * material.transmission;
        if (glass > 0)
            append_name(glasses, material.name);
        const bool reflects =
            material.metallic > 0 || max_channel(material.specular_color) * material.specular > 0;
        if (reflects && material.roughness < kMattRoughness && glass < 1)
            append_name(reflections, material.name);
    }
    std::vector<std::string> out;
    if (!reflections.empty())
        out.push_back(sentence(reflections, "glossy reflections are rendered as diffuse"));
    if (!glasses.empty())
        out.push_back(sentence(glasses, "rough glass is rendered as smooth"));
    return out;
}

} // namespace hipmap
