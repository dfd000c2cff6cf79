#include "render/lights/ies_light.h"

#include "render/lights/point_sample.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hipmap {

namespace {

using std::numbers::pi;

/// A place between two angles of a table.
struct Between {
    std::size_t low;
    double part; ///< of the way to the next one, 0 to 1
};

Between place_of(const std::vector<double>& angles, double angle)
{
    const auto above = std::upper_bound(angles.begin() + 1, angles.end() - 1, angle);
    const auto low = static_cast<std::size_t>(above - angles.begin()) - 1;
    return {low, std::clamp((angle - angles[low]) / (angles[low + 1] - angles[low]), 0.0, 1.0)};
}

double mix(double a, double b, double part)
{
    return a + part * (b - a);
}

/// The band between two polar angles, where the web's integral over azimuths goes from one value to
/// another: its integral over directions up to an angle, and the integrand.
struct Band {
    double low, high;           ///< polar angles
    double ring_low, ring_high; ///< integrals over azimuths
    double ring(double at) const { return mix(ring_low, ring_high, (at - low) / (high - low)); }
    double density(double at) const { return ring(at) * std::sin(at); }
    double integral(double at) const
    {
        const double slope = (ring_high - ring_low) / (high - low);
        const double sum = ring_low * (std::cos(low) - std::cos(at)) +
                           slope * (std::sin(at) - std::sin(low) - (at - low) * std::cos(at));
        return std::max(sum, 0.0);
    }
};

Band band_of(const IesLight& light, std::size_t low)
{
    const std::size_t columns = light.web.azimuth.size();
    return {light.web.polar[low], light.web.polar[low + 1], light.rings[(low + 1) * columns - 1],
            light.rings[(low + 2) * columns - 1]};
}

/// Returns the polar angle up to which the band's integral is `target`: Newton's steps, or halves
/// of the bracket where they leave it.
double invert(const Band& band, double target)
{
    constexpr int kSteps = 60;
    constexpr double kClose = 1e-9;
    double low = band.low, high = band.high, at = 0.5 * (low + high);
    for (int i = 0; i < kSteps && high - low > kClose; ++i) {
        const double over = band.integral(at) - target;
        (over > 0 ? high : low) = at;
        const double newton = at - over / band.density(at);
        const double next = newton > low && newton < high ? newton : 0.5 * (low + high);
        if (std::abs(next - at) < kClose)
            return next;
        at = next;
    }
    return at;
}

/// Draws the azimuth at a polar angle.  u: [0, 1).
double sample_azimuth(const IesLight& light, const Between& polar, double u)
{
    const std::vector<double>& azimuth = light.web.azimuth;
    const std::size_t columns = azimuth.size();
    const auto at = [&](const auto& table, std::size_t column) {
        return mix(table[polar.low * columns + column], table[(polar.low + 1) * columns + column],
                   polar.part);
    };
    const double target = u * at(light.rings, columns - 1);
    std::size_t low = 0, high = columns - 1; // the ring up to `low` is at most the target
    while (high - low > 1) {
        const std::size_t middle = (low + high) / 2;
        (at(light.rings, middle) > target ? high : low) = middle;
    }
    const double width = azimuth[high] - azimuth[low];
    const double first = at(light.web.candela, low), last = at(light.web.candela, high);
    const double rest = std::max(0.0, (target - at(light.rings, low)) / width);
    const double root = std::sqrt(std::max(0.0, first * first + 2 * (last - first) * rest));
    const double part = first + root > 0 ? 2 * rest / (first + root) : 0.0;
    return azimuth[low] + width * std::clamp(part, 0.0, 1.0);
}

void make_tables(IesLight& light)
{
    const PhotometricWeb& web = light.web;
    const std::size_t columns = web.azimuth.size();
    std::size_t last_lit = 0;
    for (std::size_t row = 0; row < web.polar.size(); ++row) {
        const double* const candela = web.candela.data() + row * columns;
        double sum = 0;
        light.rings.push_back(sum);
        for (std::size_t i = 1; i < columns; ++i) {
            sum += 0.5 * (candela[i - 1] + candela[i]) * (web.azimuth[i] - web.azimuth[i - 1]);
            light.rings.push_back(sum);
        }
        last_lit = sum > 0 ? row : last_lit;
    }
    light.reach = static_cast<float>(web.polar[std::min(last_lit + 1, web.polar.size() - 1)]);
    light.bands.push_back(0);
    for (std::size_t row = 0; row + 1 < web.polar.size(); ++row) {
        const Band band = band_of(light, row);
        light.bands.push_back(light.bands.back() + band.integral(band.high));
    }
}

} // namespace

IesLight light_from(const SceneIesLight& light, const SceneSphere&)
{
    IesLight out;
    out.position = glm::vec3(light.position);
    out.axis = glm::vec3(light.direction);
    out.start = glm::vec3(light.start);
    out.across = glm::cross(out.axis, out.start);
    out.intensity = Rgb(light.intensity);
    out.web = light.web;
    make_tables(out);
    return out;
}

float candela_along(const IesLight& light, const glm::vec3& direction)
{
    const double x = glm::dot(light.start, direction), y = glm::dot(light.across, direction);
    const double polar = std::atan2(std::hypot(x, y), double{glm::dot(light.axis, direction)});
    const PhotometricWeb& web = light.web;
    if (polar < web.polar.front() || polar > web.polar.back())
        return 0;
    const double azimuth = std::atan2(y, x);
    const Between row = place_of(web.polar, polar);
    const Between column = place_of(web.azimuth, azimuth < 0 ? azimuth + 2 * pi : azimuth);
    const auto in_row = [&](std::size_t at) {
        const double* const candela = web.candela.data() + at * web.azimuth.size() + column.low;
        return mix(candela[0], candela[1], column.part);
    };
    return static_cast<float>(mix(in_row(row.low), in_row(row.low + 1), row.part));
}

glm::vec3 sample_direction(const IesLight& light, RandomSequence& random)
{
    const glm::vec2 u = random.next2();
    const double target = u.x * light.bands.back();
    const auto above = std::upper_bound(light.bands.begin() + 1, light.bands.end() - 1, target);
    const auto row = static_cast<std::size_t>(above - light.bands.begin()) - 1;
    const Band band = band_of(light, row);
    const double polar = invert(band, target - light.bands[row]);
    const double azimuth =
        sample_azimuth(light, {row, (polar - band.low) / (band.high - band.low)}, u.y);
    const auto sine = static_cast<float>(std::sin(polar));
    return static_cast<float>(std::cos(polar)) * light.axis +
           sine * static_cast<float>(std::cos(azimuth)) * light.start +
           sine * static_cast<float>(std::sin(azimuth)) * light.across;
}

std::optional<LightSample> sample_li(const IesLight& light, const LightReceiver& at,
                                     RandomSequence&)
{
    return sample_point(light.position, at, [&](const glm::vec3& direction) {
        return light.intensity * candela_along(light, direction);
    });
}

EmittedPath sample_emission(const IesLight& light, const PathPlace&, RandomSequence& random)
{
    EmittedPath out;
    out.ray.origin = light.position;
    out.ray.direction = sample_direction(light, random);
    out.power = Rgb(power(light));
    return out;
}

EmittedPath sample_aimed_emission(const IesLight& light, const PathPlace&,
                                  const std::vector<TargetSphere>& targets, RandomSequence& random)
{
    const AimedRay aimed =
        aim_from_point(targets, light.position, {light.axis, light.reach}, random);
    EmittedPath out;
    out.ray.origin = light.position;
    out.ray.direction = aimed.direction;
    if (aimed.weight > 0)
        out.power = light.intensity * candela_along(light, aimed.direction) * aimed.weight;
    return out;
}

glm::dvec3 power(const IesLight& light)
{
    return glm::dvec3(light.intensity) * light.bands.back();
}

std::optional<LightBounds> bounds(const IesLight& light)
{
    constexpr float kMargin = 1e-5f; // for the rounding of unit vectors
    const std::vector<double>& candela = light.web.candela;
    LightBounds out;
    out.box.add(light.position);
    out.axis = light.axis;
    // The web may be bright up to its edge, so the edge is not taken for one that fades.
    out.cos_spread = std::max(-1.0f, std::cos(light.reach) - kMargin);
    out.cos_reach = 1 - kMargin;
    out.power = max_channel(light.intensity) * *std::max_element(candela.begin(), candela.end());
    return out;
}

} // namespace hipmap
