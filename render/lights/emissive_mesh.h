#pragma once

#include "common/rays/surface_point.h"
#include "render/lights/light_kind.h"
#include "render/lights/light_tree.h"

#include <functional>
#include <span>
#include <vector>

namespace hipmap {

/// The radiance that the surfaces of a scene emit.
struct SurfaceEmission {
    struct OfMaterial {
        Rgb radiance{0.0f};      ///< W/(m2 sr), factor of textures
        bool both_sides = false; ///< not from the front alone
        bool textured = false;   ///< it differs from point to point
    };
    const TriangleMesh* mesh = nullptr; ///< borrowed
    std::vector<OfMaterial> materials;  ///< [M]

    /// Returns the radiance at a point of a face of a textured material, times the face's opacity
    /// there. barycentric: as in RayHit.  Must be thread-safe.
    std::function<Rgb(FaceId face, const glm::vec2& barycentric)> at;
    /// Returns the radiance of a face of any material, averaged over the face.
    std::function<Rgb(FaceId face)> mean;

    const OfMaterial& of_face(FaceId face) const { return materials[mesh->material_of(face)]; }
};

/// The power that a face emits to all sides, W / metres_per_unit^2, above zero.
struct FacePower {
    FaceId face = kNone;
    glm::dvec3 power{0.0};
};

/// Emissive faces: those of an object, which form one light, or those of all objects, of which
/// direct light samples one.  docs/light_transport.md (5).
struct EmissiveMesh {
    static constexpr LightRole kRole = LightRole::surface;

    const SurfaceEmission* emission = nullptr; ///< borrowed
    std::vector<FaceId> faces;                 ///< ascending
    std::vector<double> cumulative; ///< [faces] running sum of probabilities by power, ends at 1
    std::vector<float> area_pdf;    ///< [last - first face + 1] probability over area, 0: no light
    glm::dvec3 total{0.0};          ///< power, W / metres_per_unit^2
    double brightest = 0.0;         ///< sum of the largest channels of the faces' powers
    LightTree tree;                 ///< over `faces`; empty: receivers select by power
    std::vector<std::uint32_t> place_of_face; ///< [as area_pdf, or 0 without a tree] in `faces`

    bool empty() const { return faces.empty(); }
};

/// Builds the sampler of emissive faces, which selects a face by the largest channel of its power.
/// No faces: an empty mesh.  O(faces).
EmissiveMesh make_emissive_mesh(const SurfaceEmission& emission, std::span<const FacePower> faces);

/// Builds a light tree, by which receivers select faces by importance, if there are more than two
/// faces. O(faces log faces).
void grow_tree(EmissiveMesh& light);

/// A point of an emissive face.
struct EmissivePoint {
    SurfacePoint surface;
    glm::vec2 barycentric{0.0f}; ///< as in RayHit
    float area_pdf = 0.0f;       ///< per square scene unit, over all faces of the mesh
};

/// One of several points that are drawn for a receiver.
struct PointPlace {
    int place = 0;
    int points = 1;
};

/// Draws a point for a receiver.  With a tree, the face is drawn by its importance there; else by
/// power, with the first of the two numbers that also give the point on it, so that stratified
/// samples are stratified over all faces.  So are the points of one receiver.  Nothing: no face can
/// light the receiver.  The mesh must not be empty.
std::optional<EmissivePoint> sample_point(const EmissiveMesh& light, const LightReceiver& at,
                                          RandomSequence& random, const PointPlace& of = {});

/// Returns the radiance that a point emits towards `direction` (unit, away from it).
inline Rgb radiance_towards(const EmissiveMesh& light, const EmissivePoint& point,
                            const glm::vec3& direction)
{
    const SurfaceEmission::OfMaterial& material = light.emission->of_face(point.surface.face);
    if (!material.both_sides && !(glm::dot(direction, point.surface.geometric_normal) > 0))
        return Rgb(0);
    return !material.textured ? material.radiance
                              : light.emission->at(point.surface.face, point.barycentric);
}

/// Converts a pdf per area into one per solid angle, for a point `distance` away along `direction`
/// (unit). 0: the direction lies in the plane of the face.
inline float per_solid_angle(float area_pdf, const SurfacePoint& on_light,
                             const glm::vec3& direction, float distance)
{
    const float cosine = std::abs(glm::dot(direction, on_light.geometric_normal));
    return cosine > 0 ? area_pdf * distance * distance / cosine : 0;
}

/// Returns the pdf per solid angle with which `sample_li` at the receiver draws a point of a face,
/// `distance` away along `direction` (unit, from the receiver).  0: the face is not of the mesh.
float pdf_li(const EmissiveMesh& light, const LightReceiver& at, const SurfacePoint& on_light,
             const glm::vec3& direction, float distance);

/// Draws a point of the mesh and returns the light from it; nothing where the point emits nothing
/// towards the receiver.
std::optional<LightSample> sample_li(const EmissiveMesh& light, const LightReceiver& at,
                                     RandomSequence& random);

/// Returns nothing: rays meet the faces as surfaces of the scene.
inline std::optional<LightHit> intersect(const EmissiveMesh&, const Ray&)
{
    return std::nullopt;
}
inline bool can_be_met(const EmissiveMesh&)
{
    return false;
}

/// Starts a light path; stratifies the paths over the faces by the running sum of their powers.
EmittedPath sample_emission(const EmissiveMesh& light, const PathPlace& path,
                            RandomSequence& random);
EmittedPath sample_aimed_emission(const EmissiveMesh& light, const PathPlace& path,
                                  const std::vector<TargetSphere>& targets, RandomSequence& random);
glm::dvec3 power(const EmissiveMesh& light);
double path_power(const EmissiveMesh& light);
std::optional<LightBounds> bounds(const EmissiveMesh& light);

} // namespace hipmap
