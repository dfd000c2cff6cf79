#pragma once

#include "common/partition/partition.h"
#include "common/scene/scene.h"
#include "render/shading/make_bsdf.h"

#include <functional>
#include <string>
#include <vector>

namespace hipmap {

/// Facts about a scene by which effects are judged.  Borrows the scene.
struct SceneFacts {
    const Scene& scene;
    std::vector<Bsdf> bsdfs;          ///< [M] by the factors alone
    std::vector<std::uint8_t> worn;   ///< [M] 1: some face with an area wears the material
    std::vector<std::uint8_t> solid;  ///< [M] 1: some face of a closed surface does
    std::vector<std::uint8_t> nested; ///< [M] 1: a dielectric that lies in another, or has one in
                                      ///<     it (nested_dielectrics.h)
    bool has_light = false;           ///< there is any light
    bool lone_convex = false; ///< the camera sees the outside of one opaque convex solid and
                              ///<     nothing else, so that no point it sees lights another
    bool shutter = false;     ///< it is open for a time
    std::vector<std::string> moving{}; ///< names of what moves meanwhile

    /// Returns the quoted names of the materials in use for which `holds(material, bsdf, solid)` is
    /// true; "" if none.
    std::string
    materials_where(const std::function<bool(const Material&, const Bsdf&, bool)>& holds) const;
};

/// Collects the facts of a scene.  Cost: O(F + M), and that of nested_dielectrics.
SceneFacts gather_facts(const Scene& scene, const Partition& partition);

} // namespace hipmap
