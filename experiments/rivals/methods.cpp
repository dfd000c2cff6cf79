#include "experiments/rivals/methods.h"

#include "common/input_error.h"
#include "experiments/rivals/bidirectional.h"
#include "experiments/rivals/illumination_map.h"
#include "experiments/rivals/irradiance_cache.h"
#include "experiments/rivals/light_field.h"
#include "experiments/rivals/radiosity.h"

#include <array>
#include <string>
#include <string_view>

namespace hipmap {

namespace {

constexpr std::array<RivalMethod, 5> kMethods{{
    {"radiosity", "finite elements with progressive refinement: --cells, --rays", render_radiosity},
    {"illumination-map", "light paths add up in cells of surfaces: --cells, --rays",
     render_illumination_map},
    {"irradiance-cache", "indirect light interpolated: --directions, --tolerance",
     render_irradiance_cache},
    {"bidirectional", "bidirectional path tracing", render_bidirectional},
    {"light-field", "images of a grid of cameras, interpolated: --views, --window",
     render_light_field},
}};

} // namespace

std::span<const RivalMethod> rival_methods()
{
    return kMethods;
}

const RivalMethod& rival_method(const char* name)
{
    std::string names;
    for (const RivalMethod& method : kMethods) {
        if (std::string_view(method.name) == name)
            return method;
        names += (names.empty() ? "" : ", ") + std::string(method.name);
    }
    throw InputError("--method " + std::string(name) + ": no such method; write one of " + names);
}

} // namespace hipmap
