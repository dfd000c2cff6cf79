#include "experiments/rivals/irradiance_cache.h"

#include "common/math/frame.h"
#include "experiments/rivals/pixels.h"
#include "experiments/rivals/seen_surface.h"
#include "render/integrator/path_tracer.h"

#include <limits>

namespace hipmap {

namespace {

constexpr float kNearest = 0.005f; // the least distance of a record, in scene units
constexpr float kFarthest = 0.5f;  // and the largest
constexpr float kBehind = 0.05f;   // of a record's distance: points farther before it are not its
constexpr int kFirstStep = 8;      // pixels between the first records

/// The stratified samples of a hemisphere: M rings of equal projected area, N sectors.
struct HemisphereSamples {
    int rings = 1, sectors = 1;
    std::vector<Rgb> light;      ///< [rings sectors]
    std::vector<float> distance; ///< [rings sectors]

    std::size_t index(int ring, int sector) const
    {
        return static_cast<std::size_t>(ring) * sectors + (sector + sectors) % sectors;
    }
    float sine(float ring) const { return std::sqrt(ring / static_cast<float>(rings)); }
    float angle(float sector) const { return 2 * kPi * sector / static_cast<float>(sectors); }
};

glm::vec3 across(const Frame& frame, float angle)
{
    return std::cos(angle) * frame.x + std::sin(angle) * frame.y;
}

HemisphereSamples take_samples(const SurfacePoint& point, const Frame& frame, int rays,
                               const IncomingLight& incoming, RandomSequence& random)
{
    HemisphereSamples out;
    out.rings = std::max(1, static_cast<int>(std::lround(std::sqrt(rays / kPi))));
    out.sectors = std::max(2, rays / out.rings);
    for (int ring = 0; ring < out.rings; ++ring)
        for (int sector = 0; sector < out.sectors; ++sector) {
            const glm::vec2 u = random.next2();
            const float sine = out.sine(static_cast<float>(ring) + u.x);
            const float angle = out.angle(static_cast<float>(sector) + u.y);
            Ray ray;
            ray.direction =
                sine * across(frame, angle) + std::sqrt(std::max(0.0f, 1 - sine * sine)) * frame.z;
            ray.origin = offset_origin(point, frame.z);
            float distance = std::numeric_limits<float>::infinity();
            const Rgb light = incoming(ray, random, distance);
            out.light.push_back(is_finite(light) ? light : Rgb(0));
            out.distance.push_back(distance);
        }
    return out;
}

/// Ward and Heckbert 1992, the gradient by rotation: along the axis about which the normal turns.
void add_rotation(const HemisphereSamples& from, const Frame& frame, CacheRecord& out)
{
    const float each = kPi / static_cast<float>(from.light.size());
    for (int sector = 0; sector < from.sectors; ++sector) {
        Rgb sum(0.0f);
        for (int ring = 0; ring < from.rings; ++ring) {
            const float sine = from.sine(static_cast<float>(ring) + 0.5f);
            sum += sine / std::sqrt(1 - sine * sine) * from.light[from.index(ring, sector)];
        }
        const glm::vec3 axis =
            across(frame, from.angle(static_cast<float>(sector) + 0.5f) + kPi / 2);
        for (int channel = 0; channel < 3; ++channel)
            out.turned[static_cast<std::size_t>(channel)] += each * sum[channel] * axis;
    }
}

/// Ward and Heckbert 1992, the gradient by translation: strata grow at the cost of those beyond an
/// edge as the point moves.
void add_translation(const HemisphereSamples& from, const Frame& frame, CacheRecord& out)
{
    for (int sector = 0; sector < from.sectors; ++sector) {
        Rgb outwards(0.0f), sideways(0.0f);
        for (int ring = 0; ring < from.rings; ++ring) {
            const std::size_t here = from.index(ring, sector);
            const std::size_t beside = from.index(ring, sector - 1);
            const float inner = from.sine(static_cast<float>(ring));
            const float outer = from.sine(static_cast<float>(ring + 1));
            sideways += (outer - inner) / std::min(from.distance[here], from.distance[beside]) *
                        (from.light[here] - from.light[beside]);
            if (ring == 0)
                continue;
            const std::size_t within = from.index(ring - 1, sector);
            outwards += inner * (1 - inner * inner) /
                        std::min(from.distance[here], from.distance[within]) *
                        (from.light[here] - from.light[within]);
        }
        outwards *= from.angle(1);
        const glm::vec3 out_axis = across(frame, from.angle(static_cast<float>(sector) + 0.5f));
        const glm::vec3 side_axis = across(frame, from.angle(static_cast<float>(sector)) + kPi / 2);
        for (int channel = 0; channel < 3; ++channel)
            out.moved[static_cast<std::size_t>(channel)] +=
                outwards[channel] * out_axis + sideways[channel] * side_axis;
    }
}

/// Where the gradient would bring the irradiance down to zero the record does not reach (Krivanek
/// et al. 2005): few bright rays make steep gradients.
void limit_by_gradient(CacheRecord& record)
{
    for (int channel = 0; channel < 3; ++channel) {
        const float steepest = glm::length(record.moved[static_cast<std::size_t>(channel)]);
        if (steepest * record.distance > record.irradiance[channel])
            record.distance = std::max(kNearest, record.irradiance[channel] / steepest);
    }
}

/// A weight of Ward's above `least`, or zero: the record is too far away or turned.
float weight_of(const CacheRecord& record, const glm::vec3& position, const glm::vec3& normal,
                float least)
{
    const glm::vec3 way = position - record.position;
    const float turn = std::sqrt(std::max(0.0f, 1 - glm::dot(normal, record.normal)));
    const float weight = 1 / (glm::length(way) / record.distance + turn);
    if (!(weight > least) || glm::dot(way, normal + record.normal) < -2 * kBehind * record.distance)
        return 0;
    return std::min(weight, 1e6f);
}

/// The records in an octree over [-1, 1]^3: each in all nodes about as large as it reaches.
class IrradianceCache {
  public:
    explicit IrradianceCache(float tolerance) : tolerance_(tolerance) { nodes_.emplace_back(); }

    void add(const CacheRecord& record)
    {
        insert({0, glm::vec3(0), 1}, static_cast<std::uint32_t>(records_.size()), record.position,
               tolerance_ * record.distance);
        records_.push_back(record);
    }

    /// Returns the irradiance interpolated at a point; none: no record is near enough.
    std::optional<Rgb> look_up(const glm::vec3& position, const glm::vec3& normal) const
    {
        Rgb sum(0.0f);
        float weights = 0;
        Place at{0, glm::vec3(0), 1};
        while (true) {
            for (const std::uint32_t i : nodes_[at.node].records)
                add_record(records_[i], position, normal, sum, weights);
            const std::size_t octant = octant_of(at, position);
            if (nodes_[at.node].children[octant] == 0)
                break;
            at = child(at, octant);
        }
        return weights > 0 ? std::optional(glm::max(sum / weights, 0.0f)) : std::nullopt;
    }

    std::size_t bytes() const
    {
        std::size_t sum = records_.size() * sizeof(CacheRecord) + nodes_.size() * sizeof(Node);
        for (const Node& node : nodes_)
            sum += node.records.size() * sizeof(std::uint32_t);
        return sum;
    }

  private:
    struct Node {
        std::array<std::uint32_t, 8> children{}; ///< 0: none
        std::vector<std::uint32_t> records;
    };
    struct Place {
        std::uint32_t node;
        glm::vec3 centre;
        float half;
    };

    static std::size_t octant_of(const Place& at, const glm::vec3& position)
    {
        return (position.x > at.centre.x ? 1u : 0u) + (position.y > at.centre.y ? 2u : 0u) +
               (position.z > at.centre.z ? 4u : 0u);
    }

    Place child(const Place& at, std::size_t octant) const
    {
        const float half = at.half / 2;
        const glm::vec3 to((octant & 1) != 0 ? half : -half, (octant & 2) != 0 ? half : -half,
                           (octant & 4) != 0 ? half : -half);
        return {nodes_[at.node].children[octant], at.centre + to, half};
    }

    void insert(const Place& at, std::uint32_t record, const glm::vec3& position, float radius)
    {
        if (at.half < 2 * radius) {
            nodes_[at.node].records.push_back(record);
            return;
        }
        for (std::size_t octant = 0; octant < 8; ++octant) {
            Place below = child(at, octant);
            if (glm::any(glm::greaterThan(glm::abs(position - below.centre),
                                          glm::vec3(below.half + radius))))
                continue;
            if (below.node == 0) {
                below.node = static_cast<std::uint32_t>(nodes_.size());
                nodes_[at.node].children[octant] = below.node;
                nodes_.emplace_back();
            }
            insert(below, record, position, radius);
        }
    }

    void add_record(const CacheRecord& record, const glm::vec3& position, const glm::vec3& normal,
                    Rgb& sum, float& weights) const
    {
        const float weight = weight_of(record, position, normal, 1 / tolerance_);
        if (!(weight > 0))
            return;
        Rgb value = record.irradiance;
        for (int channel = 0; channel < 3; ++channel) {
            const auto c = static_cast<std::size_t>(channel);
            value[channel] += glm::dot(glm::cross(record.normal, normal), record.turned[c]) +
                              glm::dot(position - record.position, record.moved[c]);
        }
        sum += weight * value;
        weights += weight;
    }

    float tolerance_;
    std::vector<CacheRecord> records_;
    std::vector<Node> nodes_;
};

/// Fills the cache where it has no record yet, and reads it.
class CachedLight {
  public:
    CachedLight(const RenderScene& scene, const RivalSettings& settings)
        : scene_(scene), settings_(settings), cache_(settings.tolerance)
    {
    }

    /// Returns the indirect irradiance at a surface.
    Rgb irradiance(const Interaction& at)
    {
        if (const std::optional<Rgb> found = cache_.look_up(at.point.position, at.shading_normal))
            return *found;
        RandomSequence random(settings_.seed, RandomStream::photons, 0, made_++);
        const CacheRecord record = sample_hemisphere(
            at.point, at.shading_normal, settings_.directions,
            [this](const Ray& ray, RandomSequence& more, float& distance) {
                return incoming(ray, more, distance);
            },
            random);
        cache_.add(record);
        return record.irradiance;
    }

    std::size_t bytes() const { return cache_.bytes(); }

  private:
    /// Light that another surface has scattered; none that a light sends straight or over mirrors.
    Rgb incoming(const Ray& ray, RandomSequence& random, float& distance) const
    {
        distance = distance_of(scene_.rays.nearest(ray));
        return trace_path(scene_, ray, random, {.caustic = false}, SeenLights::left_out);
    }

    const RenderScene& scene_;
    const RivalSettings& settings_;
    IrradianceCache cache_;
    std::uint64_t made_ = 0;
};

} // namespace

CacheRecord sample_hemisphere(const SurfacePoint& point, const glm::vec3& normal, int rays,
                              const IncomingLight& incoming, RandomSequence& random)
{
    const Frame frame(normal);
    const HemisphereSamples samples = take_samples(point, frame, rays, incoming, random);
    CacheRecord out;
    out.position = point.position;
    out.normal = normal;
    float nearness = 0;
    for (std::size_t i = 0; i < samples.light.size(); ++i) {
        out.irradiance += kPi / static_cast<float>(samples.light.size()) * samples.light[i];
        nearness += 1 / samples.distance[i];
    }
    out.distance =
        std::clamp(static_cast<float>(samples.light.size()) / nearness, kNearest, kFarthest);
    add_rotation(samples, frame, out);
    add_translation(samples, frame, out);
    limit_by_gradient(out);
    return out;
}

RivalImage render_irradiance_cache(const RenderScene& scene, const RivalSettings& settings)
{
    RivalImage out;
    CachedLight cached(scene, settings);
    const auto trace = [&](const Ray& ray, RandomSequence& random, bool direct) {
        return see_surfaces(scene, ray, random,
                            [&](const Interaction& at, const RayHit&, RandomSequence& more) {
                                const Rgb light = direct ? direct_light(scene, at, more) : Rgb(0);
                                return light + at.bsdf().diffuse / kPi * cached.irradiance(at);
                            });
    };
    const Stopwatch preparing; // from few points to all pixels, so that records lie evenly
    for (int step = kFirstStep; step > 0; step /= 2)
        for (int y = step / 2; y < settings.height; y += step)
            for (int x = step / 2; x < settings.width; x += step) {
                RandomSequence random = pixel_sequence(settings, x, y, settings.samples);
                // Not the middle of the pixel, which may show the very edge between two walls.
                const glm::vec2 at = glm::vec2(x, y) + random.next2();
                trace(ray_through(scene, settings, at), random, false);
            }
    out.prepared.add(preparing);
    const Stopwatch rendering;
    out.image = Image(settings.width, settings.height);
    for (int y = 0; y < settings.height; ++y) // one after the other: rows still add records
        render_row(
            scene, settings, y,
            [&](const Ray& ray, RandomSequence& random) { return trace(ray, random, true); },
            out.image);
    out.rendered.add(rendering);
    out.stored = cached.bytes();
    return out;
}

} // namespace hipmap
