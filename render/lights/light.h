#pragma once

#include "render/lights/beam_light.h"
#include "render/lights/constant_environment.h"
#include "render/lights/emissive_media.h"
#include "render/lights/emissive_mesh.h"
#include "render/lights/ies_light.h"
#include "render/lights/image_environment.h"
#include "render/lights/planar_light.h"
#include "render/lights/point_light.h"
#include "render/lights/sphere_light.h"
#include "render/lights/spot_light.h"
#include "render/lights/sun_light.h"

#include <variant>
#include <vector>

namespace hipmap {

/// A light of any kind.  light_kind.h describes the functions, the header of a kind its
/// particulars.
using Light =
    std::variant<PointLight, SpotLight, IesLight, SphereLight, SunLight, PlanarLight, BeamLight,
                 EmissiveMesh, ConstantEnvironment, ImageEnvironment, EmissiveMedia>;

/// Says whether a kind of light has all functions of light_kind.h.  The check comes before the
/// functions of `Light` are declared, to which every kind would convert.
template <typename Kind>
concept HasLightFunctions = requires(const Kind& kind, const LightReceiver& at,
                                     const PathPlace& path, RandomSequence& random)
{
    Kind::kRole;
    sample_li(kind, at, random);
    intersect(kind, Ray{});
    can_be_met(kind);
    sample_emission(kind, path, random);
    sample_aimed_emission(kind, path, std::vector<TargetSphere>{}, random);
    power(kind);
    bounds(kind);
};

template <typename Variant>
struct LightFunctions;
template <typename... Kinds>
struct LightFunctions<std::variant<Kinds...>> {
    static constexpr bool kComplete = (HasLightFunctions<Kinds> && ...);
};
static_assert(LightFunctions<Light>::kComplete);

LightRole role(const Light& light);

std::optional<LightSample> sample_li(const Light& light, const LightReceiver& at,
                                     RandomSequence& random);
std::optional<LightHit> intersect(const Light& light, const Ray& ray);
bool can_be_met(const Light& light);
EmittedPath sample_emission(const Light& light, const PathPlace& path, RandomSequence& random);
EmittedPath sample_aimed_emission(const Light& light, const PathPlace& path,
                                  const std::vector<TargetSphere>& targets, RandomSequence& random);
/// Returns the random numbers by which `sample_emission` draws a path along a ray; nothing for
/// kinds of light without a `primary_of`.  unused: the steps that `sample_emission` does not draw.
std::optional<PrimarySample> primary_of(const Light& light, const Ray& ray,
                                        const PrimarySample& unused);
/// Returns nothing for kinds of light without a `far_light`.
std::optional<FarLight> far_light(const Light& light);
glm::dvec3 power(const Light& light);
std::optional<LightBounds> bounds(const Light& light);

/// Returns the mean of the largest channel of the power of light paths, by which paths are assigned
/// to lights; 0: the light emits nothing.
double path_power(const Light& light);

} // namespace hipmap
