#include "render/photons/light_path.h"

#include "render/paths/roulette.h"
#include "render/photons/cross_media.h"

#include <utility>

namespace hipmap {

namespace {

constexpr int kMostBounces = 1 << 14; // Russian roulette ends paths long before

/// The way on from a surface, drawn from all that there are.
struct Onward {
    enum class By { nothing, lobe, mirror, transmission };
    By by = By::nothing;
    const PlacedLobe* lobe = nullptr; ///< by one of those
    LobeSample sample;                ///< from it
    SpecularLobes specular;           ///< of the surface
};

/// Draws one of several ways in proportion to the light that goes each, one after another.
class WayDraw {
  public:
    /// power: of the light that arrives, above zero.  u: [0, 1).
    WayDraw(const Rgb& power, float u) : power_(power), incoming_(max_channel(power)), u_(u) {}

    /// True: the way is the one drawn so far.
    bool offer(const Rgb& share)
    {
        const float probability = max_channel(power_ * share) / incoming_;
        sum_ += probability;
        sent_ += share;
        const float drawn = u_ * sum_;
        const bool taken = drawn < probability;
        if (probability > 0)
            u_ = taken ? drawn / probability : (drawn - probability) / (sum_ - probability);
        if (taken)
            chosen_ = {share, probability};
        return taken;
    }

    /// Takes back what was offered.
    void take_back() { sum_ = 0, sent_ = Rgb(0); }

    /// What all ways send of the light.
    const Rgb& sent() const { return sent_; }

    /// Russian roulette in RGB, docs/light_transport.md (10): power of the light that goes the way
    /// drawn; zero: it is absorbed.  Its largest channel is that of the light that arrives, times
    /// the sum of all ways' probabilities where that is above 1.
    Rgb power() const
    {
        if (!(sum_ > 0) || (sum_ < 1 && !(u_ < sum_)))
            return Rgb(0);
        return power_ * chosen_.share * (std::max(sum_, 1.0f) / chosen_.probability);
    }

  private:
    struct Chosen {
        Rgb share{0.0f};
        float probability = 1.0f;
    };
    Rgb power_, sent_{0.0f};
    float incoming_, u_, sum_ = 0.0f;
    Chosen chosen_;
};

/// Returns Lambert's lobe where it is all that a surface has; null: it has others.
const Lambert* lambert_alone(const Bsdf& bsdf)
{
    return bsdf.is_diffuse && bsdf.count == 1 ? std::get_if<Lambert>(&bsdf.all[0].lobe) : nullptr;
}

/// Offers Lambert's lobe where it is all.  Its samples weigh the same, so only light that goes on
/// needs a direction.
void offer_lambert(const Interaction& at, const Lambert& lambert, WayDraw& draw,
                   RandomSequence& random, Onward& out)
{
    if (!draw.offer(lambert.reflectance) || is_black(draw.power()))
        return;
    out.by = Onward::By::lobe;
    out.lobe = at.bsdf().all.data();
    out.sample = sample_lobe(at, *out.lobe, random);
    if (is_black(out.sample.weight)) // behind the face, as the shading normal is bent
        draw.take_back();
}

void offer_lobes(const Interaction& at, WayDraw& draw, RandomSequence& random, Onward& out)
{
    for (const PlacedLobe& lobe : at.bsdf().lobes()) {
        if (lobe.handled == Lobes::specular)
            continue;
        const LobeSample sample = sample_lobe(at, lobe, random);
        if (!draw.offer(sample.weight))
            continue;
        out.by = Onward::By::lobe;
        out.lobe = &lobe;
        out.sample = sample;
    }
}

/// Draws the way on, and sets the path's power there; counts what the surface keeps.
Onward draw_way(const Interaction& at, LightPath& path, RandomSequence& random,
                PowerBalance& balance)
{
    Onward out;
    if (!(max_channel(path.power) > 0))
        return out;
    WayDraw draw(path.power, random.next());
    const Bsdf& bsdf = at.bsdf();
    if (const Lambert* lambert = lambert_alone(bsdf))
        offer_lambert(at, *lambert, draw, random, out);
    else
        offer_lobes(at, draw, random, out);
    if (bsdf.is_specular) {
        out.specular = specular_lobes(at);
        if (draw.offer(out.specular.mirror))
            out.by = Onward::By::mirror;
        if (draw.offer(out.specular.transmit))
            out.by = Onward::By::transmission;
    }
    balance.absorbed += glm::dvec3(path.power * (1.0f - draw.sent()));
    path.power = draw.power();
    if (is_black(path.power))
        out.by = Onward::By::nothing;
    return out;
}

/// Keeps the photon in the maps that want it, docs/photon_maps.md (1); `path.last` becomes it,
/// as if the path went on by a gathered lobe.
void store(const Interaction& at, LightPath& path, bool directional, const Wanted& wanted,
           TracedPhotons& out)
{
    const LeftGathered from = std::exchange(path.last, {});
    const bool caustic = is_caustic(path.behind);
    const bool keep = wants_class(path.behind, wanted);
    const bool by_media = from.media && path.diffuse > 0 && wanted.indirect;
    const bool link = wanted.bounces && (from.photon != kNoPhoton || by_media);
    if (!keep && !link)
        return;
    const float geometric = glm::dot(at.back, at.normal);
    const float part = part_brought(path.behind, wanted);
    Rgb power = path.power * (part * at.cosine / geometric);
    if (!directional)
        power *= transmitted_by(at.bsdf().layers, Depth::diffuse, at.seen());
    Photon photon{at.point.position, power, at.back, at.point.face, at.side};
    if (!is_finite(power) || !is_finite(at.point.position)) {
        ++out.dropped;
        return;
    }
    if (keep) {
        if (wanted.counter != nullptr)
            wanted.counter->add(photon, path.first_specular, caustic);
        std::vector<Photon>& kept = caustic ? out.caustic : out.global;
        path.last = {.photon = kept.size(), .caustic = caustic, .part = part};
        kept.push_back(photon);
    }
    if (link) {
        photon.power *= from.part;
        out.bounces.push_back({photon, from.caustic, from.specular, from.photon});
    }
}

/// Keeps the photon at a surface with followed lobes, docs/light_transport.md (44).
void store_glossy(const Interaction& at, const LightPath& path, const Wanted& wanted,
                  TracedPhotons& out)
{
    const float cosine = glm::dot(at.back, at.normal);
    const float radiance = max_channel(path.radiance) * cosine / followed_peak(at);
    const Rgb power = path.power * (part_brought(path.behind, wanted) * at.cosine / cosine);
    if (is_finite(power) && is_finite(at.point.position) && radiance > 0)
        out.glossy.push_back(
            {{at.point.position, power, at.back, at.point.face, at.side}, radiance});
}

/// Sends the path on from a surface.  False: it ends there.
bool scatter(const RenderScene& scene, const Interaction& at, LightPath& path,
             RandomSequence& random, PowerBalance& balance)
{
    const Onward onward = draw_way(at, path, random, balance);
    Lobes lobes = Lobes::specular;
    switch (onward.by) {
    case Onward::By::nothing:
        return false;
    case Onward::By::lobe:
        lobes = onward.lobe->handled;
        path.radiance = Rgb(0);
        leave_by_lobes(scene, at, onward.sample, lobes, path);
        break;
    case Onward::By::mirror:
        leave_by_mirror(scene, at, path);
        path.radiance *= onward.specular.mirror;
        break;
    case Onward::By::transmission:
        leave_through(scene, at, onward.specular.eta, path);
        path.radiance *= onward.specular.transmit;
        break;
    }
    if (lobes == Lobes::gathered) {
        ++path.diffuse;
        path.behind = LightPathClass::indirect;
    } else if (path.behind == LightPathClass::direct) {
        path.behind = LightPathClass::caustic;
        path.first_specular = at.point.face;
    }
    path.power *= onward.by == Onward::By::lobe ? particle_correction(at, path.ray.direction)
                                                : specular_correction(at, path.ray.direction);
    return true;
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
    const Rgb left = transmittance(path.absorption, hit->distance);
    path.power *= left;
    path.radiance *= left;
    out.power.absorbed += glm::dvec3(sent - path.power);
    return hit;
}

/// Sends the path on through a face that its opacity does not stop.  Stores a photon there all the
/// same, docs/light_transport.md (22).
void pass_face(const RenderScene& scene, const Interaction& at, const Wanted& wanted,
               LightPath& path, TracedPhotons& out)
{
    const FaceId face = at.point.face;
    const Bsdf& worn = scene.bsdfs[scene.mesh().material_of(face)];
    if ((at.bsdf().gathers || worn.gathers) && scene.partition.map_of(face) != kNone) {
        LightPath passing = path;
        store(at, passing, scene.directional, wanted, out);
    }
    path.ray.origin = offset_origin(at.point, path.ray.direction);
}

/// Marks the end of an arrival that is not known yet.
constexpr PhotonCounts kOpen{kNoPhoton, kNoPhoton, kNoPhoton};

/// Ends the arrivals from `first` on that have no end: the path that they are of is at its own.
void close_arrivals(std::size_t first, TracedPhotons& out)
{
    for (std::size_t i = first; i < out.arrivals.size(); ++i)
        if (out.arrivals[i].after.global == kOpen.global)
            out.arrivals[i].after = counts_of(out);
}

/// What a light path goes through the scene with.
struct Traced {
    const RenderScene& scene;
    const Wanted& wanted;
    RandomSequence& random;
    TracedPhotons& out;
};

/// A surface that a path has met.
struct Met {
    const Interaction& at;
    bool gathers;      ///< photons are kept there
    LeftGathered last; ///< of the path when it came
    int splits = 1;    ///< into so many it splits
};

Place place_of(const Interaction& at)
{
    return {at.point.position, at.point.face, at.side};
}

/// Sends the path on.  False: it is at its end.
bool send_on(const Traced& in, const Met& met, LightPath& path)
{
    const Interaction& at = met.at;
    if (in.wanted.arrivals && met.gathers)
        in.out.arrivals.push_back({place_of(at), in.out.after_path.size(),
                                   sum_of_channels(path.power), met.splits, counts_of(in.out),
                                   kOpen});
    const int diffuse = path.diffuse;
    if (!scatter(in.scene, at, path, in.random, in.out.power))
        return false;
    if (path.diffuse == diffuse) { // a gather ray that comes the other way goes on here too
        path.last = met.last;
        path.last.specular = true;
    }
    if (is_done(path, in.wanted)) {
        in.out.power.absorbed += glm::dvec3(path.power);
        return false;
    }
    return true;
}

void trace(const Traced& in, LightPath& path);

/// Splits the path, docs/light_transport.md (52): follows all but one of the paths to their ends.
void split(const Traced& in, Met& met, LightPath& path)
{
    if (in.wanted.splitting == nullptr || !met.gathers)
        return;
    const double power = double{sum_of_channels(path.power)} * in.wanted.paths;
    met.splits =
        splits_at(*in.wanted.splitting, in.scene.partition, place_of(met.at), power, path.of);
    path.of *= met.splits;
    path.power /= static_cast<float>(met.splits);
    for (int i = 1; i < met.splits; ++i) {
        const std::size_t first = in.out.arrivals.size();
        LightPath other = path;
        if (send_on(in, met, other))
            trace(in, other);
        close_arrivals(first, in.out);
    }
}

/// Stores the photons of a path where it meets a surface.
Met meet(const Traced& in, const Interaction& at, LightPath& path)
{
    const auto& [scene, wanted, random, out] = in;
    const LeftGathered last = path.last;
    const bool has_map = scene.partition.map_of(at.point.face) != kNone;
    const bool gathers = at.bsdf().gathers && has_map;
    if (gathers)
        store(at, path, scene.directional, wanted, out);
    else if (at.bsdf().gathers)
        path.last = {};
    if (wanted.glossy && at.follows() && path.behind == LightPathClass::caustic &&
        !is_black(path.radiance) && has_map)
        store_glossy(at, path, wanted, out);
    return {at, gathers, last};
}

/// Follows the path to its end.
void trace(const Traced& in, LightPath& path)
{
    const auto& [scene, wanted, random, out] = in;
    for (int bounce = 0; bounce < kMostBounces; ++bounce) {
        if (bounce >= kEndlessDepth && !survives(kEndlessProbability, random, path.power))
            return;
        const std::optional<RayHit> hit = scene.has_media()
                                              ? cross_media(*scene.media, wanted, random, path, out)
                                              : fly(scene, path, out);
        if (!hit)
            return;
        Interaction at = meet_face(scene, *hit, path);
        if (at.opacity < 1 && random.next() >= at.opacity) {
            pass_face(scene, at, wanted, path, out);
            continue;
        }
        find_index(scene, at, path.nanometres, path.power, random);
        Met met = meet(in, at, path);
        split(in, met, path);
        if (!send_on(in, met, path))
            return;
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
    path.radiance = start.radiance;
    if (start.from_medium)
        path.behind = LightPathClass::volume;
    out.power.emitted += glm::dvec3(path.power);
    if (scene.has_media())
        path.inside = medium_stack_at(*scene.media, path.ray.origin);
    const std::size_t first = out.arrivals.size();
    trace({scene, wanted, random, out}, path);
    close_arrivals(first, out);
}

} // namespace hipmap
