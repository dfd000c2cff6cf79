#include "preprocess/prediction/expected_candidates.h"

#include "preprocess/partition/local_candidates.h"
#include "preprocess/partition/patches.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

namespace hipmap {

namespace {

/// Predictions are off by a tenth and more, and a map that was not predicted is worse than a
/// candidate too many.
constexpr double kOfLeast = 0.9;

/// Fewer traced photons than these say nothing of a face.
constexpr double kFewestTraced = 3;

/// [groups] the photons predicted in each, the most of either side, either kind and any copy.
std::vector<double> most_photons_of_groups(const TriangleMesh& mesh, const Partition& partition,
                                           const PredictedPhotons& predicted)
{
    // By copy (0: where it is stored), group, side and kind.
    std::map<std::array<std::uint32_t, 4>, double> sums;
    for (const auto& [place, photons] : predicted.places) {
        const std::uint32_t group = partition.group_of_face[mesh.stored_face(place.face)];
        const std::uint32_t copy =
            mesh.is_copied(place.face) ? mesh.finder.copy_of(place.face) + 1 : 0;
        if (group != kNone)
            sums[{copy, group, place.side, static_cast<std::uint32_t>(place.kind)}] += photons;
    }
    std::vector<double> out(partition.group_count, 0.0);
    for (const auto& [key, photons] : sums)
        out[key[1]] = std::max(out[key[1]], photons);
    return out;
}

} // namespace

double photons_of_candidate(const PredictedPhotons& predicted, const ExpectedPass& pass)
{
    return std::max(kOfLeast * kPhotonsPerNeighbour * pass.neighbours,
                    kFewestTraced * predicted.each);
}

Candidates candidates_of(const Partition& partition)
{
    return {partition.candidate, partition.group_count, partition.group_of_face,
            partition.group_radius};
}

void set_candidates(Candidates candidates, Partition& partition)
{
    partition.candidate = std::move(candidates.candidate);
    partition.group_count = candidates.group_count;
    partition.group_of_face = std::move(candidates.group_of_face);
    partition.group_radius = std::move(candidates.group_radius);
}

std::vector<float> most_photons_of_faces(const PredictedPhotons& predicted,
                                         const TriangleMesh& mesh)
{
    std::vector<float> out(mesh.face_count(), 0.0f);
    for (const auto& [place, photons] : predicted.places) {
        float& most = out[mesh.stored_face(place.face)];
        most = std::max(most, static_cast<float>(photons));
    }
    return out;
}

void expect_candidates(const TriangleMesh& mesh, const PredictedPhotons& predicted,
                       std::span<const float> photons_of_face, const ExpectedPass& pass,
                       Partition& partition)
{
    if (!predicted.is_lit)
        return;
    const double least = photons_of_candidate(predicted, pass);
    tbb::parallel_for(FaceId{0}, static_cast<FaceId>(mesh.face_count()), [&](FaceId face) {
        const double photons = photons_of_face[face];
        partition.candidate[face] = 0;
        if (photons < least)
            return;
        const double radius =
            std::sqrt(face_area(mesh, face) * pass.neighbours / (std::numbers::pi * photons));
        partition.candidate[face] = partition.reach[face] > radius ? 1 : 0;
    });
    const std::vector<double> of_group = most_photons_of_groups(mesh, partition, predicted);
    for (FaceId face = 0; face < mesh.face_count(); ++face)
        if (std::uint32_t& group = partition.group_of_face[face];
            group != kNone && of_group[group] < least) {
            group = kNone;
            partition.group_radius[face] = 0;
        }
    partition.group_count = number_by_first(partition.group_of_face);
}

} // namespace hipmap
