#pragma once

#include "common/scene/scene.h"
#include "render/lights/light_set.h"
#include "render/lobes/bsdf.h"

#include <vector>

namespace hipmap {

/// Returns spheres that together hold every face with a specular lobe, at which light is aimed to
/// make caustics (Jensen 1996, projection maps).  Empty: the scene has no such face. At most
/// kMostTargets, however many faces there are.  bsdfs: of the materials.  Cost: linear in faces.
std::vector<TargetSphere> find_specular_targets(const Scene& scene, const std::vector<Bsdf>& bsdfs);

/// Returns which lights are enclosed: inside one of the spheres, so that whatever they send is
/// aimed at it.  [lights] 1: it is; 0: it is not, or it is of media, which are not aimed.
std::vector<std::uint8_t> find_enclosed_lights(const LightSet& lights,
                                               const std::vector<TargetSphere>& targets);

} // namespace hipmap
