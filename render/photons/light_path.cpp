#include "render/photons/light_path.h"

#include "common/math/frame.h"
#include "common/math/sampling.h"
#include "render/photons/media_flight.h"
#include "render/shading/scatter.h"

#include <utility>

namespace hipmap {

namespace {

/// Russian roulette ends paths long before this; between perfect mirrors nothing else would.
constexpr int kMostBounces = 512;
enum class Event { absorb, diffuse, gathered, followed, mirror, transmit };
constexpr int kLobes = 5;

/// Russian roulette in RGB, docs/light_transport.md (10): which lobe the path goes on in, and its
/// power there.  The power stays bounded by the largest channel of what came in.
Event choose_event(LightPath& path, const Rgb (&shares)[kLobes], float u)
{
    const float incoming = max_channel(path.power);
    if (!(incoming > 0))
        return Event::absorb;
    float chance[kLobes];
    float sum = 0;
    for (int i = 0; i < kLobes; ++i)
        sum += chance[i] = max_channel(path.power * shares[i]) / incoming;
    const float scale = sum > 1 ? 1 / sum : 1;
    for (int i = 0; i < kLobes; ++i) {
        const float p = chance[i] * scale;
        if (u < p) {
            path.power *= shares[i] / p;
            return static_cast<Event>(i + 1);
        }
        u -= p;
    }
    return Event::absorb;
}

/// Keeps the photon in the maps that want it, docs/photon_maps.md (1).
void store(const Interaction& at, LightPath& path, bool directional, const Wanted& wanted,
           TracedPhotons& out)
{
    const std::uint64_t from = std::exchange(path.last, kNoPhoton);
    const bool media_last = std::exchange(path.media_last, false);
    const bool caustic = (path.specular || path.from_media) && path.diffuse == 0;
    const bool keep = caustic            ? wants_undiffused(path, wanted)
                      : path.diffuse > 0 ? wanted.indirect
                                         : wanted.direct;
    const bool by_media = media_last && path.diffuse > 0 && wanted.indirect;
    const bool link = wanted.bounces && (from != kNoPhoton || by_media);
    if (!keep && !link)
        return;
    const float geometric = glm::dot(at.back, at.normal);
    Rgb power = path.power * (at.cosine / (geometric * at.coverage));
    if (!directional)
        power *= coat_half(at.bsdf, at.cosine);
    const BouncedPhoton bounced{
        {at.point.position, power, at.back, at.point.face, at.side}, from, path.last_caustic};
    if (!is_finite(power) || !is_finite(at.point.position)) {
        ++out.dropped;
        return;
    }
    if (link)
        out.bounces.push_back(bounced);
    if (keep) {
        std::vector<Photon>& kept = caustic ? out.caustic : out.global;
        path.last = kept.size();
        path.last_caustic = caustic;
        kept.push_back(bounced.photon);
    }
}

/// Sends the path on by the diffuse lobe.  False: into the surface.
bool scatter_diffusely(const Interaction& at, LightPath& path, RandomSequence& random,
                       PowerBalance& balance)
{
    const glm::vec3 local = sample_cosine_hemisphere(random.next2());
    path.ray.direction = Frame(at.shading_normal).to_world(local);
    path.ray.origin = offset_origin(at.point, at.normal);
    const Rgb incoming = path.power;
    path.power *= coat_half(at.bsdf, local.z) / (1.0f - at.bsdf.coat_average) *
                  diffuse_shape(at.bsdf, at.shading_normal, at.back, path.ray.direction);
    const bool out = glm::dot(path.ray.direction, at.normal) > 0;
    balance.absorbed += glm::dvec3(out ? incoming - path.power : incoming);
    ++path.diffuse;
    return out;
}

/// Sends the path on along a direction already drawn from facets.
void follow_facet(const Interaction& at, const ScatterSample& sample, LightPath& path)
{
    path.ray = scattered_ray(at, sample);
    if (sample.transmitted)
        path.absorption = absorption_beyond(at);
}

/// Sends the path on from a surface.  False: it ends there.
bool scatter(const Interaction& at, LightPath& path, RandomSequence& random, PowerBalance& balance)
{
    // Glossy lobes have no albedo in closed form: a direction is drawn first, and what its facet
    // sends on is the share.
    ScatterSample gathered, followed;
    if (at.bsdf.reflects(Reflection::gathered))
        gathered = sample_facets(at, Lobes::gathered, random);
    if (at.bsdf.follows())
        followed = sample_facets(at, Lobes::followed, random);
    const SpecularLobes specular = specular_lobes(at.bsdf, at.cosine, at.front, at.solid);
    const Rgb shares[kLobes] = {diffuse_albedo(at.bsdf, at.cosine), gathered.weight,
                                followed.weight, specular.mirror, specular.transmit};
    Rgb sent(0.0f);
    for (const Rgb& share : shares)
        sent += share;
    balance.absorbed += glm::dvec3(path.power * (1.0f - sent));

    switch (choose_event(path, shares, random.next())) {
    case Event::absorb:
        return false;
    case Event::diffuse:
        if (!scatter_diffusely(at, path, random, balance))
            return false;
        break;
    case Event::gathered:
        follow_facet(at, gathered, path);
        ++path.diffuse;
        break;
    case Event::followed:
        follow_facet(at, followed, path);
        path.specular = true;
        break;
    case Event::mirror:
        path.ray = mirror_ray(at);
        path.specular = true;
        break;
    case Event::transmit:
        path.ray = transmitted_ray(at, specular.eta);
        path.absorption = absorption_beyond(at);
        path.specular = true;
        break;
    }
    if (path.specular && path.diffuse == 0 && !path.from_media)
        path.first_specular = true;
    path.power *= particle_correction(at, path.ray.direction);
    return true;
}

/// Brings the path to the next surface where there are no media but glass that absorbs; none: it
/// has left the scene.
std::optional<RayHit> fly(const RenderScene& scene, LightPath& path, TracedPhotons& out)
{
    const std::optional<RayHit> hit = scene.rays.nearest(path.ray);
    if (!hit) {
        out.power.escaped += glm::dvec3(path.power);
        return hit;
    }
    const Rgb arriving = path.power * transmittance(path.absorption, hit->distance);
    out.power.absorbed += glm::dvec3(path.power - arriving);
    path.power = arriving;
    return hit;
}

template <bool media>
void trace(const RenderScene& scene, const Wanted& wanted, RandomSequence& random, LightPath& path,
           TracedPhotons& out)
{
    for (int bounce = 0; bounce < kMostBounces; ++bounce) {
        std::optional<RayHit> hit;
        if constexpr (media)
            hit = fly_through_media(*scene.media, wanted, random, path, out);
        else
            hit = fly(scene, path, out);
        if (!hit)
            return;
        Interaction at = interact(scene, path.ray, *hit);
        if constexpr (media)
            at.inside = &path.inside;
        if (at.bsdf.gathers() && scene.partition.map_of_face[hit->face] != kNone)
            store(at, path, scene.directional, wanted, out);
        else if (at.bsdf.gathers())
            path.last = kNoPhoton;
        if (!scatter(at, path, random, out.power))
            return;
        if constexpr (media)
            if (glm::dot(path.ray.direction, at.normal) < 0)
                cross(*scene.media, hit->face, at.front, path.inside);
        if (is_done(path, wanted)) {
            out.power.absorbed += glm::dvec3(path.power);
            return;
        }
    }
    ++out.cut;
}

} // namespace

void trace_light_path(const RenderScene& scene, const Wanted& wanted, const EmittedPath& start,
                      RandomSequence& random, TracedPhotons& out)
{
    LightPath path;
    path.ray = start.ray;
    path.power = start.power;
    path.from_media = start.from_medium;
    out.power.emitted += glm::dvec3(path.power);
    if (!scene.media)
        return trace<false>(scene, wanted, random, path, out);
    path.inside = interiors_at(*scene.media, path.ray.origin);
    trace<true>(scene, wanted, random, path, out);
}

} // namespace hipmap
