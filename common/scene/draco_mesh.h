#pragma once

#include <draco/mesh/mesh.h>

#include <memory>
#include <span>

namespace hipmap {

/// Decodes a mesh of Draco bitstream 2.2, the only one glTF allows.  Null if the data is damaged,
/// is no mesh, or promises more than its size makes credible: a stream may name 2^32 faces in a
/// few bytes, so faces (times the attributes with seams of their own) and points are held below
/// kDracoElementsPerByte, and attributes below kDracoBytesPerByte, before memory is taken.
/// Indices of the mesh are in range.  Not more than linear in the size of the data.
std::unique_ptr<draco::Mesh> decode_draco(std::span<const unsigned char> data);

/// The most elements per byte of data.  The encoder's best case, a flat regular grid, has 11 faces
/// a byte.
inline constexpr std::size_t kDracoElementsPerByte = 128;
inline constexpr std::size_t kDracoBytesPerByte = 2048;
/// Elements allowed above either bound, for meshes of hardly any bytes.
inline constexpr std::size_t kDracoSpare = 1 << 16;

} // namespace hipmap
