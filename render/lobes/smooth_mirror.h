#pragma once

#include "render/lobes/fresnel.h"
#include "render/lobes/lobe_view.h"

namespace hipmap {

/// Reflection in one direction with Schlick's reflectance: polished metals and coats.
struct SmoothMirror {
    Reflectance fresnel;

    SpecularLobes specular(const LobeView& view) const { return {fresnel(view.cosine)}; }
};

} // namespace hipmap
