#pragma once

#include "common/fixed_list.h"
#include "render/integrator/gather_record.h"
#include "render/maps/find_photons.h"
#include "render/paths/path_state.h"

namespace hipmap {

/// The depth from which on only one of the rays that leave a surface is followed.
constexpr int kSplitDepth = 4;

/// The most rays that leave one surface: by gathered and followed lobes, mirror and clear glass.
constexpr int kMostRays = 4;

/// A part of an eye path that is still to be followed.
struct GatherBranch : PathState {
    glm::vec3 gathered_at{0.0f};           ///< the last gathered lobe
    bool by_specular = false;              ///< not straight from there
    float indirect_radius = 0;             ///< the first, of the indirect map there
    float transmitted_radius = 0;          ///< the same on the other side
    const DirectionGuide* guide = nullptr; ///< of the ray that the gathered lobes are to send
    const DirectionGuide* sky = nullptr;   ///< of samples of environments there
    std::size_t record = kNoRecord;        ///< of the gather ray behind it
    std::size_t start = kNoRecord;         ///< the same, of its GatherStart
    float photons = 0; ///< that the ray of the followed lobes competes with, by its cosine
};

/// The branches that leave a surface.
struct Departures {
    FixedList<GatherBranch, kMostRays> branches;

    void add(const GatherBranch& branch)
    {
        if (importance(branch) > 0)
            branches.push(branch);
    }
};

/// A stack of waiting branches: a surface before kSplitDepth takes one off and adds at most
/// kMostRays.
using GatherBranchStack = FixedList<GatherBranch, kMostRays*(kSplitDepth + 1)>;

/// Returns the query of photons where a surface is met.  lobes: null where photons count alike from
/// all directions.
inline PhotonQuery query_at(const Interaction& at, const PhotonLobes* lobes = nullptr)
{
    PhotonQuery out{at.point.position, at.normal, at.point.face, at.side};
    out.lobes = lobes;
    return out;
}

/// Returns the query of gathered lobes, which may see the directions of photons in some scenes.
inline PhotonQuery query_of(const RenderScene& scene, const Interaction& at,
                            const PhotonLobes& lobes)
{
    return query_at(at, scene.directional ? &lobes : nullptr);
}

/// Returns one ray in a direction drawn from the lobes.
GatherBranch scatter(const RenderScene& scene, const GatherBranch& from, const Interaction& at,
                     Lobes lobes, RandomSequence& random);

void add_mirror_and_glass(const RenderScene& scene, const GatherBranch& from, const Interaction& at,
                          Departures& out);

/// Lets the branches wait; where only one may, one that is picked by importance.  Unless Russian
/// roulette ends them.
void send(Departures& out, bool only_one, RandomSequence& random, GatherBranchStack& stack);

} // namespace hipmap
