#include "render/integrator/gather_branch.h"

#include "render/paths/roulette.h"

namespace hipmap {

namespace {

GatherBranch after(const GatherBranch& from)
{
    GatherBranch next = from;
    next.source = {};
    next.straight = false;
    ++next.depth;
    return next;
}

/// Radiance scales with the square of the index, docs/light_transport.md (4).
void enter(const Interaction& at, float eta, GatherBranch& branch)
{
    branch.weight /= eta * eta;
    branch.index2 *= eta * eta;
    branch.absorption = absorption_beyond(at);
}

} // namespace

GatherBranch scatter(const GatherBranch& from, const Interaction& at, Lobes lobes,
                     RandomSequence& random)
{
    const ScatterSample sample = sample_scatter(at, lobes, random);
    GatherBranch next = after(from);
    next.weight *= sample.weight;
    next.source = source_at(at, sample.density);
    next.clear = false;
    if (lobes == Lobes::gathered) {
        next.gathers = next.straight = true;
        next.nanometres = 0;
        if (sample.transmitted)
            next.indirect_radius = from.beyond_radius;
    }
    next.ray = scattered_ray(at, sample);
    if (sample.transmitted && lobes == Lobes::followed)
        enter(at, sample.eta, next);
    return next;
}

void add_mirror_and_glass(const GatherBranch& from, const Interaction& at, Departures& out)
{
    const SpecularLobes lobes = specular_lobes(at.bsdf, at.seen(), at.front, at.solid);
    if (!is_black(lobes.transmit)) {
        GatherBranch next = after(from);
        next.ray = transmitted_ray(at, lobes.eta);
        next.weight *= lobes.transmit;
        enter(at, lobes.eta, next);
        out.add(next);
    }
    if (!is_black(lobes.mirror)) {
        GatherBranch next = after(from);
        next.ray = mirror_ray(at);
        next.weight *= lobes.mirror;
        out.add(next);
    }
}

void pick_one(Departures& out, RandomSequence& random)
{
    float sum = 0;
    for (std::size_t i = 0; i < out.size; ++i)
        sum += importance(out.branches[i]);
    float drawn = random.next() * sum;
    std::size_t picked = 0;
    while (picked + 1 < out.size && !(drawn < importance(out.branches[picked])))
        drawn -= importance(out.branches[picked++]);
    out.branches[0] = out.branches[picked];
    out.branches[0].weight *= sum / importance(out.branches[0]);
    out.size = 1;
}

bool survives(GatherBranch& branch, RandomSequence& random)
{
    return survives(survival_chance(branch.depth, importance(branch)), random, branch.weight);
}

} // namespace hipmap
