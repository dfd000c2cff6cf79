#pragma once

#include "common/math/rgb.h"
#include "common/scene/spot_falloff.h"

#include <concepts>
#include <cstdint>
#include <numbers>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

namespace hipmap {

// A light that the scene file names, which is neither a face nor a medium nor the environment.  A
// kind of light is a plain struct with a `name`, the constant `kKind` by which messages call it,
// and the functions
//
//   mean_emission   returns where its light starts and which ways it goes, roughly
//   each_number     calls the visitor for each number of the light, by what the number is:
//                   position            m
//                   direction           unit
//                   extent              m; a length of the light.  Above zero: shadows are soft
//                   angle               radians, that the light subtends.  Above zero: likewise
//                   radiant_intensity   W/sr
//                   irradiance          W/m2
//                   radiance            W/(m2 sr)
//                   plain               anything else: no unit of length is in it
//
// Whatever goes over all numbers of a light is such a visitor: the change of units
// (scene_frame.cpp), the fingerprint (fingerprint.cpp), whether the light emits, has a size or
// moves (named_lights.cpp).  A new kind is added to `SceneLight` and needs nothing in these files.
//
// Readers give the units above.  In a `Scene`, lengths are scene units, radiant intensity is W/sr
// divided by metres_per_unit^2 (so that intensity / distance^2 in scene units is W/m2), and every
// number fits into float.

/// A light that emits the same intensity in all directions: a point, or a sphere.
struct ScenePointLight {
    static constexpr std::string_view kKind = "point light";

    std::string name;
    glm::dvec3 position{0.0};
    glm::dvec3 intensity{0.0}; ///< radiant intensity
    double radius = 0.0;       ///< of the sphere that emits; 0: a point
};

/// A point light or sphere that emits into a cone.
struct SceneSpotLight {
    static constexpr std::string_view kKind = "spot light";

    std::string name;
    glm::dvec3 position{0.0};
    glm::dvec3 direction{0, 0, -1}; ///< the way light travels, unit
    glm::dvec3 intensity{0.0};      ///< radiant intensity along the axis
    float cos_inner = 1.0f;         ///< where the rim begins, cos_inner > cos_outer
    float cos_outer = 0.0f;         ///< no light beyond
    SpotFalloff falloff = SpotFalloff::gltf;
    double radius = 0.0; ///< of the sphere that emits; 0: a point
};

/// A light beyond the scene: parallel rays, or a disc of the sky.
struct SceneSunLight {
    static constexpr std::string_view kKind = "sun (directional light)";

    std::string name;
    glm::dvec3 direction{0, 0, -1}; ///< the way light travels, unit
    glm::dvec3 irradiance{0.0};     ///< on a plane across the direction
    double half_angle = 0.0;        ///< half the angle that the disc subtends, radians
};

/// A flat light that emits to one side.
struct SceneAreaLight {
    static constexpr std::string_view kKind = "area light";

    std::string name;
    bool is_disc = false; ///< an ellipse, not a rectangle
    glm::dvec3 centre{0.0};
    glm::dvec3 half_right{1, 0, 0}; ///< from the centre to the middle of a side
    glm::dvec3 half_up{0, 1, 0};
    glm::dvec3 direction{0, 0, -1};              ///< unit, the side that emits
    glm::dvec3 radiance{0.0};                    ///< the mean over its hemisphere, by the cosine
    double half_spread = 0.5 * std::numbers::pi; ///< from its axis to where light ends, radians
};

/// A flat light that emits parallel light, across itself to one side.
struct SceneBeamLight {
    static constexpr std::string_view kKind = "collimated beam";

    std::string name;
    bool is_disc = false; ///< an ellipse, not a rectangle
    glm::dvec3 centre{0.0};
    glm::dvec3 right{1, 0, 0};      ///< the middle of a side
    glm::dvec3 up{0, 1, 0};         ///< and of the next
    glm::dvec3 direction{0, 0, -1}; ///< the way light travels, unit, across both
    glm::dvec3 irradiance{0.0};     ///< on a plane across the direction
};

/// The intensities of a luminaire by direction, as type C of LM-63 measures them: bilinear in both
/// angles between the directions of the table, zero beyond its polar angles.
struct PhotometricWeb {
    std::vector<double> polar;   ///< [P] radians from the axis, 0 to pi, rising, at least two
    std::vector<double> azimuth; ///< [A] radians about the axis, rising from 0 to 2 pi
    std::vector<double> candela; ///< [P * A] azimuth fastest; some are above zero
};

/// A point light that emits by a photometric web, which .ies files hold.
struct SceneIesLight {
    static constexpr std::string_view kKind = "IES light";

    std::string name;
    glm::dvec3 position{0.0};
    glm::dvec3 direction{0, 0, -1}; ///< unit, of the polar angle 0
    glm::dvec3 start{0, -1, 0};     ///< unit, across the direction, of the azimuth 0
    glm::dvec3 intensity{0.0};      ///< radiant intensity of one candela of the web
    PhotometricWeb web;
};

/// A light of any kind.  Audit and messages list lights in the order of the kinds here.
using SceneLight = std::variant<ScenePointLight, SceneSpotLight, SceneSunLight, SceneAreaLight,
                                SceneIesLight, SceneBeamLight>;

/// Where the light of a light starts and which ways it goes, as far as predictions need it.
struct MeanEmission {
    enum class From : std::uint8_t { sphere, rectangle, ellipse, afar };

    From from = From::sphere;
    glm::dvec3 centre{0.0};
    glm::dvec3 half_right{0.0}; ///< of a rectangle or an ellipse: to the middle of a side
    glm::dvec3 half_up{0.0};
    double radius = 0;        ///< of a sphere; 0: a point
    double half_angle = 0;    ///< of the part of the sky that light from afar comes from, radians
    glm::dvec3 axis{0, 0, 1}; ///< unit
    double cos_reach = -1;    ///< light goes no farther from the axis than this angle
    bool by_cosine = false;   ///< in proportion to the cosine to the axis, not evenly
    glm::dvec3 light{0.0};    ///< the power, or irradiance across the axis from afar, over `factor`
    double factor = 1;        ///< of it
};

MeanEmission mean_emission(const ScenePointLight& light);
/// An even cone of the same power: the fall-off is taken as quadratic in the cosine.
MeanEmission mean_emission(const SceneSpotLight& light);
MeanEmission mean_emission(const SceneSunLight& light);
/// By the cosine, whatever the spread.
MeanEmission mean_emission(const SceneAreaLight& light);
/// An even cone of the directions in which at least a tenth of the mean is measured.
MeanEmission mean_emission(const SceneIesLight& light);
MeanEmission mean_emission(const SceneBeamLight& light);

/// `Type` is `Kind`, const or not.
template <typename Type, typename Kind>
concept MaybeConst = std::same_as<std::remove_const_t<Type>, Kind>;

void each_number(MaybeConst<ScenePointLight> auto& light, auto& visit)
{
    visit.position(light.position);
    visit.radiant_intensity(light.intensity);
    visit.extent(light.radius);
}

void each_number(MaybeConst<SceneSpotLight> auto& light, auto& visit)
{
    visit.position(light.position);
    visit.direction(light.direction);
    visit.radiant_intensity(light.intensity);
    visit.plain(light.cos_inner);
    visit.plain(light.cos_outer);
    visit.plain(light.falloff);
    visit.extent(light.radius);
}

void each_number(MaybeConst<SceneSunLight> auto& light, auto& visit)
{
    visit.direction(light.direction);
    visit.irradiance(light.irradiance);
    visit.angle(light.half_angle);
}

void each_number(MaybeConst<SceneAreaLight> auto& light, auto& visit)
{
    visit.plain(light.is_disc);
    visit.position(light.centre);
    visit.extent(light.half_right);
    visit.extent(light.half_up);
    visit.direction(light.direction);
    visit.radiance(light.radiance);
    visit.plain(light.half_spread);
}

void each_number(MaybeConst<SceneIesLight> auto& light, auto& visit)
{
    visit.position(light.position);
    visit.direction(light.direction);
    visit.direction(light.start);
    visit.radiant_intensity(light.intensity);
    for (auto* table : {&light.web.polar, &light.web.azimuth, &light.web.candela})
        for (auto& number : *table)
            visit.plain(number);
}

void each_number(MaybeConst<SceneBeamLight> auto& light, auto& visit)
{
    visit.plain(light.is_disc);
    visit.position(light.centre);
    visit.position(light.right);
    visit.position(light.up);
    visit.direction(light.direction);
    visit.irradiance(light.irradiance);
}

/// Calls the visitor for each number of a light of any kind.
void each_number(MaybeConst<SceneLight> auto& light, auto& visit)
{
    std::visit([&](auto& of_kind) { each_number(of_kind, visit); }, light);
}

/// A visitor that ignores all numbers.  Visitors derive from it and hide what they look at.
struct IgnoreNumbers {
    void position(const glm::dvec3&) {}
    void direction(const glm::dvec3&) {}
    void extent(const auto&) {}
    void angle(double) {}
    void radiant_intensity(const glm::dvec3&) {}
    void irradiance(const glm::dvec3&) {}
    void radiance(const glm::dvec3&) {}
    void plain(const auto&) {}
};

/// Returns the name of a light of any kind.
inline const std::string& name_of(const SceneLight& light)
{
    return std::visit([](const auto& of_kind) -> const std::string& { return of_kind.name; },
                      light);
}

} // namespace hipmap
