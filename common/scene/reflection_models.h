#pragma once

#include "common/scene/scene.h"

#include <array>

namespace hipmap {

/// What a reflection model is called.
struct ReflectionModelName {
    ReflectionModel model;
    const char* key;    ///< in files
    const char* author; ///< in messages
};

/// All models that a material can name.
inline constexpr std::array<ReflectionModelName, 4> kNamedReflectionModels{{
    {ReflectionModel::phong, "phong", "Phong"},
    {ReflectionModel::schlick, "schlick", "Schlick"},
    {ReflectionModel::ward, "ward", "Ward"},
    {ReflectionModel::lafortune, "lafortune", "Lafortune"},
}};

} // namespace hipmap
