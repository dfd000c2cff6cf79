#include "bench/predicted_maps.h"

#include "common/scene/light_path_rules.h"
#include "preprocess/partition/local_candidates.h"
#include "preprocess/partition/previous_frame.h"
#include "render/dissertation/dissertation_maps.h"
#include "render/effects/drop_effects.h"
#include "render/photons/trace_photons.h"
#include "render/shading/part_touching_faces.h"

#include <numeric>

namespace hipmap {

namespace {

/// What has a map, or enough photons for one.
struct Built {
    std::vector<std::uint32_t> maps;  ///< [F] local maps of the face
    std::vector<std::uint32_t> able;  ///< [F] those in which some search can begin
    std::vector<std::uint8_t> groups; ///< [groups]
};

void add_built(const std::vector<Photon>& photons, const MapSurfaces& surfaces,
               const ExpectedPass& pass, Built& out)
{
    const auto least = static_cast<std::uint32_t>(kPhotonsPerNeighbour * pass.neighbours);
    const DissertationOptions asked{.mode = MapMode::thesis, .local_min = least};
    const DissertationMaps maps =
        build_dissertation_maps(photons, surfaces, {pass.neighbours}, asked);
    for (std::size_t i = 0; i < maps.locals.of_face.size(); ++i)
        if (const std::uint32_t map = maps.locals.of_face[i]; map != kNone) {
            ++out.maps[i / 2];
            out.able[i / 2] +=
                maps.locals.maps[map].filter_radius < surfaces.partition.reach[i / 2] ? 1 : 0;
        }
    std::vector<std::uint32_t> of_group(2 * out.groups.size(), 0);
    for (const Photon& photon : photons)
        if (const std::uint32_t group = surfaces.partition.group_of_face[photon.face];
            group != kNone)
            out.groups[group] |= ++of_group[2 * group + photon.side] >= least ? 1 : 0;
}

/// By a pass of integrator direct.
Built build_all(Scene scene, const Partition& partition, const ExpectedPass& pass)
{
    part_touching_faces(scene, partition);
    const EffectPlan effects = plan_effects(scene, partition, {});
    drop_effects(scene, effects);
    const RenderScene ready(scene, partition);
    PhotonOptions options{.paths = pass.photons,
                          .caustic_paths = pass.photons / kPathsPerCausticPath};
    options.light = light_classes(effects);
    options.media = ready.media.has_value();
    const TracedPhotons traced = trace_photons(ready, options);
    const MapSurfaces surfaces(ready.mesh(), partition);
    Built out{std::vector<std::uint32_t>(partition.face_count(), 0),
              std::vector<std::uint32_t>(partition.face_count(), 0),
              std::vector<std::uint8_t>(partition.group_count, 0)};
    add_built(traced.caustic, surfaces, pass, out);
    add_built(traced.global, surfaces, pass, out);
    return out;
}

} // namespace

PredictedMaps& PredictedMaps::operator+=(const PredictedMaps& other)
{
    for (std::size_t PredictedMaps::*count :
         {&PredictedMaps::faces, &PredictedMaps::by_shape, &PredictedMaps::candidates,
          &PredictedMaps::used, &PredictedMaps::built, &PredictedMaps::foreseen,
          &PredictedMaps::able, &PredictedMaps::able_foreseen, &PredictedMaps::groups,
          &PredictedMaps::groups_used, &PredictedMaps::groups_full})
        this->*count += other.*count;
    return *this;
}

PredictedMaps compare_predicted_maps(const Scene& scene, const ExpectedPass& pass)
{
    std::optional<PreviousFrame> frame; // which keeps the tree
    build_partition(scene, {}, frame);
    const Partition& partition = frame->result.partition;
    const PredictedPhotons predicted = predict_photons(scene, partition, frame->tree, pass.photons);
    Partition expected = partition;
    expect_candidates(scene.mesh, predicted, most_photons_of_faces(predicted, scene.mesh), pass,
                      expected);
    const Built built = build_all(scene, partition, pass);
    PredictedMaps out;
    out.faces = partition.face_count();
    std::vector<std::uint8_t> expected_group(partition.group_count, 0);
    for (FaceId face = 0; face < partition.face_count(); ++face) {
        const bool candidate = expected.candidate[face] != 0;
        out.by_shape += partition.candidate[face];
        out.candidates += candidate;
        out.used += candidate && built.maps[face] > 0;
        out.built += built.maps[face];
        out.foreseen += candidate ? built.maps[face] : 0;
        out.able += built.able[face];
        out.able_foreseen += candidate ? built.able[face] : 0;
        if (expected.group_of_face[face] != kNone)
            expected_group[partition.group_of_face[face]] = 1;
    }
    for (std::uint32_t group = 0; group < partition.group_count; ++group) {
        out.groups += expected_group[group];
        out.groups_full += built.groups[group];
        out.groups_used += expected_group[group] & built.groups[group];
    }
    return out;
}

} // namespace hipmap
