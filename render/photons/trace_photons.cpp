#include "render/photons/trace_photons.h"

#include "common/freed_memory.h"
#include "render/lights/emission.h"
#include "render/photons/light_path.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <mutex>
#include <optional>

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

void add(const PowerBalance& power, PowerBalance& sum)
{
    sum.emitted += power.emitted;
    sum.absorbed += power.absorbed;
    sum.escaped += power.escaped;
}

/// Reserves as much as a vector of all chunks has together.
template <typename T>
void reserve_all(const std::vector<TracedPhotons>& chunks, std::vector<T> TracedPhotons::*kind,
                 TracedPhotons& out)
{
    std::size_t size = 0;
    for (const TracedPhotons& chunk : chunks)
        size += (chunk.*kind).size();
    (out.*kind).reserve(size);
}

/// Makes the places of photons and paths of a chunk those of all, which come before them.
void move_places(const TracedPhotons& all, TracedPhotons& chunk)
{
    const PhotonCounts before = counts_of(all);
    for (BouncedPhoton& photon : chunk.bounces)
        if (photon.from != kNoPhoton)
            photon.from += photon.from_caustic ? before.caustic : before.global;
    for (PhotonCounts& after : chunk.after_path)
        after += before;
    for (PathArrival& arrival : chunk.arrivals) {
        arrival.path += all.after_path.size();
        arrival.before += before;
        arrival.after += before;
    }
}

TracedPhotons join(std::vector<TracedPhotons>& chunks)
{
    TracedPhotons out;
    const auto each = [](const auto& use) {
        use(&TracedPhotons::caustic);
        use(&TracedPhotons::global);
        use(&TracedPhotons::bounces);
        use(&TracedPhotons::glossy);
        use(&TracedPhotons::volume);
        use(&TracedPhotons::after_path);
        use(&TracedPhotons::arrivals);
    };
    each([&](auto kind) { reserve_all(chunks, kind, out); });
    for (TracedPhotons& chunk : chunks) {
        move_places(out, chunk);
        each([&](auto kind) { append(out.*kind, chunk.*kind); });
        out.dropped += chunk.dropped;
        out.cut += chunk.cut;
        add(chunk.power, out.power);
        merge(out.seen, chunk.seen);
    }
    return_freed_memory();
    return out;
}

/// Paths of a pass that start alike.
struct PathKind {
    const PhotonOptions& options;
    const EmissionGuide* guide; ///< null: none
    const EmissionPlan plan;
    RandomStream stream = RandomStream::photons;
    Wanted wanted;

    /// Returns which paths of the plan are traced.
    Part traced() const { return part_of(plan.paths, options.part, options.parts); }
};

const EmissionGuide* guide_of(const PhotonOptions& options, EmissionGuide PhotonGuides::*kind)
{
    return options.guides == nullptr ? nullptr : &(options.guides->*kind);
}

/// Counts the classes of the paths of a kind, by threads that each count some of them.
class PathCounts {
  public:
    explicit PathCounts(const SeenSurfaces* seen) : seen_(seen) {}

    std::optional<ClassCounter> begin() const
    {
        return seen_ == nullptr ? std::nullopt : std::optional<ClassCounter>(*seen_);
    }
    void add(const std::optional<ClassCounter>& counter)
    {
        if (!counter)
            return;
        const std::lock_guard lock(mutex_);
        counter->add_to(sum_);
    }
    /// Returns the counts of all.  wanted: of their paths.
    SeenClasses take(const Wanted& wanted)
    {
        for (SeenClasses::OfLight& light : sum_.lights) {
            light.caustic = wanted.caustic ? light.caustic : 0;
            light.global = wanted.direct || wanted.indirect ? light.global : 0;
        }
        return std::move(sum_);
    }

  private:
    const SeenSurfaces* seen_;
    std::mutex mutex_;
    SeenClasses sum_;
};

/// Traces paths in chunks that are joined in order.  emit(share, random): their starts.
template <typename Emit>
TracedPhotons trace_paths(const RenderScene& scene, const PathKind& kind, const Emit& emit)
{
    const Part traced = kind.traced();
    std::vector<TracedPhotons> chunks((traced.size() + kPathsPerChunk - 1) / kPathsPerChunk);
    PathCounts counts(kind.options.seen);
    tbb::parallel_for(std::size_t{0}, chunks.size(), [&](std::size_t c) {
        TracedPhotons& photons = chunks[c];
        std::optional<ClassCounter> counter = counts.begin();
        Wanted wanted = kind.wanted;
        wanted.counter = counter ? &*counter : nullptr;
        const std::uint64_t begin = traced.begin + c * kPathsPerChunk;
        const std::uint64_t end = std::min(traced.end, begin + kPathsPerChunk);
        for (std::uint64_t i = begin; i < end; ++i) {
            const LightShare share = share_of(kind.plan, i);
            RandomSequence random = path_sequence(kind.options, kind.stream, share);
            const EmittedPath start = kind.guide == nullptr
                                          ? emit(share, random)
                                          : emit_guided(*kind.guide, share, random, emit);
            if (counter)
                counter->begin_path(share.light, start.power);
            if (max_channel(start.power) > 0)
                trace_light_path(scene, wanted, start, random, photons);
            if (kind.options.count_paths)
                photons.after_path.push_back(counts_of(photons));
        }
        counts.add(counter);
    });
    TracedPhotons out = join(chunks);
    out.seen = counts.take(kind.wanted);
    return out;
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
    wanted.glossy = options.store_glossy && wanted.caustic;
    wanted.arrivals = options.keep_arrivals;
    if (options.guides != nullptr && options.guides->splitting.usual > 0)
        wanted.splitting = &options.guides->splitting;
    wanted.paths = static_cast<double>(options.paths);
    return wanted;
}

TracedPhotons trace_without_aim(const RenderScene& scene, const PhotonOptions& options)
{
    const Wanted wanted = wanted_without_aim(options);
    if (!wanted.direct && !wanted.caustic && !wanted.indirect && !wanted.volume)
        return {};
    const EmissionGuide* const guide = guide_of(options, &PhotonGuides::without_aim);
    const Emitters emitters = options.media ? Emitters::all : Emitters::all_but_media;
    const PathKind kind{options, guide,
                        guide == nullptr ? plan_emission(scene.lights, options.paths, emitters)
                                         : plan_emission(*guide, options.paths),
                        RandomStream::photons, wanted};
    TracedPhotons out =
        trace_paths(scene, kind, [&](const LightShare& share, RandomSequence& random) {
            return emit_path(scene.lights, share, random);
        });
    out.emitted = kind.traced().size();
    return out;
}

TracedPhotons trace_aimed(const RenderScene& scene, const PhotonOptions& options)
{
    const std::vector<TargetSphere>& targets = scene.specular_targets;
    if (!options.light.caustic || options.caustic_paths == 0 || targets.empty())
        return {};
    Wanted wanted{false, true, false, options.link_bounces};
    wanted.volume = options.media;
    wanted.glossy = options.store_glossy;
    const EmissionGuide* const guide = guide_of(options, &PhotonGuides::aimed);
    const PathKind kind{options, guide,
                        guide == nullptr ? plan_emission(scene.lights, options.caustic_paths,
                                                         Emitters::all_but_media)
                                         : plan_emission(*guide, options.caustic_paths),
                        RandomStream::caustics, wanted};
    TracedPhotons out =
        trace_paths(scene, kind, [&](const LightShare& share, RandomSequence& random) {
            return emit_aimed_path(scene.lights, share, targets, random);
        });
    out.power = {}; // of no light of its own
    out.aimed = kind.traced().size();
    return out;
}

} // namespace

RandomSequence path_sequence(const PhotonOptions& options, RandomStream stream,
                             const LightShare& share)
{
    return {options.seed, stream, options.pass, share.light, share.path.place};
}

TracedPhotons trace_photons(const RenderScene& scene, const PhotonOptions& options)
{
    std::vector<TracedPhotons> both(2);
    both[0] = trace_without_aim(scene, options);
    both[1] = trace_aimed(scene, options);
    const std::uint64_t emitted = both[0].emitted, aimed = both[1].aimed;
    if (aimed == 0)
        return std::move(both[0]);
    TracedPhotons out = join(both);
    out.emitted = emitted;
    out.aimed = aimed;
    return out;
}

} // namespace hipmap
