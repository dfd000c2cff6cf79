#pragma once

#include "common/scene/mesh.h"

#include <functional>
#include <limits>
#include <memory>
#include <optional>

namespace hipmap {

/// A half-line in scene units.  direction: unit.
struct Ray {
    glm::vec3 origin{0.0f};
    glm::vec3 direction{0, 0, 1};
    /// The nearest distance that counts; above zero, so that a ray that starts exactly on a face
    /// does not meet that face.
    float near = std::numeric_limits<float>::min();
    float far = std::numeric_limits<float>::infinity();
};

struct RayHit {
    float distance = 0.0f;
    FaceId face = kNone;
    glm::vec2 barycentric{0.0f}; ///< weights of the second and third corner
};

/// Returns the share of light, 0 to 1, that a face stops at a point; the rest passes as if the face
/// were not there.  barycentric: as in RayHit.  Must be thread-safe.
using Opacity = std::function<float(FaceId face, const glm::vec2& barycentric)>;

/// The faces of a mesh with its copies, ready for ray casting (Embree, robust).  Faces of copies
/// are not stored again: a ray is brought to where they are stored.  Read-only once built: any
/// number of threads may cast rays.
class EmbreeScene {
  public:
    /// Copies what ray casting needs of the mesh.  O(n log n).  An empty mesh is never hit.
    /// opacity: empty if every face stops all light; else a face stops that share of all rays,
    /// decided by the bits of the ray and the face, so that one ray always ends at the same place.
    explicit EmbreeScene(const TriangleMesh& mesh, Opacity opacity = {});
    ~EmbreeScene();
    EmbreeScene(EmbreeScene&&) noexcept;
    EmbreeScene& operator=(EmbreeScene&&) noexcept;

    /// Returns the nearest face within [near, far]; of equally near faces the lowest FaceId. A ray
    /// with a number that is not finite (far may be) or a near below zero hits nothing.
    std::optional<RayHit> nearest(const Ray& ray) const;

    /// Returns the nearest face as `nearest` does, but ignores opacity.
    std::optional<RayHit> nearest_face(const Ray& ray) const;

    /// Returns whether any face lies within [near, far].
    bool occluded(const Ray& ray) const;

    /// Returns the point of the faces nearest to `point`, if it lies within the radius; of equally
    /// near points the one of the lowest FaceId.  radius: not negative.  A number that is not
    /// finite finds nothing.
    std::optional<glm::vec3> closest_point(const glm::vec3& point, float radius) const;

    /// Calls `visit` for the faces whose boxes come within the radius of the point, in any order.
    /// A number that is not finite finds nothing.
    void visit_near(const glm::vec3& point, float radius,
                    const std::function<void(FaceId)>& visit) const;

    struct Handles; ///< Embree's

  private:
    std::optional<RayHit> find_nearest(const Ray& ray, bool that_stops) const;

    std::unique_ptr<Handles> handles_;
};

} // namespace hipmap
