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
    EmissionPlan plan;
    RandomStream stream = RandomStream::photons;
    Wanted wanted;
    Wanted wanted_enclosed; ///< of the paths of enclosed lights

    const Wanted& wanted_of(const RenderScene& scene, std::size_t light) const
    {
        return scene.enclosed_lights[light] == 0 ? wanted : wanted_enclosed;
    }

    /// Returns which paths of the plan are traced.
    Part traced() const { return part_of(plan.paths, options.part, options.parts); }

    /// Returns how densely paths of a light start at a point, times their number.
    double density(std::size_t light, const PrimarySample& at) const
    {
        const std::uint64_t paths = plan.first_path[light + 1] - plan.first_path[light];
        return static_cast<double>(paths) *
               (guide == nullptr ? 1 : density_at(guide->lights[light].density, at));
    }
};

/// Paths of one kind, and those of the other.
struct KindOfTwo {
    const PathKind& own;
    const PathKind& other;

    /// Returns what is wanted of a path of a light.  start: by the guide, if there is one.
    Wanted wanted(const RenderScene& scene, std::size_t light, const DrawnPrimary& start) const
    {
        Wanted out = own.wanted_of(scene, light);
        if (scene.enclosed_lights[light] != 0) {
            const double by_own = own.density(light, start.at);
            out.caustic_part =
                static_cast<float>(by_own / (by_own + other.density(light, start.at)));
        }
        return out;
    }
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
    /// Returns the counts of all.  wanted(light): of its paths.
    template <typename OfLight>
    SeenClasses take(const OfLight& wanted)
    {
        for (std::size_t i = 0; i < sum_.lights.size(); ++i) {
            const Wanted& of_light = wanted(i);
            SeenClasses::OfLight& light = sum_.lights[i];
            light.caustic = of_light.caustic ? light.caustic : 0;
            light.global = of_light.direct || of_light.indirect ? light.global : 0;
        }
        return std::move(sum_);
    }

  private:
    const SeenSurfaces* seen_;
    std::mutex mutex_;
    SeenClasses sum_;
};

/// Traces paths of a kind in chunks that are joined in order.  emit(share, random): their starts.
template <typename Emit>
TracedPhotons trace_paths(const RenderScene& scene, const KindOfTwo& of, const Emit& emit)
{
    const PathKind& kind = of.own;
    const Part traced = kind.traced();
    std::vector<TracedPhotons> chunks((traced.size() + kPathsPerChunk - 1) / kPathsPerChunk);
    PathCounts counts(kind.options.seen);
    tbb::parallel_for(std::size_t{0}, chunks.size(), [&](std::size_t c) {
        TracedPhotons& photons = chunks[c];
        std::optional<ClassCounter> counter = counts.begin();
        const std::uint64_t begin = traced.begin + c * kPathsPerChunk;
        const std::uint64_t end = std::min(traced.end, begin + kPathsPerChunk);
        for (std::uint64_t i = begin; i < end; ++i) {
            const LightShare share = share_of(kind.plan, i);
            RandomSequence random = path_sequence(kind.options, kind.stream, share);
            DrawnPrimary first;
            if (kind.guide != nullptr)
                first = draw_start(*kind.guide, share.light, random);
            const EmittedPath start =
                kind.guide == nullptr ? emit(share, random) : emit_from(first, share, random, emit);
            Wanted wanted = of.wanted(scene, share.light, first);
            wanted.counter = counter ? &*counter : nullptr;
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
    out.seen = counts.take([&](std::size_t light) { return kind.wanted_of(scene, light); });
    return out;
}

/// What is kept of the paths that are not aimed.  caustic: photons of caustics too.
Wanted wanted_without_aim(const PhotonOptions& options, bool caustic)
{
    Wanted wanted;
    wanted.direct = options.store_direct;
    wanted.caustic = caustic;
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

PathKind kind_without_aim(const RenderScene& scene, const PhotonOptions& options)
{
    const bool caustic = options.light.caustic;
    const Wanted wanted = wanted_without_aim(options, caustic && options.caustic_paths == 0);
    const bool any = wanted.direct || wanted.caustic || wanted.indirect || wanted.volume;
    const std::uint64_t paths = any ? options.paths : 0;
    const Emitters emitters = options.media ? Emitters::all : Emitters::all_but_media;
    const EmissionGuide* const guide = guide_of(options, &PhotonGuides::without_aim);
    return {options,
            guide,
            guide == nullptr ? plan_emission(scene.lights, paths, emitters)
                             : plan_emission(*guide, paths),
            RandomStream::photons,
            wanted,
            wanted_without_aim(options, caustic)};
}

/// Returns the shares of lights in the aimed paths where there is no guide.  without_aim: there are
/// other paths, which leave the caustics of enclosed lights.
EmissionGuide even_aimed(const RenderScene& scene, bool without_aim)
{
    EmissionGuide out = even_guide(scene.lights, Emitters::all_but_media);
    for (std::size_t i = 0; i < out.lights.size(); ++i)
        if (without_aim && scene.enclosed_lights[i] != 0)
            out.lights[i].share = 0;
    return out;
}

PathKind kind_aimed(const RenderScene& scene, const PhotonOptions& options, bool without_aim)
{
    Wanted wanted{.caustic = true, .bounces = options.link_bounces};
    wanted.volume = options.media;
    wanted.glossy = options.store_glossy;
    const bool any = options.light.caustic && !scene.specular_targets.empty();
    const EmissionGuide* const guide = guide_of(options, &PhotonGuides::aimed);
    return {options,
            guide,
            plan_emission(guide == nullptr ? even_aimed(scene, without_aim) : *guide,
                          any ? options.caustic_paths : 0),
            RandomStream::caustics,
            wanted,
            wanted};
}

TracedPhotons trace_without_aim(const RenderScene& scene, const KindOfTwo& paths)
{
    TracedPhotons out =
        trace_paths(scene, paths, [&](const LightShare& share, RandomSequence& random) {
            return emit_path(scene.lights, share, random);
        });
    out.emitted = paths.own.traced().size();
    return out;
}

TracedPhotons trace_aimed(const RenderScene& scene, const KindOfTwo& paths)
{
    TracedPhotons out =
        trace_paths(scene, paths, [&](const LightShare& share, RandomSequence& random) {
            return scene.enclosed_lights[share.light] != 0
                       ? emit_path(scene.lights, share, random)
                       : emit_aimed_path(scene.lights, share, scene.specular_targets, random);
        });
    out.power = {}; // of no light of its own
    out.aimed = paths.own.traced().size();
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
    const PathKind without_aim = kind_without_aim(scene, options);
    const PathKind aimed = kind_aimed(scene, options, without_aim.plan.paths > 0);
    both[0] = trace_without_aim(scene, {without_aim, aimed});
    both[1] = trace_aimed(scene, {aimed, without_aim});
    const std::uint64_t emitted = both[0].emitted, caustic_paths = both[1].aimed;
    if (caustic_paths == 0)
        return std::move(both[0]);
    TracedPhotons out = join(both);
    out.emitted = emitted;
    out.aimed = caustic_paths;
    return out;
}

} // namespace hipmap
