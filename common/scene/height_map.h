#pragma once

#include "common/scene/texture.h"

namespace hipmap {

/// How far white lies above black in a height map, as a share of the image's width.  The unit of
/// heights is not in an MTL file; this one looks the same at any size of the object or the image.
inline constexpr float kHeightOfWhite = 0.01f;

/// Returns whether an image holds normals: coloured pixels, nine tenths of which decode to unit
/// vectors that point outwards.  An image without pixels holds none.
bool holds_normals(const TextureImage& image);

/// Makes the normal map of a height map, whose luminance is the height, by Sobel's filter.
/// strength: factor of the heights.  edge: what lies beyond the image.  Linear in the pixels.
TextureImage normals_of_heights(const TextureImage& heights, float strength, Wrap edge);

} // namespace hipmap
