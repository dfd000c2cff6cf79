#pragma once

#include "render/integrator/render_options.h"
#include "tests/closed_forms/closed_forms.h"
#include "tests/support/statistics.h"

#include <array>

namespace hipmap {

/// A way to render.
struct Method {
    const char* name;
    Integrator integrator;
    DirectLight direct;
    IndirectLight indirect = IndirectLight::photons;

    bool traces_paths() const
    {
        return integrator == Integrator::path || indirect == IndirectLight::paths;
    }
};

inline constexpr std::array<Method, 5> kMethods{{
    {"progressive", Integrator::progressive, DirectLight::shadow_rays},
    {"direct, shadow rays", Integrator::direct, DirectLight::shadow_rays},
    {"direct, photons", Integrator::direct, DirectLight::photons},
    {"path", Integrator::path, DirectLight::shadow_rays},
    {"progressive, paths", Integrator::progressive, DirectLight::shadow_rays, IndirectLight::paths},
}};

inline constexpr std::uint64_t kPassesOfForms = 10;
inline constexpr std::uint64_t kPassesOfPaths = 36; ///< noisier, and quick
inline constexpr std::uint32_t kNeighbours = 20;    ///< k

/// What was found for a closed form.
struct FoundForm {
    std::string form, formula, method;
    double expected = 0;
    double least = 0;      ///< what k nearest photons that lie evenly make of it, photon_maps.md
                           ///< (2); else `expected`
    RunningMean found;     ///< of passes, each independent of the others
    std::string why_not{}; ///< nothing was sought: why
};

/// By one method, from as many passes; integrator progressive by all of its radii.
std::vector<FoundForm> find_form(const ClosedForm& form, const Method& method,
                                 std::uint64_t passes);

/// Power that leaves a glass ball, of photons that a light beside it sends out, plain and aimed.
std::vector<FoundForm> find_power_from_glass(std::uint64_t passes);

/// What is found less what is expected (the nearest from `least` on), in standard errors; brought
/// from Student's distribution to the normal one (Wallace 1959).  Where all passes agree the
/// rounding of floats is the error.
double z_score(const FoundForm& found);

} // namespace hipmap
