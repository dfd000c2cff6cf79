#include "render/shading/describe_reflections.h"

#include "render/shading/bsdf.h"

#include <sstream>

namespace hipmap {

namespace {

std::string sentence(const std::vector<std::string>& names, const std::string& what)
{
    std::string out = what + ": ";
    for (std::size_t i = 0; i < names.size(); ++i)
        out += (i == 0 ? "'" : ", '") + names[i] + "'";
    return out;
}

std::string at_roughness(const std::string& what, float roughness)
{
    std::ostringstream out;
    out << what << " roughness " << roughness;
    return out.str();
}

} // namespace

std::vector<std::string> describe_reflections(const Scene& scene)
{
    std::vector<bool> used(scene.materials.size(), false);
    for (const MaterialId material : scene.mesh.material_of_face)
        used[material] = true;

    std::vector<std::string> followed, gathered;
    for (std::size_t m = 0; m < scene.materials.size(); ++m) {
        if (!used[m])
            continue;
        const Material& material = scene.materials[m];
        const Bsdf bsdf = make_bsdf(material, material_factors(material), scene.diffuse_model);
        if (bsdf.follows())
            followed.push_back(material.name);
        if (bsdf.reflection == Reflection::gathered)
            gathered.push_back(material.name);
    }
    std::vector<std::string> out;
    if (!followed.empty())
        out.push_back(
            sentence(followed, at_roughness("glossy reflections up to", kFollowedRoughness) +
                                   " and rough glass are followed by rays"));
    if (!gathered.empty())
        out.push_back(sentence(gathered, at_roughness("reflections above", kFollowedRoughness) +
                                             " are gathered from photons"));
    return out;
}

} // namespace hipmap
