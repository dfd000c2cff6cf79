#pragma once

#include "tests/common/scene/tiny_gltf_file.h"

#include <catch2/catch.hpp>

namespace hipmap::tiny {

inline void check_near(const glm::dvec3& a, const glm::dvec3& b)
{
    INFO(a.x << ' ' << a.y << ' ' << a.z);
    CHECK(glm::length(a - b) < 1e-5);
}

/// Loads a scene as its animation has it at a time, seconds.
inline LoadedScene load_at(const GltfFile& file, double time)
{
    SceneOptions options;
    options.time = time;
    return load(file, options);
}

} // namespace hipmap::tiny
