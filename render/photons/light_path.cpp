#include "render/photons/light_path.h"

#include "common/math/frame.h"
#include "common/math/sampling.h"
#include "render/paths/roulette.h"
#include "render/photons/media_flight.h"
#include "render/shading/interface_index.h"
#include "render/shading/scatter.h"

#include <array>
#include <utility>

namespace hipmap {

namespace {

constexpr int kMostBounces = 1 << 14; // Russian roulette ends paths long before
enum class Event { absorb, diffuse, gathered, followed, mirror, transmit, sheen, beyond };
constexpr int kLobes = 7;
using Shares = std::array<Rgb, kLobes>; ///< of the light, in the order of the events

/// Russian roulette in RGB, docs/light_transport.md (10): which lobe the path goes on in, and its
/// power there.  The power stays bounded by the largest channel of what came in.  lobes: so many of
/// the shares are not black.
inline Event choose_event(LightPath& path, const Shares& shares, int lobes, float u)
{
    const float incoming = max_channel(path.power);
    if (!(incoming > 0))
        return Event::absorb;
    std::array<float, kLobes> chance;
    float sum = 0;
    for (int i = 0; i < lobes; ++i)
        sum += chance[i] = max_channel(path.power * shares[i]) / incoming;
    const float scale = sum > 1 ? 1 / sum : 1;
    for (int i = 0; i < lobes; ++i) {
        const float p = chance[i] * scale;
        if (u < p) {
            path.power *= shares[i] / p;
            return static_cast<Event>(i + 1);
        }
        u -= p;
    }
    return Event::absorb;
}

/// Keeps the photon in the maps that want it, docs/photon_maps.md (1); `path.last` becomes it.
/// Like all that is done at a matt surface inlined by force: scenes with media have it once more.
[[gnu::always_inline]] inline void store(const Interaction& at, LightPath& path, bool directional,
                                         const Wanted& wanted, TracedPhotons& out)
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
    Rgb power = path.power * (at.cosine / geometric);
    if (!directional && !at.bsdf.is_matt())
        power *= through_coats(at.bsdf, at.seen());
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

/// Counts a bounce off a gathered lobe, after which light is of all wavelengths.
inline void bounce(LightPath& path)
{
    ++path.diffuse;
    path.nanometres = 0;
}

/// Sends the path on through the surface.  False: back into it.
[[gnu::noinline]] bool pass_diffusely(const Interaction& at, LightPath& path,
                                      RandomSequence& random, PowerBalance& balance)
{
    const glm::vec3 local = sample_cosine_hemisphere(random.next2());
    path.ray.direction = Frame(-at.shading_normal).to_world(local);
    path.ray.origin = offset_origin(at.point, -at.normal);
    const Rgb incoming = path.power;
    path.power *= through_coats(at.bsdf, incidence(at.bsdf, -path.ray.direction, local.z)) /
                  (1.0f - at.bsdf.coat_average);
    const bool out = glm::dot(path.ray.direction, at.normal) < 0;
    balance.absorbed += glm::dvec3(out ? incoming - path.power : incoming);
    bounce(path);
    return out;
}

/// Sends the path on by the diffuse lobe.  False: into the surface.
[[gnu::always_inline]] inline bool scatter_diffusely(const Interaction& at, LightPath& path,
                                                     RandomSequence& random, PowerBalance& balance)
{
    const glm::vec3 local = sample_cosine_hemisphere(random.next2());
    path.ray.direction = Frame(at.shading_normal).to_world(local);
    path.ray.origin = offset_origin(at.point, at.normal);
    const Rgb incoming = path.power;
    if (!at.bsdf.is_matt())
        path.power *= through_coats(at.bsdf, incidence(at.bsdf, path.ray.direction, local.z)) /
                      (1.0f - at.bsdf.coat_average);
    path.power *= diffuse_shape(at.bsdf, at.shading_normal, at.back, path.ray.direction);
    const bool out = glm::dot(path.ray.direction, at.normal) > 0;
    balance.absorbed += glm::dvec3(out ? incoming - path.power : incoming);
    bounce(path);
    return out;
}

/// Sends the path on along a direction already drawn from facets.
void follow_facet(const Interaction& at, const ScatterSample& sample, LightPath& path)
{
    path.ray = scattered_ray(at, sample);
    if (sample.transmitted)
        path.absorption = absorption_beyond(at);
}

/// Chooses a lobe, and counts what the surface keeps.
inline Event choose_lobe(LightPath& path, const Shares& shares, int lobes, RandomSequence& random,
                         PowerBalance& balance)
{
    Rgb sent(0.0f);
    for (int i = 0; i < lobes; ++i)
        sent += shares[i];
    balance.absorbed += glm::dvec3(path.power * (1.0f - sent));
    return choose_event(path, shares, lobes, random.next());
}

/// What the lobes of a surface would do with the path, docs/light_transport.md (10).
struct LobeSamples {
    ScatterSample gathered, followed, sheen;
    SpecularLobes specular;
};

LobeSamples sample_lobes(const Interaction& at, RandomSequence& random)
{
    LobeSamples out;
    if (at.bsdf.reflects(Reflection::gathered))
        out.gathered = sample_facets(at, Lobes::gathered, random);
    if (at.bsdf.follows())
        out.followed = sample_facets(at, Lobes::followed, random);
    if (at.bsdf.has_sheen())
        out.sheen = sample_sheen(at, random);
    out.specular = specular_lobes(at.bsdf, at.seen(), at.front, at.solid);
    return out;
}

/// Sends the path on by a lobe that is neither diffuse nor gathers.
void follow_specular(const Interaction& at, Event event, const LobeSamples& lobes, LightPath& path)
{
    if (event == Event::followed)
        follow_facet(at, lobes.followed, path);
    else if (event == Event::mirror)
        path.ray = mirror_ray(at);
    else
        path.ray = transmitted_ray(at, lobes.specular.eta);
    if (event == Event::transmit)
        path.absorption = absorption_beyond(at);
    path.specular = true;
    if (path.diffuse == 0 && !path.from_media)
        path.first_specular = true;
}

/// Sends the path on from a surface of more than the diffuse lobe.  False: it ends there.
[[gnu::noinline]] bool scatter_by_lobes(const Interaction& at, LightPath& path,
                                        RandomSequence& random, PowerBalance& balance)
{
    const LobeSamples lobes = sample_lobes(at, random);
    const Shares shares{diffuse_albedo(at.bsdf, at.seen()),
                        lobes.gathered.weight,
                        lobes.followed.weight,
                        lobes.specular.mirror,
                        lobes.specular.transmit,
                        lobes.sheen.weight,
                        passed_albedo(at.bsdf, at.seen())};
    const Event event = choose_lobe(path, shares, kLobes, random, balance);
    if (event == Event::absorb)
        return false;
    if (event == Event::diffuse)
        return scatter_diffusely(at, path, random, balance);
    if (event == Event::beyond)
        return pass_diffusely(at, path, random, balance);
    if (event == Event::gathered || event == Event::sheen) {
        follow_facet(at, event == Event::sheen ? lobes.sheen : lobes.gathered, path);
        bounce(path);
        return true;
    }
    follow_specular(at, event, lobes, path);
    return true;
}

/// Sends the path on from a surface.  False: it ends there.
[[gnu::always_inline]] inline bool scatter(const Interaction& at, LightPath& path,
                                           RandomSequence& random, PowerBalance& balance)
{
    const bool goes_on = !at.bsdf.is_matt() ? scatter_by_lobes(at, path, random, balance)
                                            : choose_lobe(path, {at.bsdf.diffuse}, 1, random,
                                                          balance) != Event::absorb &&
                                                  scatter_diffusely(at, path, random, balance);
    if (goes_on)
        path.power *= particle_correction(at, path.ray.direction);
    return goes_on;
}

/// Brings the path to the next surface, without media; none: it has left the scene.
std::optional<RayHit> fly(const RenderScene& scene, LightPath& path, TracedPhotons& out)
{
    const std::optional<RayHit> hit = scene.rays.nearest_face(path.ray);
    if (!hit) {
        out.power.escaped += glm::dvec3(path.power);
        return hit;
    }
    const Rgb sent = path.power;
    absorb(path.absorption, hit->distance, path.power);
    out.power.absorbed += glm::dvec3(sent - path.power);
    return hit;
}

/// True: the path goes on through the face, but leaves a photon, docs/light_transport.md (22).
[[gnu::noinline]] bool pass_face(const RenderScene& scene, const Interaction& at,
                                 const Wanted& wanted, RandomSequence& random, LightPath& path,
                                 TracedPhotons& out)
{
    if (random.next() < at.coverage)
        return false;
    const FaceId face = at.point.face;
    const Bsdf& worn = scene.bsdfs[scene.mesh().material_of_face[face]];
    if ((at.bsdf.gathers() || worn.gathers()) && scene.partition.map_of_face[face] != kNone) {
        LightPath passing = path;
        store(at, passing, scene.directional, wanted, out);
    }
    path.ray.origin = offset_origin(at.point, path.ray.direction);
    return true;
}

template <bool media>
void trace(const RenderScene& scene, const Wanted& wanted, RandomSequence& random, LightPath& path,
           TracedPhotons& out)
{
    for (int bounce = 0; bounce < kMostBounces; ++bounce) {
        if (bounce >= kEndlessDepth && !survives(kEndlessChance, random, path.power))
            return;
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
        if (at.coverage < 1 && pass_face(scene, at, wanted, random, path, out))
            continue;
        find_index(scene, at, path.nanometres, path.power, random);
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
    if (!scene.has_media())
        return trace<false>(scene, wanted, random, path, out);
    path.inside = interiors_at(*scene.media, path.ray.origin);
    trace<true>(scene, wanted, random, path, out);
}

} // namespace hipmap
