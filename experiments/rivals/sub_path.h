#pragma once

#include "experiments/rivals/spread_lobes.h"
#include "render/lights/light_kind.h"
#include "render/paths/path_ray.h"

#include <optional>

namespace hipmap {

/// Two sums over all techniques that could have made a path, relative to the one at hand, by which
/// the path is weighted; they are kept from vertex to vertex.  Source: Georgiev 2012, "Implementing
/// Vertex Connection and Merging": dVCM and dVC.
struct Weights {
    float here = 0.0f;
    float before = 0.0f;
};

/// A path from the eye or from a light on its way.
struct SubPath : PathRay {
    Rgb carried{1.0f};
    float begun = 1.0f;  ///< largest channel of what it carried at first
    float index2 = 1.0f; ///< as in PathState
    int depth = 0;
    bool from_light = false;
    Weights weights;
};

/// A vertex of a path on a surface.
struct Vertex {
    Interaction at;
    RayHit hit;
    WaysOn ways;
    Rgb carried{0.0f};
    Weights weights;
};

/// Returns a surface as lights are sampled from it.  Rough glass and what transmits diffusely take
/// light from both sides.
LightReceiver receiver(const Interaction& at);

inline float cosine_to(const Interaction& at, const glm::vec3& direction)
{
    return std::abs(glm::dot(direction, at.normal));
}

/// Plays Russian roulette; returns false if it has ended the path.
bool survives(SubPath& path, RandomSequence& random);

/// Brings the path to the next surface; none: there is none.
std::optional<Vertex> reach_vertex(const RenderScene& scene, RandomSequence& random, SubPath& path);

/// Sends the path on by one of the lobes; false: it ends.
bool leave_vertex(const RenderScene& scene, const Vertex& from, RandomSequence& random,
                  SubPath& path);

} // namespace hipmap
