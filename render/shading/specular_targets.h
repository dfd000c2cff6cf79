#pragma once

#include "common/scene/scene.h"
#include "render/lights/aim.h"
#include "render/lobes/bsdf.h"

#include <vector>

namespace hipmap {

/// Returns spheres that together hold every face with a specular lobe, at which light is aimed to
/// make caustics (Jensen 1996, projection maps).  Empty: the scene has no such face. At most
/// kMostTargets, however many faces there are.  bsdfs: of the materials.  Cost: linear in faces.
std::vector<TargetSphere> find_specular_targets(const Scene& scene, const std::vector<Bsdf>& bsdfs);

} // namespace hipmap
