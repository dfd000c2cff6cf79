#pragma once

#include "render/maps/fixed_radius.h"
#include "render/maps/radius_field.h"

#include <memory>
#include <string>
#include <variant>
#include <vector>

/// The dissertation's methods and those they build on, kept for comparison behind one interface:
/// docs/photon_maps.md.  The rest of render includes this header alone.
namespace hipmap {

/// How photons are split into maps.
enum class MapMode : std::uint8_t {
    none,         ///< no photons at all
    global,       ///< one map (Jensen 1996)
    shared,       ///< PhotonMaps: one map for each shared map of the partition and side
    thesis,       ///< shared maps, and one for each face that has many photons (Mpawulo 2005)
    hierarchical, ///< shared maps, and such local and group maps as save time
};

/// The map levels below the shared maps that mode hierarchical searches.
enum class LevelChoice : std::uint8_t {
    paying, ///< those that are expected to save time, docs/photon_maps.md (8)
    all,    ///< all, to measure and to test
};

/// The search structure of the photons of a map.
enum class TreeKind : std::uint8_t {
    wide,       ///< WideTree
    balanced,   ///< BalancedTree, of the dissertation's time
    unbalanced, ///< InsertionTree, its rival then, built photon by photon
    midpoint,   ///< InsertionTree, built of all photons at once
};

/// How the photons found become an irradiance, docs/photon_maps.md.
enum class EstimateForm : std::uint8_t {
    clipped, ///< k-1 photons over the visible part of their disc, (2) to (4)
    thesis,  ///< those of k photons that face the surface over the whole disc, (7)
};

/// The irradiance that final-gather rays read where they end.
enum class GatheredIrradiance : std::uint8_t {
    estimated,   ///< an estimate at that point
    precomputed, ///< that made at a photon near by (Christensen 1999): not exact, Lambert's alone
};

/// Options of the dissertation's methods; the defaults use none of them.
struct DissertationOptions {
    MapMode mode = MapMode::shared;
    std::uint32_t local_min = 500; ///< M: fewest photons of a local map
    EstimateForm estimate = EstimateForm::clipped;
    TreeKind tree = TreeKind::wide;
    LevelChoice levels = LevelChoice::paying;
    GatheredIrradiance irradiance = GatheredIrradiance::estimated;
};

/// Returns whether any of its methods is used: they are about photons, by the power of the lights.
bool uses_methods(const DissertationOptions& options);

/// The cost and the saving of a map level, in nodes of a search, docs/photon_maps.md (8).
struct LevelPlan {
    double asking = 0; ///< cost of asking for its map and limiting radius; 0: not planned
    double most = 0;   ///< that any search could save
    bool used = false;

    bool counted = false;         ///< the rest: only where `most` exceeds the cost, or to measure
    std::uint64_t candidates = 0; ///< faces or groups of a side with enough photons
    std::uint64_t photons = 0;    ///< of them
    double asked = 0;             ///< share of searches on a face whose map begins below the root
    double answered = 0;          ///< share of searches that end within their limiting radius there
    double saving = 0;            ///< mean of all searches; below zero: a loss
};

/// Explains in a few words, with figures, why a map level is used or not.
std::string describe_plan(const LevelPlan& plan);

/// Counts of the searches in one map level below the shared maps.
struct LevelSearches {
    std::uint64_t begun = 0;
    std::uint64_t skipped = 0;   ///< not begun: the radius expected exceeds the limiting radius
    std::uint64_t abandoned = 0; ///< begun, ran into the limiting radius, went on in the next level

    LevelSearches& operator+=(const LevelSearches& other);
};

/// Counts of the searches in both map levels.
struct LevelStatistics {
    LevelSearches local;
    LevelSearches group; ///< mode hierarchical

    LevelStatistics& operator+=(const LevelStatistics& other);
};

/// The map levels of one kind of photon.
struct LevelCounts {
    std::uint64_t local_maps = 0;
    std::uint64_t group_maps = 0;
    LevelPlan local_plan, group_plan; ///< mode hierarchical
};

struct DissertationMaps;
struct DissertationScratch;

/// The maps of one kind of photon: shared maps, or the dissertation's maps.  Read-only once built:
/// any number of threads may search.
using ChosenMaps = std::variant<PhotonMaps, std::shared_ptr<const DissertationMaps>>;

/// Scratch memory of one thread for estimates from ChosenMaps.
struct ChosenScratch {
    EstimateScratch estimate;
    std::shared_ptr<DissertationScratch> dissertation; ///< null until a search needs it
};

/// Splits photons into maps as build_photon_maps does.  Builds shared maps alone unless the options
/// ask for more.  previous: maps of other photons, from which shared maps that are built alone are
/// taken over as build_photon_maps does; null: there are none.
ChosenMaps build_chosen_maps(const std::vector<Photon>& photons, const MapSurfaces& surfaces,
                             const MapOptions& options, const DissertationOptions& asked,
                             ChosenMaps* previous = nullptr);

/// Returns whether the options ask for no more than shared maps.
bool asks_for_shared(const DissertationOptions& asked);

/// Returns the options without map levels: searches within a radius read the shared maps alone.
DissertationOptions without_levels(DissertationOptions options);

/// Returns the shared maps; in mode global, the one map.
const PhotonMaps& shared_maps(const ChosenMaps& maps);

/// Returns the counts of the map levels; all zero for shared maps alone.
LevelCounts count_levels(const ChosenMaps& maps);

/// Returns the bytes of the arrays, without those of map levels.
std::size_t bytes_of(const ChosenMaps& maps);

/// Returns the counts of the searches in map levels made with this scratch.
LevelStatistics level_searches(const ChosenScratch& scratch);

/// Implements the functions below for maps other than shared maps.
namespace dissertation {

Rgb estimate_irradiance(const DissertationMaps& maps, const MapSurfaces& surfaces,
                        const PhotonQuery& query, ChosenScratch& scratch);
RadiusEstimates estimate_within(const DissertationMaps& maps, const MapSurfaces& surfaces,
                                const PhotonQuery& query, const std::array<float, 3>& radii,
                                ChosenScratch& scratch);
RadiusEstimates estimate_gathered(const DissertationMaps& maps, const MapSurfaces& surfaces,
                                  const PhotonQuery& query, const std::array<float, 3>& radii,
                                  ChosenScratch& scratch);
float even_radius(const DissertationMaps& maps, const MapSurfaces& surfaces,
                  const PhotonQuery& query);
RadiusField build_radius_field(const DissertationMaps& maps, const MapSurfaces& surfaces,
                               const RadiusField::Rules& rules);

} // namespace dissertation

/// Estimates the irradiance at a point: from shared maps as render/maps/estimate.h says; in mode
/// global without boundaries; with EstimateForm::thesis by docs/photon_maps.md (7).
inline Rgb estimate_irradiance(const ChosenMaps& maps, const MapSurfaces& surfaces,
                               const PhotonQuery& query, ChosenScratch& scratch)
{
    if (const PhotonMaps* shared = std::get_if<PhotonMaps>(&maps))
        return estimate_irradiance(*shared, surfaces, query, scratch.estimate);
    return dissertation::estimate_irradiance(*std::get<1>(maps), surfaces, query, scratch);
}

/// Estimates the irradiance from all photons within some radii, render/maps/fixed_radius.h; mode
/// global has no boundaries.
inline RadiusEstimates estimate_within(const ChosenMaps& maps, const MapSurfaces& surfaces,
                                       const PhotonQuery& query, const std::array<float, 3>& radii,
                                       ChosenScratch& scratch)
{
    if (const PhotonMaps* shared = std::get_if<PhotonMaps>(&maps))
        return estimate_within(*shared, surfaces, query, radii, scratch.estimate);
    return dissertation::estimate_within(*std::get<1>(maps), surfaces, query, radii, scratch);
}

/// Estimates the irradiance where a final-gather ray ends: with GatheredIrradiance::precomputed,
/// that of a photon near by, equal for all radii; else, or without such a photon, by
/// estimate_within.
inline RadiusEstimates estimate_gathered(const ChosenMaps& maps, const MapSurfaces& surfaces,
                                         const PhotonQuery& query,
                                         const std::array<float, 3>& radii, ChosenScratch& scratch)
{
    if (const PhotonMaps* shared = std::get_if<PhotonMaps>(&maps))
        return estimate_within(*shared, surfaces, query, radii, scratch.estimate);
    return dissertation::estimate_gathered(*std::get<1>(maps), surfaces, query, radii, scratch);
}

/// Returns the radius within which k photons would lie if the map's photons were spread evenly,
/// render/maps/estimate.h; in mode global, over all surfaces together.
inline float even_radius(const ChosenMaps& maps, const MapSurfaces& surfaces,
                         const PhotonQuery& query)
{
    if (const PhotonMaps* shared = std::get_if<PhotonMaps>(&maps))
        return even_radius(*shared, surfaces, query);
    return dissertation::even_radius(*std::get<1>(maps), surfaces, query);
}

/// Builds a radius field as render/maps/radius_field.h does for shared maps.
inline RadiusField build_radius_field(const ChosenMaps& maps, const MapSurfaces& surfaces,
                                      const RadiusField::Rules& rules = {})
{
    if (const PhotonMaps* shared = std::get_if<PhotonMaps>(&maps))
        return build_radius_field(*shared, surfaces, rules);
    return dissertation::build_radius_field(*std::get<1>(maps), surfaces, rules);
}

} // namespace hipmap
