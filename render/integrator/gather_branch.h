#pragma once

#include "common/math/random.h"
#include "render/integrator/direct_light.h"
#include "render/shading/scatter.h"

#include <array>

namespace hipmap {

/// From here on only one of the rays that leave a surface is followed.
constexpr int kSplitDepth = 4;

/// Rays that may leave one surface: by gathered and followed lobes, mirror and clear glass.
constexpr int kMostRays = 4;

/// A part of an eye path still to be followed.
struct GatherBranch {
    Ray ray;
    Rgb weight{1.0f};
    Rgb absorption{0.0f}; ///< of what the ray travels in
    float index2 = 1.0f;  ///< square of the index of what the ray travels in
    RaySource source;
    float nanometres = 0;      ///< of the light followed; 0: all
    bool clear = true;         ///< nothing but mirrors and clear glass is behind it
    bool gathers = false;      ///< a gathered lobe is behind it
    bool straight = false;     ///< nothing else is since
    float indirect_radius = 0; ///< the first, of the indirect map where that lobe is
    float beyond_radius = 0;   ///< the same on the other side
    int depth = 0;             ///< surfaces behind it
    Interiors inside;          ///< what the ray travels in, where there are media
};

/// By which one is picked, or ended by chance.
inline float importance(const GatherBranch& branch)
{
    return branch.index2 * max_channel(branch.weight);
}

/// The branches that leave a surface.
struct Departures {
    std::array<GatherBranch, kMostRays> branches;
    std::size_t size = 0;

    void add(const GatherBranch& branch)
    {
        if (importance(branch) > 0)
            branches[size++] = branch;
    }
};

/// Branches wait on a stack: a surface before kSplitDepth takes one off and adds at most kMostRays.
struct BranchStack {
    std::array<GatherBranch, kMostRays*(kSplitDepth + 1)> branches;
    std::size_t size = 0;
};

/// One ray in a direction drawn from the lobes.
GatherBranch scatter(const GatherBranch& from, const Interaction& at, Lobes lobes,
                     RandomSequence& random);

void add_mirror_and_glass(const GatherBranch& from, const Interaction& at, Departures& out);

/// Leaves one of the branches, picked by importance.
void pick_one(Departures& out, RandomSequence& random);

/// False: Russian roulette ended it.
bool survives(GatherBranch& branch, RandomSequence& random);

} // namespace hipmap
