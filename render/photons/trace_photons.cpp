#include "render/photons/trace_photons.h"

#include "render/lights/emission.h"
#include "render/photons/light_path.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace hipmap {

namespace {

/// Paths traced by one task; fixed, so that sums are formed in the same order at any thread count.
constexpr std::uint64_t kPathsPerChunk = 4096;

template <typename T>
void append(std::vector<T>& to, std::vector<T>& from)
{
    to.insert(to.end(), from.begin(), from.end());
    std::vector<T>().swap(from);
}

TracedPhotons join(std::vector<TracedPhotons>& chunks)
{
    TracedPhotons out;
    std::size_t caustic = 0, global = 0, bounces = 0, volume = 0;
    for (const TracedPhotons& chunk : chunks) {
        caustic += chunk.caustic.size();
        global += chunk.global.size();
        bounces += chunk.bounces.size();
        volume += chunk.volume.size();
    }
    out.caustic.reserve(caustic);
    out.global.reserve(global);
    out.bounces.reserve(bounces);
    out.volume.reserve(volume);
    for (TracedPhotons& chunk : chunks) {
        for (BouncedPhoton& photon : chunk.bounces)
            if (photon.from != kNoPhoton)
                photon.from += photon.from_caustic ? out.caustic.size() : out.global.size();
        append(out.bounces, chunk.bounces);
        append(out.caustic, chunk.caustic);
        append(out.global, chunk.global);
        append(out.volume, chunk.volume);
        out.dropped += chunk.dropped;
        out.cut += chunk.cut;
        out.power.emitted += chunk.power.emitted;
        out.power.absorbed += chunk.power.absorbed;
        out.power.escaped += chunk.power.escaped;
    }
    return out;
}

/// Traces paths 0..count-1, each by `trace(path, photons)`, in chunks that are joined in order.
template <typename Trace>
TracedPhotons trace_paths(std::uint64_t count, const Trace& trace)
{
    std::vector<TracedPhotons> chunks((count + kPathsPerChunk - 1) / kPathsPerChunk);
    tbb::parallel_for(std::size_t{0}, chunks.size(), [&](std::size_t c) {
        const std::uint64_t end = std::min(count, (c + 1) * kPathsPerChunk);
        for (std::uint64_t i = c * kPathsPerChunk; i < end; ++i)
            trace(i, chunks[c]);
    });
    return join(chunks);
}

/// What is kept of the paths that are not aimed.
Wanted wanted_without_aim(const PhotonOptions& options)
{
    Wanted wanted;
    wanted.direct = options.store_direct;
    wanted.caustic = options.light.caustic && options.caustic_paths == 0;
    wanted.indirect = options.light.indirect;
    wanted.bounces = options.link_bounces;
    wanted.after_specular = options.light.caustic && (wanted.caustic || wanted.indirect);
    wanted.after_media = wanted.volume = options.media;
    return wanted;
}

TracedPhotons trace_without_aim(const RenderScene& scene, const PhotonOptions& options)
{
    const Wanted wanted = wanted_without_aim(options);
    if (!wanted.direct && !wanted.caustic && !wanted.indirect && !wanted.volume)
        return {};
    const Emitters emitters = options.media ? Emitters::all : Emitters::all_but_media;
    const EmissionPlan plan = plan_emission(scene.lights, options.paths, emitters);
    TracedPhotons out = trace_paths(plan.paths, [&](std::uint64_t i, TracedPhotons& photons) {
        const LightShare share = share_of(plan, i);
        RandomSequence random(options.seed, RandomStream::photons, options.pass, share.light,
                              share.path.place);
        const EmittedPath start = emit_path(scene.lights, share, random);
        trace_light_path(scene, wanted, start, random, photons);
    });
    out.emitted = plan.paths;
    return out;
}

} // namespace

TracedPhotons trace_photons(const RenderScene& scene, const PhotonOptions& options)
{
    const std::vector<TargetSphere>& targets = scene.specular_targets;
    TracedPhotons out = trace_without_aim(scene, options);
    if (!options.light.caustic || options.caustic_paths == 0 || targets.empty())
        return out;
    Wanted wanted{false, true, false, options.link_bounces};
    wanted.volume = options.media;
    const EmissionPlan aimed =
        plan_emission(scene.lights, options.caustic_paths, Emitters::all_but_media);
    TracedPhotons caustics = trace_paths(aimed.paths, [&](std::uint64_t i, TracedPhotons& photons) {
        const LightShare share = share_of(aimed, i);
        RandomSequence random(options.seed, RandomStream::caustics, options.pass, share.light,
                              share.path.place);
        const EmittedPath start = emit_aimed_path(scene.lights, share, targets, random);
        if (max_channel(start.power) > 0)
            trace_light_path(scene, wanted, start, random, photons);
    });
    const std::uint64_t emitted = out.emitted;
    caustics.power = {}; // of no light of its own
    std::vector<TracedPhotons> both(2);
    both[0] = std::move(out);
    both[1] = std::move(caustics);
    out = join(both);
    out.emitted = emitted;
    out.aimed = aimed.paths;
    return out;
}

} // namespace hipmap
