#include "render/integrator/path_tracer.h"

#include "render/integrator/sampled_source.h"
#include "render/paths/path_state.h"

namespace hipmap {

namespace {

/// Probabilities of the lobes of a surface; they add up to one, or are all zero if it is black.
struct LobeProbabilities {
    float gathered = 0.0f, followed = 0.0f, mirror = 0.0f, transmit = 0.0f;
};

/// docs/light_transport.md (14).
class PathTracer {
  public:
    /// ray: from the eye.
    PathTracer(const RenderScene& scene, const Ray& ray, const LightClasses& light, SeenLights seen,
               RandomSequence& random)
        : scene_(scene), light_(light), seen_(seen), random_(random),
          path_(path_from_eye(scene, ray))
    {
    }

    Rgb trace()
    {
        while (goes_on())
            ;
        return radiance_;
    }

    /// To the first ray that gathered lobes send.  False: the path has ended before.
    bool trace_to_gather_ray()
    {
        while (!is_gathered(path_.behind))
            if (!goes_on())
                return false;
        return true;
    }

    const Rgb& radiance() const { return radiance_; } ///< so far
    int depth() const { return path_.depth; }

  private:
    bool goes_on() { return survives(path_, random_) && step(); }

    /// To the next surface or scattering, and on; no throughput is left where the path ends. False:
    /// it has left the scene.
    bool step()
    {
        const bool adds_lights = (light_.caustic || path_.behind != EyePathClass::caustic) &&
                                 adds_met_light(seen_, path_.behind);
        const MediaFlight reached =
            reach(scene_, path_, adds_lights, radiance_, [this] { return fly(*scene_.media); });
        if (reached.scattered) {
            const Medium& medium = scene_.media->medium(path_.inside.current());
            leave_gathered(scattering_point(path_.ray.origin, -path_.ray.direction, medium.phase,
                                            path_.inside));
            return true;
        }
        if (!reached.hit)
            return false;
        const Interaction at = meet(scene_, *reached.hit, random_, path_);
        if (adds_lights)
            radiance_ += met_emission(scene_, at, reached.hit->distance, path_);
        if (!at.is_diffuse())
            leave(at);
        else if (max_channel(path_.throughput * at.bsdf().diffuse) > 0 && may_gather())
            leave_gathered(at);
        else
            path_.throughput = Rgb(0);
        return true;
    }

    /// The light sampled for followed lobes counts.
    bool samples_for_followed() const
    {
        return is_gathered(path_.behind) ? light_.caustic : adds_met_light(seen_, path_.behind);
    }

    bool may_gather() const { return light_.indirect || !is_gathered(path_.behind); }

    /// Adds what the media on the way emit.  docs/media.md (6).
    MediaFlight fly(const MediaSet& media)
    {
        return fly_through_media(media, path_, path_.throughput, random_,
                                 [this](const Medium& medium, float optical_depth) {
                                     radiance_ +=
                                         path_.throughput * emitted_along(medium, optical_depth);
                                 });
    }

    LobeProbabilities probabilities_at(const Interaction& at, const SpecularLobes& lobes) const
    {
        LobeProbabilities out;
        if (at.gathers() && may_gather())
            out.gathered = max_channel(path_.throughput * scattered_share(at, Lobes::gathered));
        if (at.follows())
            out.followed = max_channel(path_.throughput * scattered_share(at, Lobes::followed));
        out.mirror = max_channel(path_.throughput * lobes.mirror);
        out.transmit = max_channel(path_.throughput * lobes.transmit);
        const float sum = out.gathered + out.followed + out.mirror + out.transmit;
        if (!(sum > 0))
            return {};
        out.gathered /= sum;
        out.followed /= sum;
        out.mirror /= sum;
        out.transmit /= sum;
        return out;
    }

    /// Adds the light sampled at a surface, draws a set of lobes, and sends the path on by it.
    void leave(const Interaction& at)
    {
        const SpecularLobes lobes = specular_lobes(at);
        const LobeProbabilities probabilities = probabilities_at(at, lobes);
        const LobeRays rays{probabilities.gathered,
                            samples_for_followed() ? probabilities.followed : 0};
        if (rays.gathered + rays.followed > 0)
            radiance_ += path_.throughput * light_sampled_light(scene_, at, rays, random_);
        float drawn = random_.next();
        if (drawn < probabilities.gathered)
            return follow({Lobes::gathered, probabilities.gathered}, at);
        drawn -= probabilities.gathered;
        if (drawn < probabilities.followed)
            return follow({Lobes::followed, probabilities.followed}, at);
        drawn -= probabilities.followed;
        if (drawn < probabilities.mirror)
            go_by_mirror(scene_, at, lobes, probabilities.mirror, path_);
        else if (probabilities.transmit > 0)
            go_through(scene_, at, lobes, probabilities.transmit, path_);
        else
            path_.throughput = Rgb(0);
    }

    /// Continues the path where there is only one gathered lobe: a diffuse surface, or a point of a
    /// medium.
    void leave_gathered(const Interaction& at)
    {
        radiance_ += path_.throughput * light_sampled_light(scene_, at, {.gathered = 1}, random_);
        follow({Lobes::gathered}, at);
    }

    void follow(const PickedLobes& picked, const Interaction& at)
    {
        go_by_lobes(scene_, at, picked, random_, path_);
    }

    const RenderScene& scene_;
    const LightClasses& light_;
    const SeenLights seen_;
    RandomSequence& random_;
    PathState path_;
    Rgb radiance_{0.0f};
};

struct PathMethod : SampledEvenly {
    static constexpr BiasKnowledge kBias = BiasKnowledge::unbiased;

    const RenderScene& scene;

    explicit PathMethod(const RenderScene& of) : scene(of) {}
    static PathMethod at(const RenderScene& now) { return PathMethod(now); }

    struct Pass {
        const RenderScene& scene;
        const LightClasses& light;

        Pass(const PathMethod& method, const PictureJob& job, RenderStatistics& /*statistics*/)
            : scene(method.scene), light(job.options.light)
        {
        }

        Rgb trace(const Ray& ray, SeenLights seen, RandomSequence& random,
                  Scratch& /*scratch*/) const
        {
            return trace_path(scene, ray, random, light, seen);
        }
    };
};

} // namespace

Rgb trace_path(const RenderScene& scene, const Ray& ray, RandomSequence& random,
               const LightClasses& light, SeenLights seen)
{
    return PathTracer(scene, ray, light, seen, random).trace();
}

PathPair trace_path_pair(const RenderScene& scene, const Ray& ray, RandomSequence& random,
                         const LightClasses& light)
{
    PathTracer path(scene, ray, light, SeenLights::left_out, random);
    if (!path.trace_to_gather_ray())
        return {path.radiance(), path.radiance(), path.depth()};
    PathTracer other = path;
    const PathTracer gathering = path;
    const Rgb first = path.trace();
    return {first, other.trace(), path.depth(), path.depth() > gathering.depth(),
            first != gathering.radiance()};
}

PassSource make_path_source(const RenderScene& scene, const RenderOptions& options,
                            RenderStatistics& statistics, const PilotControl& pilots)
{
    return make_sampled_source(PathMethod(scene), options, statistics, pilots);
}

} // namespace hipmap
