#include "experiments/rivals/radiosity.h"

#include "common/math/frame.h"
#include "experiments/rivals/face_cells.h"
#include "experiments/rivals/pixels.h"
#include "experiments/rivals/seen_surface.h"
#include "render/paths/direct_light.h"

#include <queue>

namespace hipmap {

namespace {

constexpr int kLightSamples = 4;     // of each light that is no face, for each side of a cell
constexpr double kLeftShare = 0.001; // of the power emitted that may stay unshot

/// The radiosity solution by side of a cell: 2 cell + side.
struct Solution {
    const RenderScene& scene;
    const FaceCells& cells;
    std::vector<Rgb> irradiance;  ///< W/m2 / metres_per_unit^2
    std::vector<Rgb> unshot;      ///< power
    std::vector<Rgb> reflectance; ///< [cells]
    std::vector<float> area;      ///< [cells]
};

glm::vec2 point_in(const std::array<glm::vec2, 3>& corners, const glm::vec2& u)
{
    const glm::vec2 at = sample_triangle(u);
    return corners[0] + at.x * (corners[1] - corners[0]) + at.y * (corners[2] - corners[0]);
}

/// Returns the diffuse reflectance of a face at a point.
Rgb reflectance_at(const RenderScene& scene, FaceId face, const glm::vec2& barycentric)
{
    const SurfacePoint point = surface_point(scene.mesh(), face, barycentric);
    Ray ray;
    ray.direction = -point.geometric_normal;
    return interact(scene, ray, {0, face, barycentric}).bsdf().diffuse;
}

/// Returns the irradiance at a point from the lights that are no faces.
Rgb light_at(const RenderScene& scene, const SurfacePoint& point, const glm::vec3& normal,
             RandomSequence& random)
{
    Rgb sum(0.0f);
    for (const Light& light : scene.lights.lights) {
        if (role(light) != LightRole::analytic)
            continue;
        const auto sample = sample_li(light, LightReceiver{point.position, normal}, random);
        if (!sample)
            continue;
        const float cosine = glm::dot(normal, sample->direction);
        if (cosine > 0 && !scene.rays.occluded(shadow_ray(point, *sample)))
            sum += cosine * sample->light;
    }
    return sum;
}

/// Gives a side of a cell its own emission and the light of lights that are no faces.
void begin_side(Solution& out, std::uint32_t cell, bool front, RandomSequence& random)
{
    const FaceId face = out.cells.face_of_cell[cell];
    const std::array<glm::vec2, 3> corners = corners_of(out.cells, cell);
    const glm::vec2 middle = (corners[0] + corners[1] + corners[2]) / 3.0f;
    const std::size_t side = 2 * std::size_t{cell} + side_of(out.scene, face, front);
    const Bsdf& bsdf = out.scene.bsdfs[out.scene.mesh().material_of(face)];
    Rgb emitted(0.0f);
    if (front || bsdf.emits_behind)
        emitted = kPi * emission_at(out.scene, face, middle);
    for (int s = 0; s < kLightSamples; ++s) {
        const SurfacePoint point =
            surface_point(out.scene.mesh(), face, point_in(corners, random.next2()));
        const glm::vec3 normal = front ? point.geometric_normal : -point.geometric_normal;
        out.irradiance[side] +=
            light_at(out.scene, point, normal, random) / static_cast<float>(kLightSamples);
    }
    out.unshot[side] = out.area[cell] * (emitted + out.reflectance[cell] * out.irradiance[side]);
}

Solution begin_solution(const RenderScene& scene, const FaceCells& cells, std::uint64_t seed)
{
    const std::size_t count = cells.count();
    Solution out{scene,
                 cells,
                 std::vector<Rgb>(2 * count),
                 std::vector<Rgb>(2 * count),
                 std::vector<Rgb>(count),
                 std::vector<float>(count)};
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
        const auto cell = static_cast<std::uint32_t>(i);
        const FaceId face = cells.face_of_cell[cell];
        const std::array<glm::vec2, 3> corners = corners_of(cells, cell);
        const auto n = static_cast<double>(cells.across[face]);
        out.area[cell] = static_cast<float>(face_area(scene.mesh(), face) / (n * n));
        if (!(out.area[cell] > 0))
            return;
        out.reflectance[cell] =
            reflectance_at(scene, face, (corners[0] + corners[1] + corners[2]) / 3.0f);
        RandomSequence random(seed, RandomStream::photons, 0, cell);
        begin_side(out, cell, true, random);
        begin_side(out, cell, false, random);
    });
    return out;
}

/// Draws a ray from a side of a cell, by the cosine.
Ray ray_from(const Solution& solution, std::size_t side, RandomSequence& random)
{
    const auto cell = static_cast<std::uint32_t>(side / 2);
    const FaceId face = solution.cells.face_of_cell[cell];
    const SurfacePoint from = surface_point(
        solution.scene.mesh(), face, point_in(corners_of(solution.cells, cell), random.next2()));
    const bool front = side_of(solution.scene, face, true) == side % 2;
    const glm::vec3 normal = front ? from.geometric_normal : -from.geometric_normal;
    Ray out;
    out.direction = Frame(normal).to_world(sample_cosine_hemisphere(random.next2()));
    out.origin = offset_origin(from, normal);
    return out;
}

/// Returns the side of a cell that a ray meets; none: there is nothing, or it has no area.
std::optional<std::size_t> side_along(const Solution& solution, const Ray& ray)
{
    const RenderScene& scene = solution.scene;
    const std::optional<RayHit> hit = scene.rays.nearest(ray);
    if (!hit)
        return std::nullopt;
    const std::uint32_t cell = cell_at(solution.cells, hit->face, hit->barycentric);
    const glm::vec3 normal(scaled_normal(scene.mesh(), hit->face));
    if (!(solution.area[cell] > 0))
        return std::nullopt;
    return 2 * std::size_t{cell} + side_of(scene, hit->face, glm::dot(ray.direction, normal) < 0);
}

/// What powers are compared by; unlike the largest channel, it adds up.
float sum_of(const Rgb& power)
{
    return power.x + power.y + power.z;
}

/// The sides of cells by unshot power.  A side is queued again when its power has doubled.
class ShootingQueue {
  public:
    explicit ShootingQueue(const Solution& solution)
        : unshot_(solution.unshot), key_(unshot_.size(), 0.0f)
    {
        for (std::size_t side = 0; side < unshot_.size(); ++side) {
            update(side);
            emitted_ += sum_of(unshot_[side]);
        }
        left_ = emitted_;
    }

    /// Returns the side that has about the most; none: almost nothing is left.
    std::optional<std::size_t> next()
    {
        while (!queue_.empty() && left_ > kLeftShare * emitted_) {
            const auto [key, side] = queue_.top();
            queue_.pop();
            if (key != key_[side])
                continue; // it has another place
            key_[side] = 0;
            return side;
        }
        return std::nullopt;
    }

    void update(std::size_t side)
    {
        const float now = sum_of(unshot_[side]);
        if (now > 2 * key_[side])
            queue_.emplace(key_[side] = now, side);
    }
    void change_left(double by) { left_ += by; }
    double emitted() const { return emitted_; }

  private:
    const std::vector<Rgb>& unshot_;
    std::vector<float> key_;
    std::priority_queue<std::pair<float, std::size_t>> queue_;
    double emitted_ = 0, left_ = 0;
};

/// Shoots the power of a side by so many rays.
void shoot(Solution& solution, std::size_t side, std::uint64_t rays, RandomSequence& random,
           ShootingQueue& queue)
{
    const Rgb power = solution.unshot[side] / static_cast<float>(rays);
    queue.change_left(-sum_of(solution.unshot[side]));
    solution.unshot[side] = Rgb(0);
    for (std::uint64_t i = 0; i < rays; ++i) {
        const std::optional<std::size_t> lit =
            side_along(solution, ray_from(solution, side, random));
        if (!lit)
            continue;
        const Rgb reflected = power * solution.reflectance[*lit / 2];
        solution.irradiance[*lit] += power / solution.area[*lit / 2];
        solution.unshot[*lit] += reflected;
        queue.change_left(sum_of(reflected));
        queue.update(*lit);
    }
}

/// Shoots until almost no power is left.
void refine(Solution& solution, const RivalSettings& settings)
{
    ShootingQueue queue(solution);
    std::uint64_t step = 0;
    while (const std::optional<std::size_t> side = queue.next()) {
        const double share = sum_of(solution.unshot[*side]) / queue.emitted();
        const auto rays =
            static_cast<std::uint64_t>(std::ceil(share * static_cast<double>(settings.rays)));
        RandomSequence random(settings.seed, RandomStream::photons, 1, step++);
        shoot(solution, *side, rays, random, queue);
    }
}

} // namespace

RivalImage render_radiosity(const RenderScene& scene, const RivalSettings& settings)
{
    RivalImage out;
    const Stopwatch preparing;
    const FaceCells cells = divide_faces(scene.mesh(), settings.cells);
    Solution solution = begin_solution(scene, cells, settings.seed);
    refine(solution, settings);
    const std::vector<Rgb> irradiance = values_of_corners(cells, solution.irradiance);
    out.prepared.add(preparing);
    out.stored = irradiance.size() * sizeof(Rgb);
    const Stopwatch rendering;
    out.image = render_pixels(scene, settings, [&](const Ray& ray, RandomSequence& random) {
        return see_surfaces(
            scene, ray, random, [&](const Interaction& at, const RayHit& hit, RandomSequence&) {
                return at.bsdf().diffuse / kPi * smooth_value(cells, irradiance, hit, at.side);
            });
    });
    out.rendered.add(rendering);
    return out;
}

} // namespace hipmap
