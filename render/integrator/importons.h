#pragma once

#include "render/integrator/gather_radius.h"
#include "render/integrator/gather_record.h"
#include "render/integrator/pass_photons.h"
#include "render/integrator/pilot_team.h"
#include "render/maps/find_photons.h"
#include "render/photons/photon.h"

#include <functional>
#include <vector>

namespace hipmap {

/// Points where photons are asked for, by the kind of photon (importons: Peter and Pietrek 1998).
/// The power of each is the weight of irradiance there in the image; its direction is the normal.
struct Importons {
    std::vector<Photon> caustic;
    std::vector<Photon> global;
    std::vector<Photon> indirect;
    double light =
        0; ///< of the image of their eye paths, the sum of its channels, weighted as they
           ///<   are; 0: it is black, and their weights are one
};

/// Keeps a query of photons of some kind.  importons: null: it is not kept.  weight: of what the
/// query finds, as radiance of the image.
inline void keep(Importons* importons, std::vector<Photon> Importons::*kind,
                 const PhotonQuery& query, const Rgb& weight)
{
    if (importons == nullptr)
        return;
    const Rgb lobes = query.lobes == nullptr ? Rgb(1) : (*query.lobes)(query.normal);
    (importons->*kind)
        .push_back({query.position, weight * lobes, query.normal, query.face, query.side});
}

/// Traces an eye path as a pass would and keeps its importons; returns its radiance.  Thread-safe.
using ImportonPath =
    std::function<Rgb(const Ray& ray, RandomSequence& random, Importons& importons)>;

/// Returns the importons of eye paths all over the image, each weighed by what its pixel counts in
/// the error of the image, docs/error.md (3).  In parallel; the same at any thread count and by any
/// team, each process of which traces some rows.
Importons trace_importons(const RenderScene& scene, const RenderOptions& options,
                          const ImportonPath& trace, const PilotTeam& team = {});

/// Traces an eye path as a pass would and keeps what its gather rays found.  Thread-safe.
using GatherPath =
    std::function<void(const Ray& ray, RandomSequence& random, std::vector<GatherRecord>& records)>;

/// Some of the samples of a pixel.
struct SampleRange {
    std::uint32_t begin = 0, end = 1;
};

/// Returns what gather rays of eye paths all over the image found.  In parallel; the same at any
/// thread count and by any team, each process of which traces some rows.
std::vector<GatherRecord> trace_gather_rays(const RenderScene& scene, const RenderOptions& options,
                                            const SampleRange& of_pixel, const GatherPath& trace,
                                            const PilotTeam& team = {});

/// What photons are worth to an image: maps of its importons.
struct PhotonWorth {
    PhotonMaps caustic, global, indirect;
    /// Returns the photons of the indirect map, one for each bounce.
    std::function<std::vector<Photon>(const TracedPhotons&)> weigh;
    const FirstRadii* radii = nullptr; ///< of the estimates; null: not known
    float rays = 1;                    ///< gather rays that share what each of them finds
};

/// Builds the maps of importons.  No importon: no worth.
PhotonWorth make_worth(const Importons& importons, const MapSurfaces& surfaces,
                       std::function<std::vector<Photon>(const TracedPhotons&)> weigh);

/// What paths are worth: the power of their photons times the density of importons there.  To the
/// noise of a path each of its photons adds the square of what it is worth, divided by how many
/// importons read it.  Where radii are not known, the noise is the square of what the path is
/// worth.
struct WorthOfPaths {
    std::vector<double> paths;         ///< in the order of trace_photons
    std::vector<double> noise;         ///< that each brings
    std::vector<SplitRecord> arrivals; ///< where they arrived with some power
};

/// Returns it, docs/light_transport.md (41).  traced: with after_path, and with arrivals if those
/// are asked for.  In parallel; the same at any thread count.
WorthOfPaths worth_of_paths(const MappedScene& mapped, const PhotonWorth& worth,
                            const TracedPhotons& traced);

} // namespace hipmap
