#pragma once

#include "common/partition/partition.h"
#include "render/options.h"
#include "render/shading/sky_picture.h"

#include <string>
#include <vector>

namespace hipmap {

/// All that the passes of a render depend on but their number, each as "name=value": states of the
/// same settings hold passes of one image.  Names as on the command line; scene, partition
/// and sky by hash.  Cost: linear in the scene.
std::vector<std::string> settings_of(const RenderOptions& options, const Scene& scene,
                                     const Partition& partition, const SkyPicture& sky);

/// Light paths a pass, by such settings; 0: they do not say.
std::uint64_t photons_of(const std::vector<std::string>& settings);

/// How slowly radii shrink, by such settings; the default: they do not say.
double alpha_of(const std::vector<std::string>& settings);

/// Names of choices, as on the command line.
const char* name_of(MapMode mode);
const char* name_of(TreeKind tree);
const char* name_of(Integrator integrator);
const char* name_of(GatheredIrradiance irradiance);
const char* name_of(PixelFilter filter);

} // namespace hipmap
