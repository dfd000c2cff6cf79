#include "render/integrator/gather_branch.h"

namespace hipmap {

namespace {

/// Keeps one of the branches, picked by importance.
void pick_one(Departures& out, RandomSequence& random)
{
    float sum = 0;
    for (std::size_t i = 0; i < out.branches.size(); ++i)
        sum += importance(out.branches[i]);
    float drawn = random.next() * sum;
    std::size_t picked = 0;
    while (picked + 1 < out.branches.size() && !(drawn < importance(out.branches[picked])))
        drawn -= importance(out.branches[picked++]);
    out.branches[0] = out.branches[picked];
    out.branches[0].throughput *= sum / importance(out.branches[0]);
    out.branches.keep_first();
}

} // namespace

GatherBranch scatter(const RenderScene& scene, const GatherBranch& from, const Interaction& at,
                     Lobes lobes, RandomSequence& random)
{
    GatherBranch next = from;
    const bool through = go_by_lobes(
        scene, at, {.lobes = lobes, .guide = lobes == Lobes::gathered ? from.guide : nullptr},
        random, next);
    next.by_specular = lobes != Lobes::gathered;
    if (lobes == Lobes::gathered)
        next.source.sky = from.sky;
    next.guide = next.sky = nullptr;
    if (lobes == Lobes::followed && !through)
        next.source.photons =
            Rgb(from.photons * std::max(0.0f, glm::dot(at.normal, next.ray.direction)));
    if (lobes == Lobes::gathered && through)
        next.indirect_radius = from.transmitted_radius;
    return next;
}

void add_mirror_and_glass(const RenderScene& scene, const GatherBranch& from, const Interaction& at,
                          Departures& out)
{
    const SpecularLobes lobes = specular_lobes(at);
    if (!is_black(lobes.transmit)) {
        GatherBranch next = from;
        next.by_specular = true;
        go_through(scene, at, lobes, 1, next);
        out.add(next);
    }
    if (!is_black(lobes.mirror)) {
        GatherBranch next = from;
        next.by_specular = true;
        go_by_mirror(scene, at, lobes, 1, next);
        out.add(next);
    }
}

void send(Departures& out, bool only_one, RandomSequence& random, GatherBranchStack& stack)
{
    if (out.branches.size() > 1 && only_one)
        pick_one(out, random);
    for (std::size_t i = 0; i < out.branches.size(); ++i)
        // What is shared must be found with the pdf of its direction.
        if (out.branches[i].start != kNoRecord || survives(out.branches[i], random))
            stack.push(out.branches[i]);
}

} // namespace hipmap
