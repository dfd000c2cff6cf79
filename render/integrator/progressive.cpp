#include "render/integrator/progressive.h"

#include "common/freed_memory.h"
#include "render/integrator/emission_seeds.h"
#include "render/integrator/expect_light.h"
#include "render/integrator/find_seen_surfaces.h"
#include "render/integrator/gather_path.h"
#include "render/integrator/indirect_choice.h"
#include "render/integrator/pass_photons.h"
#include "render/integrator/photon_cache.h"
#include "render/integrator/photon_guides.h"
#include "render/integrator/picture_tiles.h"
#include "render/integrator/pilot_images.h"
#include "render/integrator/sky_guide.h"

#include <tbb/parallel_invoke.h>

#include <cmath>
#include <memory>

namespace hipmap {

namespace {

/// The share of its photons in the work of a pass, for the progress shown.
constexpr double kPhotonShare = 0.3;

/// For how many rays one counts while guides of photons are learnt: those that gather rays read are
/// to be many, as they bring less noise than bounced ones.  Measured, docs/light_transport.md (41).
constexpr float kGuidedRays = 4;

/// Returns the part of k by which the radii of the caustic map are found, docs/photon_maps.md (11).
double caustic_part(std::size_t photons)
{
    constexpr double kLeast = 0.4, kMany = 20'000;
    return std::clamp(std::cbrt(static_cast<double>(photons) / kMany), kLeast, 1.0);
}

/// Samples of a pixel of a pilot whose gather rays are learnt from, round by round.
constexpr SampleRange kGatherRounds[] = {{0, 2}, {2, 8}};

/// What all passes share.
struct Progressive {
    RenderOptions options; ///< with the choice of indirect light made
    std::shared_ptr<const ProgressiveRadii> first;
    std::shared_ptr<const PhotonGuides> guides = {}; ///< null: paths start by power
    std::shared_ptr<const SeenSurfaces> seen = {};   ///< where photons count; null: not known
    SampleAllocation allocation;
    ExpectedLight expected;
    PhotonCache* cache = nullptr;
};

/// One pass: its scene, options, number and radii.
struct ProgressivePass {
    MappedScene mapped;
    const RenderOptions& options;
    std::uint64_t number = 0;
    const PhotonGuides* guides = nullptr;
    const SeenSurfaces* seen_surfaces = nullptr; ///< where photons count; null: not counted
    double shrink = 1;                           ///< radius over the first radius
    SeenLights seen = SeenLights::added; ///< left_out: wherever they have no samples of their own
};

/// Pass `number` of the image, with the radii of its number.
ProgressivePass numbered_pass(const MappedScene& mapped, std::uint64_t number,
                              const Progressive& shared)
{
    return {.mapped = mapped,
            .options = shared.options,
            .number = number,
            .guides = shared.guides.get(),
            .seen_surfaces = shared.seen.get(),
            .shrink = radius_of_pass(number, shared.options.alpha)};
}

PhotonOptions linked_options(const ProgressivePass& pass)
{
    PhotonOptions photons = photon_options(pass.mapped.scene, pass.options, pass.number);
    if (pass.options.indirect == IndirectLight::paths)
        photons.light.indirect = false;
    photons.store_direct = photons.light.indirect; // for gather rays
    photons.link_bounces = photons.light.indirect;
    photons.store_glossy = photons.light.caustic;
    guide(pass.guides, photons);
    photons.seen = pass.seen_surfaces;
    return photons;
}

/// Returns the options of the maps by which first radii are found.  part: of k, docs/photon_maps.md
/// (11).
MapOptions radius_options(const ProgressivePass& pilot, EmissionGuide PhotonGuides::*kind,
                          double part = 1)
{
    MapOptions out = pilot.options.maps;
    // Gather rays average over many estimates: more of the gain is to go into less bias.
    const double more = std::sqrt(neighbours_by(pilot.guides, kind));
    const double neighbours = part * out.neighbours * more;
    out.neighbours = std::max(2u, static_cast<std::uint32_t>(std::lround(neighbours)));
    return out;
}

/// Rays that are shared bring photons from more directions.
GatherScale scale_of(const ProgressivePass& pass)
{
    const bool shares = shares_gathers(pass.mapped.scene, pass.options);
    return gather_scale(static_cast<float>(pass.options.samples), static_cast<float>(pass.shrink),
                        shares ? pass.options.maps.neighbours
                               : radius_options(pass, &PhotonGuides::without_aim).neighbours);
}

/// Gather rays of a pixel, and of those that share what theirs find.
float gather_rays_of_pixel(const ProgressivePass& pass)
{
    const int pixels = shares_gathers(pass.mapped.scene, pass.options) ? kSharing : 1;
    return static_cast<float>(pixels * static_cast<int>(pass.options.samples));
}

/// By photons of their own, as many as a pass has.
ProgressiveRadii find_first_radii(const ProgressivePass& pilot, const PilotTeam& team)
{
    const MappedScene& mapped = pilot.mapped;
    const RenderOptions& options = pilot.options;
    TracedPhotons traced = trace_together(mapped.scene, linked_options(pilot), team);
    std::vector<Photon> indirect;
    indirect.reserve(traced.bounces.size());
    for (const BouncedPhoton& bounced : traced.bounces)
        indirect.push_back(bounced.photon);
    free_array(traced.bounces);
    const auto field = [&](std::vector<Photon>& photons, const MapOptions& maps,
                           const RadiusField::Rules& rules = {}) {
        const ChosenMaps built =
            build_chosen_maps(photons, mapped.surfaces, maps, estimated(options));
        free_array(photons);
        return build_radius_field(built, mapped.surfaces, rules);
    };
    const MapOptions caustic =
        radius_options(pilot, &PhotonGuides::aimed, caustic_part(traced.caustic.size()));
    const MapOptions aimed = radius_options(pilot, &PhotonGuides::aimed);
    const MapOptions others = radius_options(pilot, &PhotonGuides::without_aim);
    std::vector<Photon> glossy;
    double power = 0;
    for (const GlossyPhoton& one : traced.glossy) {
        glossy.push_back(one.photon);
        power += max_channel(one.photon.power) / static_cast<double>(traced.glossy.size());
    }
    const RadiusField::Rules infinite{.sparse = RadiusField::Sparse::infinite};
    return {FirstRadii{field(traced.caustic, caustic, {.sharp = true}),
                       field(traced.global, others), field(indirect, others, infinite),
                       field(glossy, aimed, infinite), static_cast<float>(power)},
            volume_radii(mapped.scene, traced, options)};
}

/// Runs the builders of the maps of a pass at the same time: where one map has most photons,
/// threads would wait at its root.  Many photons are built one kind after another, which takes a
/// fifth less memory, and they keep the threads busy by themselves.
template <typename... Build>
void in_parallel_unless_many(const TracedPhotons& traced, const Build&... build)
{
    constexpr std::size_t kMany = std::size_t{1} << 23;
    if (traced.global.size() + traced.caustic.size() < kMany)
        tbb::parallel_invoke(build...);
    else
        (build(), ...);
}

/// previous: of the same pass of the previous frame, which maps may be taken over from; null: none.
ProgressiveMaps make_maps(const ProgressivePass& pass, const ProgressiveRadii& first,
                          ProgressiveMaps* previous, RenderStatistics& statistics)
{
    const MappedScene& mapped = pass.mapped;
    const RenderScene& scene = mapped.scene;
    const RenderOptions& options = pass.options;
    TracedPhotons traced = trace_pass(scene, linked_options(pass), statistics);
    const Stopwatch watch;
    ProgressiveMaps maps;
    // Each kind gives its photons back as soon as its map has them.
    const auto build = [&](ChosenMaps ProgressiveMaps::*to, std::vector<Photon>& photons,
                           MapRequest request, KindStatistics& kind) {
        request.previous = previous == nullptr ? nullptr : &(previous->*to);
        maps.*to = build_maps(mapped, photons, request, kind);
        free_array(photons);
    };
    auto indirect = weigh_bounces(traced, first.surfaces, mapped.surfaces, scale_of(pass));
    free_array(traced.bounces);
    const DissertationOptions read = estimated(options), ends = gathered(scene, options);
    const MapRequest plain{options.maps, read};
    MapOptions directed = options.maps;
    directed.directions = true;
    using Maps = ProgressiveMaps;
    in_parallel_unless_many(
        traced,
        [&] {
            build(&Maps::global, traced.global, {options.maps, ends}, statistics.global);
        },
        [&] { build(&Maps::indirect, indirect, plain, statistics.indirect); },
        [&] { build(&Maps::caustic, traced.caustic, plain, statistics.caustic); },
        [&] {
            std::vector<Photon> glossy =
                weigh_glossy(traced, first.surfaces, mapped.surfaces, scale_of(pass));
            build(&Maps::glossy, glossy, {directed, read}, statistics.glossy);
        },
        [&] {
            maps.volume =
                build_volume(scene, traced, first.volume, static_cast<float>(pass.shrink));
        });
    count_maps(maps.volume, watch, statistics);
    return maps;
}

GlossyRivals rivals_of(const ProgressivePass& pass, const ProgressiveRadii& first)
{
    return {&first.surfaces, &pass.mapped.surfaces, scale_of(pass)};
}

GatherMaps gathered_maps(const ProgressivePass& pass, const ProgressiveRadii& first,
                         const ProgressiveMaps& photons, int emissive_points = 1)
{
    return {pass.mapped.scene,
            pass.mapped.surfaces,
            photons.caustic,
            photons.global,
            photons.indirect,
            first.surfaces,
            scale_of(pass),
            gather_rays(pass.options),
            photons.volume ? &*photons.volume : nullptr,
            &first.guide,
            &first.sky,
            &photons.glossy,
            emissive_points};
}

/// Calls `use` with the maps of a part of the photons of a pass.
template <typename Use>
auto with_few_photons(const ProgressivePass& pilot, const ProgressiveRadii& first, const Use& use)
{
    RenderStatistics ignored;
    const RenderOptions small = pilot_options(pilot.options);
    const ProgressivePass few{pilot.mapped, small, pilot.number, pilot.guides};
    const ProgressiveMaps photons = make_maps(few, first, nullptr, ignored);
    return use(gathered_maps(few, first, photons));
}

/// Finds where the image asks for photons, by few of them, which only say where gather rays end.
/// Renders a coarse image from them if one is asked for.
Importons find_importons(const ProgressivePass& pilot, const ProgressiveRadii& first,
                         const PilotControl& pilots)
{
    const RenderScene& scene = pilot.mapped.scene;
    return with_few_photons(pilot, first, [&](const GatherMaps& maps) {
        const SampleAllocation evenly;
        if (pilots.coarse)
            pilots.coarse(render_coarse<3, GatherScratch>(
                {scene, pilot.options, kPilotPass, evenly}, pilots,
                [&](const Ray& ray, SeenLights seen, RandomSequence& random,
                    GatherScratch& scratch) {
                    return trace_gather_path(maps, ray, seen, random, scratch);
                }));
        return trace_importons(
            scene, pilot.options,
            [&](const Ray& ray, RandomSequence& random, Importons& kept) {
                GatherScratch scratch;
                scratch.importons = &kept;
                return trace_gather_path(maps, ray, SeenLights::left_out, random, scratch)[0];
            },
            pilots.team);
    });
}

/// Learns where light paths should start; a black image does not say it.
std::shared_ptr<const PhotonGuides> find_guides(const ProgressivePass& pilot,
                                                const ProgressiveRadii& first,
                                                const Importons& importons,
                                                const PilotControl& pilots)
{
    if (!(importons.light > 0))
        return nullptr;
    const MapSurfaces& surfaces = pilot.mapped.surfaces;
    GatherScale scale = scale_of(pilot);
    scale.rays *= kGuidedRays;
    PhotonWorth worth = make_worth(importons, surfaces, [&](const TracedPhotons& traced) {
        return weigh_bounces(traced, first.surfaces, surfaces, scale);
    });
    worth.radii = &first.surfaces;
    worth.rays = gather_rays_of_pixel(pilot);
    PhotonOptions learning = linked_options(pilot);
    learning.pass = kPilotPass - 1;
    return learn_guides(pilot.mapped, learning, worth,
                        emission_seeds(pilot.mapped.scene, importons, learning.seed), pilots);
}

/// Learns where gather rays find light, from rays of pilots that read the maps of one; from few, if
/// they show that lobes alone are as good.
PlacedGuides find_directions(const ProgressivePass& pilot, const ProgressiveRadii& first,
                             const PilotTeam& team)
{
    const RenderScene& scene = pilot.mapped.scene;
    return with_few_photons(pilot, first, [&](const GatherMaps& maps) {
        std::vector<GatherRecord> records;
        PlacedGuides out;
        for (const SampleRange& of_pixel : kGatherRounds) {
            const std::vector<GatherRecord> found = trace_gather_rays(
                scene, pilot.options, of_pixel,
                [&](const Ray& ray, RandomSequence& random, std::vector<GatherRecord>& kept) {
                    GatherScratch scratch;
                    scratch.records = &kept;
                    trace_gather_path(maps, ray, SeenLights::left_out, random, scratch);
                },
                team);
            records.insert(records.end(), found.begin(), found.end());
            out = learn_directions(scene.partition, records);
            if (out.values.empty())
                break;
        }
        return out;
    });
}

RenderedPass gather_pass(const ProgressivePass& pass, const Progressive& shared,
                         const ProgressiveMaps& photons, const PassControl& control,
                         RenderStatistics& statistics)
{
    const RenderScene& scene = pass.mapped.scene;
    const GatherMaps maps =
        gathered_maps(pass, *shared.first, photons, shared.allocation.emissive_points);
    const bool sharing = shares_gathers(scene, pass.options);
    const PixelGroups groups = sharing ? sharing_groups(pass.number) : PixelGroups{};
    const TileTracer tracer{
        [&](const Ray& ray, SeenLights seen, RandomSequence& random, GatherScratch& scratch) {
            scratch.shares = sharing;
            const auto out =
                trace_gather_path(maps, ray, std::max(seen, pass.seen), random, scratch);
            ++scratch.sample;
            return out;
        },
        [&](TracedRows<3>& rows, GatherScratch& scratch) {
            share_gathers(scene, maps.scale, groups, scratch.starts, rows);
            scratch.starts.clear();
            scratch.sample = 0;
        },
        [&](const GatherScratch& scratch) { scratch.count(statistics); }};
    return render_clamped_tiles<3, GatherScratch>({scene, pass.options, pass.number,
                                                   shared.allocation, groups,
                                                   rivals_of(pass, *shared.first)},
                                                  after(control, kPhotonShare), statistics, tracer);
}

RenderedPass render_pass(const ProgressivePass& pass, const Progressive& shared,
                         const PassControl& control, RenderStatistics& statistics)
{
    const auto photons = maps_of_pass(shared.cache, pass.number, statistics,
                                      [&](ProgressiveMaps* previous, RenderStatistics& made) {
                                          return make_maps(pass, *shared.first, previous, made);
                                      });
    return gather_pass(pass, shared, *photons, control, statistics);
}

/// Allocates samples by two images from the same photons; returns the mean of their channels.
double render_pilot(const MappedScene& mapped, const PilotControl& pilots, Progressive& shared)
{
    if (stopped_together(pilots))
        return 0;
    RenderStatistics ignored;
    const auto pilot = [&](const RenderOptions& rows, std::uint64_t number) {
        return ProgressivePass{.mapped = mapped,
                               .options = rows,
                               .number = number,
                               .guides = shared.guides.get(),
                               .seen = SeenLights::left_out};
    };
    const RenderOptions whole = pilot_rows(shared.options, {});
    const auto photons = maps_of_pass(
        shared.cache, kPilotPass, ignored, [&](ProgressiveMaps* previous, RenderStatistics& made) {
            return make_maps(pilot(whole, kPilotPass), *shared.first, previous, made);
        });
    Progressive evenly;
    evenly.first = shared.first;
    const PilotImages found =
        render_pilots(mapped.scene, shared.options, pilots.team,
                      {.rivals = rivals_of(numbered_pass(mapped, 0, shared), *shared.first),
                       .emissive_points = true},
                      [&](const RenderOptions& rows, std::uint64_t number) {
                          return gather_pass(pilot(rows, number), evenly, *photons,
                                             {.progress = {}, .stop = pilots.stop}, ignored)
                              .images.radiance.pixels;
                      });
    const RenderOptions& options = shared.options;
    shared.allocation =
        allocate_samples(found.noise(), options.width, options.height, options.samples);
    shared.expected = expect_light(found.noise(), options, shared.allocation);
    return found.mean();
}

/// Finds what the passes share, from pilots.  Guides serve one camera: with them the passes keep no
/// maps for other images, so that a frame is the same whatever was rendered before it.
void prepare(const MappedScene& mapped, const PilotControl& pilots, Progressive& shared)
{
    const RenderOptions& options = shared.options;
    ProgressivePass pilot{mapped, options, kPilotPass};
    const bool known = shared.cache != nullptr && shared.cache->radii;
    ProgressiveRadii first = known ? *shared.cache->radii : find_first_radii(pilot, pilots.team);
    if (shared.cache != nullptr)
        shared.cache->radii = std::make_shared<const ProgressiveRadii>(first);
    const Importons importons = find_importons(pilot, first, pilots);
    if (options.emission == Emission::guided)
        shared.guides = find_guides(pilot, first, importons, pilots);
    SeenSurfaces seen = find_seen_surfaces(mapped, importons, linked_options(pilot));
    if (seen.unit > 0)
        shared.seen = std::make_shared<const SeenSurfaces>(std::move(seen));
    const bool stopped = stopped_together(pilots);
    if (shared.guides && !stopped) {
        shared.cache = nullptr;
        pilot.guides = shared.guides.get();
        first = find_first_radii(pilot, pilots.team);
    }
    if (options.gather == GatherDirections::guided && !stopped) {
        first.sky = learn_sky(mapped.scene, importons.indirect, options.seed);
        if (gather_rays(options) == GatherRays::end_in_photons)
            first.guide = find_directions(pilot, first, pilots.team);
    }
    shared.first = std::make_shared<const ProgressiveRadii>(std::move(first));
}

/// Returns a checksum of all that the passes take from pilots.
std::uint64_t checksum(const Progressive& shared)
{
    std::uint64_t out = checksum(shared.allocation);
    out = mix_bits(out ^ checksum(shared.first->guide));
    out = mix_bits(out ^ checksum(shared.first->sky));
    if (shared.options.indirect == IndirectLight::paths)
        out = mix_bits(out);
    return shared.guides ? mix_bits(out ^ checksum(*shared.guides)) : out;
}

} // namespace

PassSource make_progressive_source(const RenderScene& scene, const RenderOptions& options,
                                   RenderStatistics& statistics, PhotonCache* cache,
                                   const PilotControl& pilots)
{
    const auto surfaces = std::make_shared<const MapSurfaces>(scene.mesh(), scene.partition);
    const auto shared = std::make_shared<Progressive>();
    shared->options = options;
    shared->options.indirect = choose_indirect(scene, options, pilots, statistics);
    shared->cache = shared->options.indirect == IndirectLight::paths ? nullptr : cache;
    prepare({scene, *surfaces}, pilots, *shared);
    PassSource source;
    set_window(source, options);
    source.pilot_mean = render_pilot({scene, *surfaces}, pilots, *shared);
    source.alpha = options.alpha;
    source.clamped = options.clamp > 0;
    source.photons = shared->options.indirect == IndirectLight::paths ? 0 : options.photons;
    source.allocation = checksum(*shared);
    source.expected = shared->expected;
    if (shared->seen)
        statistics.seen_scale = scale_of(*shared->seen);
    count_guides(shared->guides.get(), statistics);
    source.bias = precomputes(scene, options) ? BiasKnowledge::unknown : BiasKnowledge::from_radii;
    source.render = [&scene, &statistics, surfaces, shared](std::uint64_t pass,
                                                            const PassControl& control) {
        return render_pass(numbered_pass({scene, *surfaces}, pass, *shared), *shared, control,
                           statistics);
    };
    source.render_in = [&statistics, shared](const RenderScene& now, std::uint64_t pass,
                                             const PassControl& control) {
        const MapSurfaces surfaces_now(now.mesh(), now.partition);
        Progressive uncached = *shared;
        uncached.cache = nullptr;
        return render_pass(numbered_pass({now, surfaces_now}, pass, uncached), uncached, control,
                           statistics);
    };
    return source;
}

} // namespace hipmap
