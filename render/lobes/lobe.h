#pragma once

#include "render/lobes/burley.h"
#include "render/lobes/diffuse_transmission.h"
#include "render/lobes/lafortune.h"
#include "render/lobes/lambert.h"
#include "render/lobes/layers.h"
#include "render/lobes/microfacet_reflection.h"
#include "render/lobes/oren_nayar.h"
#include "render/lobes/phong.h"
#include "render/lobes/rough_dielectric.h"
#include "render/lobes/schlick.h"
#include "render/lobes/sheen.h"
#include "render/lobes/smooth_dielectric.h"
#include "render/lobes/smooth_mirror.h"
#include "render/lobes/ward.h"

#include <variant>

namespace hipmap {

/// One way in which a surface scatters light.  A lobe is a struct that has
///   - for light in one direction: `specular(view)`, shares reflected and transmitted;
///   - for light spread over directions: `eval(view, in)` (f, per steradian), `pdf(view, in)` and
///     `sample(view, random)` (its weight is f |cos| / pdf, times eta^2), `albedo(view)` (about the
///     share of light scattered, for probabilities; zero only if that is), `kSeparable` (f depends
///     on neither direction) and `kFolds` (light that the shading normal sends past the face comes
///     back about the face, docs/light_transport.md (19); otherwise it ends);
///   - `kTransmits`, if `in` may lie on the other side;
///   - `is_directed()`, if it may depend on the tangent.
using Lobe = std::variant<Lambert, Burley, DiffuseTransmission, Sheen, MicrofacetReflection,
                          RoughDielectric, SmoothMirror, SmoothDielectric, Phong, PhongMirror,
                          Schlick, OrenNayar, Ward, Lafortune>;

/// How integrators and photons treat the light of a lobe: gathered from photons, followed along a
/// drawn direction, or followed along its only direction.
enum class Lobes : std::uint8_t { gathered, followed, specular };

template <typename Kind>
concept SpreadLobe = requires
{
    Kind::kFolds;
};

template <typename Kind>
constexpr bool transmits()
{
    if constexpr (requires { Kind::kTransmits; })
        return Kind::kTransmits;
    return std::is_same_v<Kind, SmoothDielectric>;
}

/// Returns f(in, out), per steradian; zero for a specular lobe.
inline Rgb eval(const Lobe& lobe, const LobeView& view, const glm::vec3& in)
{
    return std::visit(
        [&]<typename Kind>(const Kind& of) {
            if constexpr (SpreadLobe<Kind>)
                return of.eval(view, in);
            else
                return Rgb(0);
        },
        lobe);
}

/// Returns the pdf per steradian with which `sample` draws `in`.
inline float pdf(const Lobe& lobe, const LobeView& view, const glm::vec3& in)
{
    return std::visit(
        [&]<typename Kind>(const Kind& of) {
            if constexpr (SpreadLobe<Kind>)
                return of.pdf(view, in);
            else
                return 0.0f;
        },
        lobe);
}

inline LobeSample sample(const Lobe& lobe, const LobeView& view, RandomSequence& random)
{
    return std::visit(
        [&]<typename Kind>(const Kind& of) {
            if constexpr (SpreadLobe<Kind>)
                return of.sample(view, random);
            else
                return LobeSample{};
        },
        lobe);
}

inline Rgb albedo(const Lobe& lobe, const LobeView& view)
{
    return std::visit(
        [&]<typename Kind>(const Kind& of) {
            if constexpr (SpreadLobe<Kind>)
                return of.albedo(view);
            else
                return Rgb(0);
        },
        lobe);
}

inline SpecularLobes specular(const Lobe& lobe, const LobeView& view)
{
    return std::visit(
        [&]<typename Kind>(const Kind& of) {
            if constexpr (SpreadLobe<Kind>)
                return SpecularLobes{};
            else
                return of.specular(view);
        },
        lobe);
}

inline bool transmits(const Lobe& lobe)
{
    return std::visit([]<typename Kind>(const Kind&) { return transmits<Kind>(); }, lobe);
}

inline bool folds(const Lobe& lobe)
{
    return std::visit(
        []<typename Kind>(const Kind&) {
            if constexpr (SpreadLobe<Kind>)
                return Kind::kFolds;
            else
                return false;
        },
        lobe);
}

inline bool is_separable(const Lobe& lobe)
{
    return std::visit(
        []<typename Kind>(const Kind&) {
            if constexpr (SpreadLobe<Kind>)
                return Kind::kSeparable;
            else
                return true;
        },
        lobe);
}

/// Returns whether the lobe may depend on the tangent.
inline bool is_directed(const Lobe& lobe)
{
    return std::visit(
        []<typename Kind>(const Kind& of) {
            if constexpr (requires { of.is_directed(); })
                return of.is_directed();
            else
                return false;
        },
        lobe);
}

/// A lobe of a surface.
struct PlacedLobe {
    Lobe lobe;
    Depth depth = Depth::diffuse;
    Lobes handled = Lobes::gathered;
    bool transmits = false, folds = false; ///< of the lobe, for speed

    PlacedLobe() = default;
    PlacedLobe(const Lobe& of, Depth at, Lobes by)
        : lobe(of), depth(at), handled(by), transmits(hipmap::transmits(of)),
          folds(hipmap::folds(of))
    {
    }
};

} // namespace hipmap
