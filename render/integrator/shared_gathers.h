#pragma once

#include "render/integrator/gather_radius.h"
#include "render/integrator/picture_tiles.h"
#include "render/paths/direction_guide.h"

#include <optional>

namespace hipmap {

/// Estimates of one radiance with the radius of the pass and with two narrower ones (kNarrowing),
/// from the same photons and rays, so that they differ by their bias and the noise of few photons.
using RadianceByRadius = std::array<Rgb, 3>;

/// Where a final-gather ray ends, at gathered lobes: what these send back.
struct GatherEnd {
    SurfacePoint point;
    glm::vec3 normal{0.0f};     ///< geometric, on the side of the ray
    bool separable = true;      ///< it sends the same in all directions
    bool near = false;          ///< nearer than the global map's radius
    RadianceByRadius global{};  ///< from the global map, or if near what a surface met first sends
    RadianceByRadius caustic{}; ///< from the caustic map
    float first_global = 0, first_caustic = 0; ///< radii of the first pass
};

/// Where the final-gather ray of a sample starts.  Such starts may share the ends of their rays.
struct GatherStart {
    std::size_t sample = 0; ///< of the rows
    Interaction at{};       ///< borrows the material
    Rgb throughput{0.0f};   ///< of the path to there
    float indirect_radius = 0;
    const DirectionGuide* guide = nullptr; ///< by which its ray is drawn; null: by lobes alone
    std::optional<GatherEnd> end{};        ///< none: the ray met nothing that gathers
};

/// Adds to each sample what it gathers from the ends of all rays of its group, each ray weighed
/// against the others that could have found its end: docs/light_transport.md (51).  starts: of the
/// samples of `rows`, in their order.  Without bias but for light that a surface which is not
/// separable sends in other directions, less than kLikeWays apart, than the one it was computed
/// for.  Cost: a ray and the lobes of the start for each end and each of the at most eight
/// starts that share it.  Thread-safe.
void share_gathers(const RenderScene& scene, const GatherScale& scale, const PixelGroups& groups,
                   std::span<const GatherStart> starts, TracedRows<3>& rows);

} // namespace hipmap
