#include "render/integrator/gather_path.h"

#include "render/film/pass_images.h"
#include "render/integrator/gather_branch.h"
#include "render/integrator/media_beams.h"

#include <cmath>
#include <utility>

namespace hipmap {

namespace {

/// Whether light changes nowhere but at faces and in what they enclose.
bool are_surfaces_alone(const MediaSet& media)
{
    return !media.scatters && !media.emits && is_black(media.around.absorption);
}

/// Radii of the estimates over the widest.
constexpr BeamScales kScales = {1, float{kNarrowing}, float{kNarrowing * kNarrowing}};

class GatherTracer {
  public:
    GatherTracer(const GatherMaps& maps, SeenLights seen, RandomSequence& random,
                 GatherScratch& scratch)
        : maps_(maps), seen_(seen), random_(random), scratch_(scratch)
    {
    }

    RadianceByRadius trace(const Ray& ray)
    {
        stack_.push({path_from_eye(maps_.scene, ray)});
        while (!stack_.empty())
            follow_kept(stack_.pop());
        return radiance_;
    }

  private:
    /// Light that the ray runs into counts: else it is the caustic map's, or has its own samples.
    bool adds_lights(const GatherBranch& branch) const
    {
        return branch.behind != EyePathClass::caustic && adds_met_light(seen_, branch.behind);
    }

    /// Gathered lobes send rays that bring more than the lights they meet.
    bool sends_rays() const { return maps_.rays != GatherRays::look_for_lights; }

    /// The branch is a final-gather ray that ends in photons, unless it is too short.
    bool ends_here(const GatherBranch& branch) const
    {
        return is_gathered(branch.behind) && maps_.rays != GatherRays::go_on;
    }

    void add(const Rgb& radiance)
    {
        for (Rgb& sum : radiance_)
            sum += radiance;
    }

    void follow_kept(const GatherBranch& branch)
    {
        const Rgb before = radiance_[0];
        follow(branch);
        if (branch.record == kNoRecord)
            return;
        const Rgb found = radiance_[0] - before;
        (*scratch_.records)[branch.record].light += sum_of_channels(found);
    }

    /// Keeps the ray that the gathered lobes of a surface sent.
    void keep_record(const Interaction& at, GatherBranch& sent)
    {
        if (scratch_.records == nullptr || at.phase != nullptr)
            return;
        sent.record = scratch_.records->size();
        scratch_.records->push_back({.at = {at.point.position, at.point.face, at.side},
                                     .direction = sent.ray.direction,
                                     .pdf = sent.source.pdf});
    }

    void follow(GatherBranch branch)
    {
        const RenderScene& scene = maps_.scene;
        const bool sees = adds_lights(branch);
        Rgb lights(0.0f);
        const MediaFlight reached = reach(scene, branch, sees, lights, [&] {
            const MediaBeams beams{*scene.media, *maps_.volume, kScales};
            return MediaFlight{see_media(beams, branch.ray, !is_gathered(branch.behind),
                                         {branch.inside, branch.throughput, radiance_})};
        });
        if (!reached.hit)
            return add(lights);
        const Interaction at = meet(scene, *reached.hit, random_, branch);
        if (sees)
            add(lights + met_emission(scene, at, reached.hit->distance, branch));
        const std::size_t start = std::exchange(branch.start, kNoRecord); // of this ray alone
        GatherBranch gathering = branch;
        const bool onward = at.gathers() &&
                            !is_for_group(start, branch, at, reached.hit->distance) &&
                            !add_photons(gathering, at, reached.hit->distance);
        if (onward)
            add_lights(gathering, at);
        if (at.follows() && !is_gathered(branch.behind) && sees)
            add(branch.throughput * light_sampled_light(scene, at, {.followed = 1}, random_));
        branch.photons =
            at.follows() && branch.behind == EyePathClass::specular ? add_glossy(branch, at) : 0;
        send_on(onward && sends_rays() ? &gathering : nullptr, branch, at);
    }

    /// Adds what the gathered lobes send back of light from samples.
    void add_lights(const GatherBranch& gathering, const Interaction& at)
    {
        const LobeRays rays{.gathered = 1,
                            .guide = gathering.guide,
                            .sky = gathering.sky,
                            .points = maps_.emissive_points};
        add(gathering.throughput * light_sampled_light(maps_.scene, at, rays, random_));
        if (!sends_rays())
            add(gathering.throughput * bsdf_sampled_light(maps_.scene, at, rays, random_));
    }

    /// Whether the end of the ray that the gathered lobes send may be shared.
    bool may_share(const GatherBranch& from, const Interaction& at) const
    {
        return scratch_.shares && !is_gathered(from.behind) && from.depth < kSplitDepth &&
               from.inside.count == 0 && is_black(from.absorption) &&
               !at.bsdf().transmits_diffusely && !shared_maps(maps_.global).maps.empty();
    }

    void keep_start(const GatherBranch& from, const Interaction& at, GatherBranch& sent)
    {
        sent.start = scratch_.starts.size();
        scratch_.starts.push_back({.sample = scratch_.sample,
                                   .at = at,
                                   .throughput = from.throughput,
                                   .indirect_radius = from.indirect_radius,
                                   .guide = from.guide});
        scratch_.starts.back().at.inside = nullptr; // the branch's
    }

    /// Returns the factor by which what a query of query_of finds is multiplied.
    Rgb factor_of(const PhotonLobes& lobes) const
    {
        return maps_.scene.directional ? Rgb(1) : lobes.base();
    }

    /// Whether what the gathered lobes send back is kept for the group of the ray's start.
    bool is_for_group(std::size_t start, const GatherBranch& branch, const Interaction& at,
                      float distance)
    {
        if (start == kNoRecord || at.bsdf().transmits_diffusely)
            return false;
        scratch_.starts[start].end = gather_end(branch, at, distance);
        return true;
    }

    GatherEnd gather_end(const GatherBranch& branch, const Interaction& at, float distance)
    {
        GatherEnd end{.point = at.point,
                      .normal = at.normal,
                      .separable = at.bsdf().is_separable && at.is_diffuse()};
        const PhotonLobes lobes(at);
        const PhotonQuery query = query_of(maps_.scene, at, lobes);
        const Rgb factor = factor_of(lobes);
        end.first_global = radius_at(maps_.first.global, maps_.surfaces, query);
        const float radius = maps_.scale.shrink * end.first_global;
        end.near = distance < radius;
        const RadianceByRadius before = std::exchange(radiance_, {});
        if (end.near)
            gather_anew(branch, at, query, factor);
        else
            add_gathered(factor, query, radius);
        end.global = std::exchange(radiance_, {});
        if (!shared_maps(maps_.caustic).maps.empty()) {
            end.first_caustic = radius_at(maps_.first.caustic, maps_.surfaces, query);
            add_within(factor, maps_.caustic, query, maps_.scale.shrink * end.first_caustic,
                       scratch_.caustic);
        }
        end.caustic = std::exchange(radiance_, before);
        return end;
    }

    /// Adds all that the gathered lobes send back but what the caustic map does, as if they were
    /// met first.
    void gather_anew(GatherBranch branch, const Interaction& at, const PhotonQuery& query,
                     const Rgb& factor)
    {
        const std::size_t waiting = stack_.size();
        branch.throughput = Rgb(1);
        branch.nanometres = 0; // light of all wavelengths
        add_first(branch, query, factor);
        add_lights(branch, at);
        Departures out;
        out.add(gather_ray(branch, at));
        send(out, true, random_, stack_);
        while (stack_.size() > waiting)
            follow_kept(stack_.pop());
    }

    /// Adds what the gathered lobes send back of light from the maps.  True: that is all; false:
    /// they are to send a ray on, with the throughput and radius now in `branch`.
    bool add_photons(GatherBranch& branch, const Interaction& at, float distance)
    {
        const PhotonLobes lobes(at);
        const PhotonQuery query = query_of(maps_.scene, at, lobes);
        if (at.bsdf().transmits_diffusely)
            return add_both_sides(branch, query, lobes);
        const Rgb factor = factor_of(lobes);
        add_caustic(branch, factor, query);
        if (ends_here(branch)) {
            if (shared_maps(maps_.global).maps.empty()) { // no photon has come anywhere
                keep(scratch_.importons, &Importons::global, query, branch.throughput * factor);
                return true;
            }
            const float first = radius_at(maps_.first.global, maps_.surfaces, query);
            branch.throughput *= weight_of(branch, query, first);
            const float radius = maps_.scale.shrink * first;
            keep(scratch_.importons, &Importons::global, query, branch.throughput * factor);
            if (!(branch.behind == EyePathClass::indirect && distance < radius)) {
                add_gathered(branch.throughput * factor, query, radius);
                return true;
            }
        }
        add_first(branch, query, factor);
        return false;
    }

    /// Adds the light of the indirect map and finds how the gathered lobes are to send a ray on.
    void add_first(GatherBranch& branch, const PhotonQuery& query, const Rgb& factor)
    {
        branch.gathered_at = query.position;
        if (maps_.guide != nullptr && sends_rays())
            branch.guide = directions_at(*maps_.guide, maps_.scene.partition, query);
        if (maps_.sky != nullptr)
            branch.sky = directions_at(*maps_.sky, maps_.scene.partition, query);
        if (maps_.rays != GatherRays::go_on)
            add_indirect(branch.throughput * factor, query, branch.indirect_radius);
    }

    /// Adds the light of both sides where light comes through the surface too.  A second surface so
    /// near to the first that it should be treated as that is not: photons of each side are weighed
    /// by a radius of their own.
    bool add_both_sides(GatherBranch& branch, PhotonQuery query, const PhotonLobes& lobes)
    {
        for (const bool other : {false, true}) {
            if (other)
                query = transmitted_side(query);
            const Rgb factor = maps_.scene.directional ? Rgb(1)
                               : other                 ? lobes.behind()
                                                       : lobes.base();
            add_caustic(branch, factor, query);
            if (is_gathered(branch.behind) && !shared_maps(maps_.global).maps.empty()) {
                const float first = radius_at(maps_.first.global, maps_.surfaces, query);
                const Rgb weight = branch.throughput * factor * weight_of(branch, query, first);
                keep(scratch_.importons, &Importons::global, query, weight);
                add_gathered(weight, query, maps_.scale.shrink * first);
            } else if (!is_gathered(branch.behind) && !shared_maps(maps_.indirect).maps.empty()) {
                branch.gathered_at = query.position;
                add_indirect(branch.throughput * factor, query,
                             other ? branch.transmitted_radius : branch.indirect_radius);
            }
        }
        return ends_here(branch);
    }

    /// Returns the weight of what the final-gather ray finds, from photons within `first` in the
    /// first pass.
    float weight_of(const GatherBranch& branch, const PhotonQuery& query, float first) const
    {
        const glm::vec3 way = query.position - branch.gathered_at;
        return gather_weight(
            {first, branch.indirect_radius, glm::dot(way, way), branch.by_specular}, maps_.scale);
    }

    void add_caustic(const GatherBranch& branch, const Rgb& factor, const PhotonQuery& query)
    {
        if (shared_maps(maps_.caustic).maps.empty())
            return keep(scratch_.importons, &Importons::caustic, query, branch.throughput * factor);
        const float first = radius_at(maps_.first.caustic, maps_.surfaces, query);
        const float share = is_gathered(branch.behind) ? weight_of(branch, query, first) : 1.0f;
        const Rgb weight = branch.throughput * factor * share;
        keep(scratch_.importons, &Importons::caustic, query, weight);
        add_within(weight, maps_.caustic, query, maps_.scale.shrink * first, scratch_.caustic);
    }

    /// Adds what followed lobes send back of light that came by specular surfaces alone.  Returns
    /// how many photons rays of these lobes compete with, as photons_against_rays has it; 0: none.
    float add_glossy(const GatherBranch& branch, const Interaction& at)
    {
        if (maps_.glossy == nullptr || shared_maps(*maps_.glossy).maps.empty())
            return 0;
        const PhotonLobes lobes(at, Lobes::followed);
        const PhotonQuery query = query_at(at, &lobes);
        const float first = radius_at(maps_.first.glossy, maps_.surfaces, query);
        if (!std::isfinite(first))
            return 0;
        add_within(branch.throughput, *maps_.glossy, query, maps_.scale.shrink * first,
                   scratch_.glossy);
        return photons_against_rays(maps_.first, first, maps_.scale, at);
    }

    /// first: becomes the first radius, infinite where gather rays alone find the light; stays if
    /// there are no photons.
    void add_indirect(const Rgb& factor, const PhotonQuery& query, float& first)
    {
        keep(scratch_.importons, &Importons::indirect, query, factor);
        if (shared_maps(maps_.indirect).maps.empty())
            return;
        first = radius_at(maps_.first.indirect, maps_.surfaces, query);
        if (std::isfinite(first))
            add_within(factor, maps_.indirect, query, maps_.scale.shrink * first,
                       scratch_.indirect);
    }

    static std::array<float, 3> narrowing(float radius)
    {
        return {radius, kScales[1] * radius, kScales[2] * radius};
    }

    void add_estimates(const Rgb& factor, const RadiusEstimates& found)
    {
        for (std::size_t i = 0; i < radiance_.size(); ++i)
            radiance_[i] += factor * found.irradiance[i];
    }

    /// Where a gather ray ends.
    void add_gathered(const Rgb& factor, const PhotonQuery& query, float radius)
    {
        add_estimates(factor, estimate_gathered(maps_.global, maps_.surfaces, query,
                                                narrowing(radius), scratch_.global));
    }

    void add_within(const Rgb& factor, const ChosenMaps& photons, const PhotonQuery& query,
                    float radius, ChosenScratch& scratch)
    {
        add_estimates(factor,
                      estimate_within(photons, maps_.surfaces, query, narrowing(radius), scratch));
    }

    GatherBranch gather_ray(const GatherBranch& from, const Interaction& at)
    {
        GatherBranch out = scatter(maps_.scene, from, at, Lobes::gathered, random_);
        out.source.points = maps_.emissive_points;
        return out;
    }

    /// gathering: the branch for the gathered lobes; null: they send no ray.
    void send_on(const GatherBranch* gathering, const GatherBranch& from, const Interaction& at)
    {
        Departures out;
        if (gathering != nullptr) {
            GatherBranch sent = gather_ray(*gathering, at);
            if (!is_gathered(from.behind))
                keep_record(at, sent);
            if (may_share(from, at))
                keep_start(*gathering, at, sent);
            out.add(sent);
        }
        if (at.follows())
            out.add(scatter(maps_.scene, from, at, Lobes::followed, random_));
        if (!at.is_diffuse())
            add_mirror_and_glass(maps_.scene, from, at, out);
        send(out, is_gathered(from.behind) || from.depth >= kSplitDepth, random_, stack_);
    }

    const GatherMaps& maps_;
    const SeenLights seen_;
    RandomSequence& random_;
    GatherScratch& scratch_;
    GatherBranchStack stack_;
    RadianceByRadius radiance_{};
};

} // namespace

GatherRays gather_rays(const RenderOptions& options)
{
    if (!options.light.indirect)
        return GatherRays::look_for_lights;
    return options.indirect == IndirectLight::paths ? GatherRays::go_on
                                                    : GatherRays::end_in_photons;
}

bool shares_gathers(const RenderScene& scene, const RenderOptions& options)
{
    const bool clear = !scene.opacity && (!scene.has_media() || are_surfaces_alone(*scene.media));
    return options.sharing == GatherSharing::neighbours && clear &&
           gather_rays(options) == GatherRays::end_in_photons;
}

RadianceByRadius trace_gather_path(const GatherMaps& maps, const Ray& ray, SeenLights seen,
                                   RandomSequence& random, GatherScratch& scratch)
{
    return GatherTracer(maps, seen, random, scratch).trace(ray);
}

} // namespace hipmap
