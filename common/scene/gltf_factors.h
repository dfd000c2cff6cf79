#pragma once

#include "common/scene/gltf_document.h"
#include "common/scene/raw_scene.h"
#include "common/scene/scene_names.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace hipmap {

/// Reads the factors of one material; keeps track of those that had to be clamped.
class FactorReader {
  public:
    FactorReader(const RawScene& scene, const std::string& name)
        : look(scene.look), path_(scene.path), place_("material " + quote_name(name))
    {
    }

    double number(const nlohmann::json& object, const char* key, double otherwise) const
    {
        return object.value(key, otherwise);
    }

    float fraction(const nlohmann::json& object, const char* key, double otherwise)
    {
        return fraction_of(number(object, key, otherwise), key);
    }

    float fraction_of(double value, const char* key)
    {
        if (!(value >= 0 && value <= 1))
            clamped.emplace_back(key);
        return static_cast<float>(std::clamp(value, 0.0, 1.0));
    }

    glm::dvec3 colour(const nlohmann::json& object, const char* key, double otherwise) const
    {
        if (!object.contains(key))
            return glm::dvec3(otherwise);
        const nlohmann::json& c = object[key];
        return {c[0].get<double>(), c[1].get<double>(), c[2].get<double>()};
    }

    float at_least_zero(const nlohmann::json& object, const char* key, double otherwise = 0.0) const
    {
        const double value = number(object, key, otherwise);
        if (!(value >= 0))
            fail(std::string(key) + " must not be negative");
        return static_cast<float>(value);
    }

    Rgb fractions(const nlohmann::json& object, const char* key, double otherwise = 1.0)
    {
        const glm::dvec3 c = colour(object, key, otherwise);
        return {fraction_of(c.x, key), fraction_of(c.y, key), fraction_of(c.z, key)};
    }

    [[noreturn]] void fail(const std::string& what) const
    {
        throw scene_error(path_, place_, what);
    }

    const Look look;
    std::vector<std::string> clamped;

  private:
    const std::filesystem::path& path_;
    std::string place_;
};

/// KHR_materials_ior: an index of 0 stands for infinity (all is reflected).
inline constexpr float kInfiniteIor = 1e4f;

/// Returns what a material holds under the name of an extension; an empty object if nothing.
inline const nlohmann::json& extension(const nlohmann::json& material, const char* name)
{
    static const nlohmann::json kNothing = nlohmann::json::object();
    return has_extension(material, name) ? material["extensions"][name] : kNothing;
}

} // namespace hipmap
