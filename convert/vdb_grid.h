#pragma once

#include "common/scene/medium.h"

#include <filesystem>
#include <string>

namespace hipmap {

/// The axis of a file that points upwards.
enum class UpAxis : std::uint8_t { y, z };

/// A grid of a .vdb file, turned so that y is up as in glTF (z up: x, z, -y).
struct VdbGrid {
    std::string name;
    DensityGrid density; ///< nodes in the middle of voxels, all over the box of the active ones
    glm::dvec3 low{0.0}; ///< the outermost nodes, in the file's unit
    glm::dvec3 high{0.0};
    std::size_t negative = 0; ///< values below 0, which count as 0
};

/// Reads the float grid called `name`; "": the one called density, or the only one.  Throws
/// InputError naming the file: OpenVDB cannot read it, no such grid, not of floats, turned or
/// skewed, no active voxel, fewer than 2 or very many along an axis, a value that is not finite.
/// Cost: the memory of all voxels in the box, twice.
VdbGrid read_vdb(const std::filesystem::path& path, const std::string& name, UpAxis up);

} // namespace hipmap
