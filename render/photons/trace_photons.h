#pragma once

#include "common/math/part.h"
#include "render/effects/light_classes.h"
#include "render/lights/emission.h"
#include "render/photons/path_splitting.h"
#include "render/photons/photon.h"
#include "render/photons/seen_classes.h"
#include "render/photons/volume_photon.h"
#include "render/shading/render_scene.h"

#include <cstdint>
#include <vector>

namespace hipmap {

/// Guides of the light paths of a pass.
struct PhotonGuides {
    EmissionGuide without_aim;
    EmissionGuide aimed;
    double aimed_share = 0;       ///< aimed paths for each of the others
    PathSplitting splitting = {}; ///< of those that are not aimed
};

struct PhotonOptions {
    std::uint64_t paths = 0; ///< light paths to emit
    std::uint64_t seed = 0;
    std::uint64_t pass = 0;
    bool store_direct =
        false; ///< photons straight from a light too; else the integrator finds that light
    std::uint64_t caustic_paths = 0; ///< to aim at specular surfaces besides, if there are any and
                                     ///< for lights that need it; 0: what reaches them without aim
                                     ///< makes the caustics
    bool link_bounces = false;       ///< fill TracedPhotons::bounces
    bool store_glossy = false;       ///< fill TracedPhotons::glossy; of caustic light alone
    LightClasses light{};            ///< photons of other light are neither traced nor kept
    bool media = false; ///< keep photons in media, and those that come from there to surfaces
    const PhotonGuides* guides = nullptr; ///< borrowed; null: paths start by power alone
    std::size_t part = 0, parts = 1;      ///< of the paths of each kind, this one part is traced
    bool count_paths = false;             ///< fill TracedPhotons::after_path
    bool keep_arrivals = false;           ///< fill TracedPhotons::arrivals; with count_paths
    const SeenSurfaces* seen = nullptr;   ///< to fill TracedPhotons::seen; borrowed
};

/// Marks the absence of a photon.
inline constexpr std::uint64_t kNoPhoton = ~std::uint64_t{0};

/// A photon whose light came by a diffuse bounce, straight or through specular surfaces.
struct BouncedPhoton {
    Photon photon;
    bool from_caustic;  ///< `from` is one of the caustic photons, else of the global ones
    bool by_specular;   ///< specular or followed lobes have sent the light on since
    std::uint64_t from; ///< the photon that its path left at the surface of the bounce; kNoPhoton:
                        ///<   a medium has scattered the light since
};

/// A photon that came by specular surfaces alone to a surface with followed lobes.
struct GlossyPhoton {
    Photon photon;
    /// The radiance along its path, by the largest channel, times the cosine at the surface, over
    /// the peak of the pdf of the followed lobes; W/m2.  Infinite: no ray can find its light.
    float radiance;
};

/// The numbers of photons that some paths left.
struct PhotonCounts {
    std::uint64_t caustic = 0, global = 0, bounces = 0;

    PhotonCounts& operator+=(const PhotonCounts& more)
    {
        caustic += more.caustic;
        global += more.global;
        bounces += more.bounces;
        return *this;
    }
};

/// Where a light path arrived at a surface that gathers, each of those apart into which it split.
struct PathArrival {
    Place at;
    std::uint64_t path;         ///< its place in TracedPhotons::after_path
    float power;                ///< sum of the channels
    int splits;                 ///< it is one of so many that split there
    PhotonCounts before, after; ///< the photons that it left from there on
};

/// The power of the light paths that were not aimed, by where it went, W / metres_per_unit^2.
/// Light that is left out counts as absorbed. emitted = absorbed + escaped in expectation.
struct PowerBalance {
    glm::dvec3 emitted{0.0};
    glm::dvec3 absorbed{0.0};
    glm::dvec3 escaped{0.0};
};

/// The photons of one pass, in the order of (path, bounce).
struct TracedPhotons {
    std::uint64_t emitted = 0;          ///< light paths that were traced
    std::uint64_t aimed = 0;            ///< those aimed at specular surfaces, which come last
    std::vector<Photon> caustic;        ///< light, specular or media, diffuse
    std::vector<Photon> global;         ///< indirect, and direct if asked for
    std::vector<BouncedPhoton> bounces; ///< indirect, if asked for
    std::vector<GlossyPhoton> glossy;   ///< if asked for
    std::vector<VolumePhoton> volume;   ///< in media
    std::vector<PhotonCounts>
        after_path;                    ///< [emitted + aimed] up to and with each path, if asked for
    std::vector<PathArrival> arrivals; ///< of paths that were not aimed, if asked for
    std::uint64_t dropped = 0;         ///< not finite; their power is lost
    std::uint64_t cut = 0;             ///< paths that reached the largest number of bounces
    PowerBalance power;
    SeenClasses seen; ///< the classes of light paths, if asked for
};

/// Returns the numbers of photons that there are.
inline PhotonCounts counts_of(const TracedPhotons& photons)
{
    return {photons.caustic.size(), photons.global.size(), photons.bounces.size()};
}

/// Returns the random numbers of a path.
RandomSequence path_sequence(const PhotonOptions& options, RandomStream stream,
                             const LightShare& share);

/// Traces light paths in parallel (oneTBB).  Same scene and options, same photons at any thread
/// count. A scene without light, or no paths: no photons.
TracedPhotons trace_photons(const RenderScene& scene, const PhotonOptions& options);

} // namespace hipmap
