#include "preprocess/choose_candidates.h"

#include "common/command_line/default_photons.h"
#include "common/stopwatch.h"
#include "preprocess/partition/local_candidates.h"
#include "preprocess/partition/summarise.h"

namespace hipmap {

namespace {

ExpectedPass expected_pass(const PreprocessArguments& arguments, const Scene& scene)
{
    const float aspect = scene.cameras[scene.camera].aspect;
    return {arguments.photons.value_or(
                default_photons(complete_size({kDefaultWidth, 0}, aspect), kDefaultSamples)),
            arguments.neighbours};
}

/// Counts the local maps predicted on candidates.
std::size_t count_maps(const PredictedPhotons& predicted, const TriangleMesh& mesh,
                       const Partition& partition, double least)
{
    std::size_t out = 0;
    for (const auto& [place, photons] : predicted.places)
        out += photons >= least && partition.candidate[mesh.stored_face(place.face)] != 0 ? 1 : 0;
    return out;
}

} // namespace

std::vector<float> choose_candidates(const PreprocessArguments& arguments, const Scene& scene,
                                     const FaceTree& tree, PartitionResult& result)
{
    const Stopwatch watch;
    Partition& partition = result.partition;
    PartitionSummary& summary = result.summary;
    const ExpectedPass pass = expected_pass(arguments, scene);
    const PredictedPhotons predicted = predict_photons(scene, partition, tree, pass.photons);
    std::vector<float> photons;
    if (predicted.is_lit)
        photons = most_photons_of_faces(predicted, scene.mesh);
    count_candidates(partition, summary);
    const std::size_t by_shape = summary.candidates;
    expect_candidates(scene.mesh, predicted, photons, pass, partition);
    count_candidates(partition, summary);
    summary.expected = {
        predicted.is_lit, pass.photons, kPhotonsPerNeighbour * pass.neighbours,
        count_maps(predicted, scene.mesh, partition, photons_of_candidate(predicted, pass)),
        by_shape};
    summary.passes.push_back({"predict photons", watch.seconds()});
    return photons;
}

} // namespace hipmap
