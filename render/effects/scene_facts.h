#pragma once

#include "common/partition/partition.h"
#include "common/scene/scene.h"
#include "render/shading/make_bsdf.h"

#include <functional>
#include <string>
#include <vector>

namespace hipmap {

/// What effects are judged by.  Borrows the scene.
struct SceneFacts {
    const Scene& scene;
    std::vector<Bsdf> bsdfs;           ///< [M] by the factors alone
    std::vector<std::uint8_t> worn;    ///< [M] 1: some face with an area wears the material
    std::vector<std::uint8_t> solid;   ///< [M] 1: some face of a closed surface does
    std::vector<std::uint8_t> nested;  ///< [M] 1: a dielectric that lies in another, or has one in
                                       ///<     it (nested_dielectrics.h)
    bool has_light = false;            ///< there is any light
    bool shutter = false;              ///< it is open for a time
    std::vector<std::string> moving{}; ///< names of what moves meanwhile

    /// Names of the materials worn for which `holds(material, bsdf, solid)`, in quotes; "": none.
    std::string
    materials_where(const std::function<bool(const Material&, const Bsdf&, bool)>& holds) const;
};

/// O(F + M), and what nested_dielectrics costs.
SceneFacts gather_facts(const Scene& scene, const Partition& partition);

} // namespace hipmap
