#include "render/dissertation_settings.h"

namespace hipmap {

namespace {

constexpr Choice<MapMode> kMapModes[] = {{"none", MapMode::none},
                                         {"global", MapMode::global},
                                         {"shared", MapMode::shared},
                                         {"thesis", MapMode::thesis},
                                         {"hierarchical", MapMode::hierarchical}};
constexpr Choice<LevelChoice> kLevelChoices[] = {{"paying", LevelChoice::paying},
                                                 {"all", LevelChoice::all}};
constexpr Choice<TreeKind> kTrees[] = {{"wide", TreeKind::wide},
                                       {"balanced", TreeKind::balanced},
                                       {"unbalanced", TreeKind::unbalanced},
                                       {"midpoint", TreeKind::midpoint}};
constexpr Choice<EstimateForm> kEstimates[] = {{"clipped", EstimateForm::clipped},
                                               {"thesis", EstimateForm::thesis}};
constexpr Choice<GatheredIrradiance> kIrradiances[] = {
    {"estimated", GatheredIrradiance::estimated}, {"precomputed", GatheredIrradiance::precomputed}};

constexpr double kMostLocalPhotons = 4e9;

constexpr const char* kDissertationSection = "To compare with the dissertation";

OptionRow irradiance_row(GatheredIrradiance& irradiance)
{
    return {.name = "irradiance",
            .section = kDissertationSection,
            .field = choice_field<GatheredIrradiance>(irradiance, kIrradiances),
            .help = "Irradiance at the end of a final-gather ray: estimated there, or precomputed "
                    "at a quarter of the photons (Christensen), with an error of some percent of "
                    "indirect light and no faster",
            .changes = Changes::passes,
            .only_with = {{"precomputed", "integrator", {"progressive"}}}};
}

} // namespace

std::vector<OptionRow> dissertation_rows(DissertationOptions& asked)
{
    return {{.name = "maps",
             .section = kDissertationSection,
             .field = choice_field<MapMode>(asked.mode, kMapModes),
             .help = "Photon maps: none (direct light and reflections only), global (one map), "
                     "shared (one for each shared map of the partition), thesis (local maps too), "
                     "hierarchical (shared, with local and group maps where they save time)",
             .changes = Changes::passes},
            {.name = "tiers",
             .section = kDissertationSection,
             .field = choice_field<LevelChoice>(asked.levels, kLevelChoices),
             .help = "Local and group maps of --maps hierarchical: those that save time, or all",
             .changes = Changes::passes},
            {.name = "tree",
             .section = kDissertationSection,
             .field = choice_field<TreeKind>(asked.tree, kTrees),
             .help = "Tree of photons: wide, balanced (Jensen's kd-tree), unbalanced (a kd-tree "
                     "built by insertion) or midpoint (a kd-tree built at once, whose cells are "
                     "halved)",
             .changes = Changes::passes},
            {.name = "estimate",
             .section = kDissertationSection,
             .field = choice_field<EstimateForm>(asked.estimate, kEstimates),
             .help = "Irradiance from k photons: clipped (k-1 of them over the area visible from "
                     "the point) or thesis (k over the whole disc)",
             .changes = Changes::passes,
             .only_with = {{"thesis", "integrator", {"direct"}}}},
            irradiance_row(asked.irradiance),
            {.name = "local-min",
             .section = kDissertationSection,
             .field = number_or_none_field(asked.local_min, kLocalMinOpen, {1, kMostLocalPhotons}),
             .help = "Fewest photons of a local map, M",
             .unset = "10 k",
             .changes = Changes::passes}};
}

} // namespace hipmap
