#include "common/scene/scene_frame.h"

#include "common/freed_memory.h"
#include "common/math/bounds.h"
#include "common/scene/copied_bounds.h"
#include "common/scene/scene_names.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace hipmap {

namespace {

/// Lights and cameras may lie this many units away: squares and their inverses fit into float.
constexpr double kFarthest = 0x1p50;

/// Metres from the origin; the box of what lies within has a size that is a number, too.
constexpr double kLargest = 1e150;

bool is_near(const glm::dvec3& v)
{
    return std::abs(v.x) < kLargest && std::abs(v.y) < kLargest && std::abs(v.z) < kLargest;
}

double longest(const glm::dvec3& v)
{
    return std::max(std::abs(v.x), std::max(std::abs(v.y), std::abs(v.z)));
}

/// The power of two that brings `length` into (1/2, 1].
double unit_for(double length)
{
    if (!(length > 0))
        return 1.0;
    int exponent = 0;
    const double fraction = std::frexp(length, &exponent);
    return std::ldexp(1.0, fraction == 0.5 ? exponent - 1 : exponent);
}

/// The box of all faces; of an animation, that of all its frames.
Bounds<glm::dvec3> box_of_faces(const RawScene& raw)
{
    Bounds<glm::dvec3> box;
    if (!raw.sweep)
        return bounds_with_copies<glm::dvec3>(raw.positions, raw.shared, raw.copies);
    std::vector<bool> added(raw.objects.size(), false);
    for (const ObjectId object : raw.object_of_face) {
        if (added[object])
            continue;
        added[object] = true;
        const Bounds<glm::dvec3>& swept = raw.sweep->objects[object];
        if (!is_near(swept.low) || !is_near(swept.high))
            throw scene_error(raw.path, "object " + quote_name(raw.objects[object].name),
                              "its animation moves it too far away; correct it");
        box.add(swept.low);
        box.add(swept.high);
    }
    return box;
}

/// Finds the longest way from a point to a position of a light, along some axis.
struct FarthestPosition : IgnoreNumbers {
    const glm::dvec3 from;
    double distance = 0.0;

    explicit FarthestPosition(const glm::dvec3& point) : from(point) {}
    void position(const glm::dvec3& v) { distance = std::max(distance, longest(v - from)); }
};

/// Brings the numbers of a light into a frame, and rounds them to float, in which rendering
/// computes.
struct NumbersToFrame : IgnoreNumbers {
    const SceneFrame& frame;
    bool finite = true; ///< all numbers so far

    explicit NumbersToFrame(const SceneFrame& to) : frame(to) {}

    void position(glm::dvec3& v) { set(v, (v - frame.centre) / frame.metres_per_unit); }
    void direction(glm::dvec3& v) { set(v, v); }
    void extent(glm::dvec3& v) { set(v, v / frame.metres_per_unit); }
    void extent(double& size) { set(size, size / frame.metres_per_unit); }
    void angle(double& size) { set(size, size); }
    void radiant_intensity(glm::dvec3& v)
    {
        set(v, v / frame.metres_per_unit / frame.metres_per_unit);
    }
    void irradiance(glm::dvec3& v) { set(v, v); }
    void radiance(glm::dvec3& v) { set(v, v); }

  private:
    void set(glm::dvec3& to, const glm::dvec3& value)
    {
        const glm::vec3 rounded(value);
        finite = finite && is_finite(rounded);
        to = glm::dvec3(rounded);
    }
    void set(double& to, double value)
    {
        const auto rounded = static_cast<float>(value);
        finite = finite && std::isfinite(rounded);
        to = rounded;
    }
};

SceneFrame choose_frame(const RawScene& raw)
{
    const Bounds<glm::dvec3> box = box_of_faces(raw);
    SceneFrame frame;
    frame.centre = box.centre();
    frame.metres_per_unit = unit_for(longest(box.extent()));
    double farthest = 0.0;
    if (raw.sweep && !raw.sweep->others.empty())
        for (const glm::dvec3& corner : {raw.sweep->others.low, raw.sweep->others.high})
            farthest = std::max(farthest, longest(corner - frame.centre));
    FarthestPosition of_lights(frame.centre);
    for (const SceneLight& light : raw.lights)
        each_number(light, of_lights);
    farthest = std::max(farthest, of_lights.distance);
    for (const RawCamera& camera : raw.cameras)
        farthest = std::max(farthest, longest(camera.position - frame.centre));
    if (farthest > kFarthest * frame.metres_per_unit)
        frame.metres_per_unit = unit_for(farthest / kFarthest);
    return frame;
}

/// Converts the elements of one scene and checks what comes out.
class UnitConverter {
  public:
    UnitConverter(const RawScene& raw, const SceneFrame& frame) : raw_(raw), frame_(frame) {}

    glm::vec3 position(const glm::dvec3& world) const
    {
        return glm::vec3((world - frame_.centre) / frame_.metres_per_unit);
    }

    Material material(const Material& metres) const
    {
        Material out = metres;
        out.absorption = Rgb(glm::dvec3(metres.absorption) * frame_.metres_per_unit);
        out.scattering = Rgb(glm::dvec3(metres.scattering) * frame_.metres_per_unit);
        out.medium_emission = Rgb(glm::dvec3(metres.medium_emission) * frame_.metres_per_unit);
        out.thickness = static_cast<float>(metres.thickness / frame_.metres_per_unit);
        demand(is_finite(out.base_color) && is_finite(out.emission) && is_finite(out.absorption) &&
                   is_finite(out.specular_color) && std::isfinite(out.ior) &&
                   is_finite(out.scattering) && is_finite(out.medium_emission) &&
                   std::isfinite(out.thickness) && std::isfinite(out.dispersion) &&
                   std::isfinite(out.anisotropy_rotation) && std::isfinite(out.alpha_cutoff),
               "material", out.name);
        return out;
    }

    SceneLight light(SceneLight metres) const
    {
        NumbersToFrame to_frame(frame_);
        each_number(metres, to_frame);
        demand(to_frame.finite, "light", name_of(metres));
        return metres;
    }

    Rgb world(const glm::dvec3& radiance) const
    {
        demand(is_finite(Rgb(radiance)), "world of", "the scene");
        return Rgb(radiance);
    }

    Medium around(const Medium& metres) const
    {
        Medium out = metres;
        for (Rgb Medium::*per : {&Medium::absorption, &Medium::scattering, &Medium::emission}) {
            out.*per = Rgb(glm::dvec3(metres.*per) * frame_.metres_per_unit);
            demand(is_finite(out.*per), "medium of", "the scene");
        }
        return out;
    }

    Camera camera(const RawCamera& metres) const
    {
        Camera out;
        out.name = metres.name;
        out.projection = metres.projection;
        out.position = position(metres.position);
        out.right = glm::vec3(metres.right);
        out.up = glm::vec3(metres.up);
        out.forward = glm::vec3(metres.forward);
        out.tan_half_height = static_cast<float>(metres.tan_half_height);
        out.half_height = static_cast<float>(metres.half_height / frame_.metres_per_unit);
        out.aspect = static_cast<float>(metres.aspect);
        out.shift = glm::vec2(metres.shift);
        out.near_clip = static_cast<float>(metres.near_clip / frame_.metres_per_unit);
        out.far_clip = static_cast<float>(metres.far_clip / frame_.metres_per_unit);
        out.aperture_radius = static_cast<float>(metres.aperture_radius / frame_.metres_per_unit);
        out.focus_distance = static_cast<float>(metres.focus_distance / frame_.metres_per_unit);
        if (!std::isfinite(out.far_clip))
            out.far_clip = 0.0f; // beyond all that can be seen
        demand(is_finite(out.position) && is_finite(out.right) && is_finite(out.up) &&
                   is_finite(out.forward) && std::isfinite(out.tan_half_height) &&
                   std::isfinite(out.half_height) && std::isfinite(out.near_clip) &&
                   std::isfinite(out.aspect) && std::isfinite(out.aperture_radius) &&
                   std::isfinite(out.focus_distance),
               "camera", out.name);
        return out;
    }

  private:
    void demand(bool good, const char* kind, const std::string& name) const
    {
        if (!good)
            throw scene_error(raw_.path, std::string(kind) + " " + quote_name(name),
                              "a number is not finite or too large; correct it and export again");
    }

    const RawScene& raw_;
    const SceneFrame& frame_;
};

void check_size(const RawScene& raw)
{
    if (raw.corners.empty())
        throw scene_error(raw.path, "", "the scene has no faces; export a scene with a mesh");
    if (raw.all_face_count() >= kNone || raw.positions.size() >= kNone)
        throw scene_error(raw.path, "", "more than 2^32 - 2 faces or vertices; export fewer");
}

bool all_near(const std::vector<glm::dvec3>& positions)
{
    return tbb::parallel_reduce(
        tbb::blocked_range<std::size_t>(0, positions.size()), true,
        [&](const auto& range, bool near) {
            return near && std::all_of(positions.begin() + range.begin(),
                                       positions.begin() + range.end(), is_near);
        },
        std::logical_and());
}

void check_positions(const RawScene& raw)
{
    const bool all_are_near = all_near(raw.positions);
    for (std::size_t face = 0; face < raw.corners.size() && !all_are_near; ++face)
        for (int c = 0; c < 3; ++c)
            if (!is_near(raw.positions[raw.corners[face][c]]))
                throw scene_error(raw.path,
                                  "object " +
                                      quote_name(raw.objects[raw.object_of_face[face]].name) +
                                      ", face " + std::to_string(face),
                                  "a corner is not finite or too far away; correct its transform");
    const auto boxes = boxes_of_shared<glm::dvec3>(raw.positions, raw.shared);
    for (const FaceCopy& copy : raw.copies) {
        const Bounds<glm::dvec3> box = box_around(copy.place, boxes[copy.shared]);
        if (!is_near(box.low) || !is_near(box.high))
            throw scene_error(raw.path, "object " + quote_name(raw.objects[copy.object].name),
                              "is not finite or too far away; correct its transform");
    }
}

/// What `place`, in the world, is in a frame.
Similarity in_frame(const Similarity& place, const SceneFrame& frame)
{
    return {place.turn, place.scale,
            (place.point(frame.centre) - frame.centre) / frame.metres_per_unit};
}

} // namespace

Scene to_scene_units(RawScene& raw)
{
    check_size(raw);
    check_positions(raw);
    Scene scene;
    scene.frame = choose_frame(raw);
    const UnitConverter convert(raw, scene.frame);

    TriangleMesh& mesh = scene.mesh;
    mesh.positions.resize(raw.positions.size());
    tbb::parallel_for(std::size_t{0}, raw.positions.size(), [&](std::size_t i) {
        mesh.positions[i] = convert.position(raw.positions[i]);
    });
    free_array(raw.positions);
    mesh.normals = std::move(raw.normals);
    mesh.attributes = std::move(raw.attributes);
    mesh.corners = std::move(raw.corners);
    mesh.material_of_face = std::move(raw.material_of_face);
    mesh.object_of_face = std::move(raw.object_of_face);
    mesh.shared = std::move(raw.shared);
    mesh.copies = std::move(raw.copies);
    for (FaceCopy& copy : mesh.copies)
        copy.place = in_frame(copy.place, scene.frame);
    mesh.finder = find_copies(static_cast<FaceId>(mesh.face_count()), mesh.shared, mesh.copies);
    for (const RawObject& object : raw.objects)
        mesh.object_names.push_back(object.name);
    for (const Material& material : raw.materials)
        scene.materials.push_back(convert.material(material));
    scene.images = std::move(raw.images);
    for (const SceneLight& light : raw.lights)
        scene.lights.push_back(convert.light(light));
    scene.environment = convert.world(raw.world);
    scene.around = convert.around(raw.around);
    scene.environment_map_file = raw.world_map_file.string();
    scene.environment_strength = static_cast<float>(raw.world_strength);
    scene.environment_turn_deg = static_cast<float>(raw.world_turn_deg);
    scene.look = raw.look;
    for (const RawCamera& camera : raw.cameras)
        scene.cameras.push_back(convert.camera(camera));
    return scene;
}

} // namespace hipmap
