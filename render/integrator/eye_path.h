#pragma once

#include "common/math/random.h"
#include "render/dissertation/dissertation.h"
#include "render/integrator/gather_radius.h"
#include "render/maps/volume_map.h"
#include "render/paths/path_class.h"
#include "render/shading/interaction.h"

#include <span>

namespace hipmap {

struct Importons;
struct PlacedGuides;

/// The source of direct light.
enum class DirectLight : std::uint8_t {
    shadow_rays, ///< sampled at each hit; the maps hold the other classes
    photons,     ///< from the global map, as the thesis has it
};

/// The maps and lights that one pass gathers from.  Borrows everything.
struct PassMaps {
    const RenderScene& scene;
    const MapSurfaces& surfaces;
    const ChosenMaps& caustic;
    const ChosenMaps& global;
    DirectLight direct = DirectLight::shadow_rays;
    const VolumeMap* volume = nullptr; ///< null: the scene has no media
    const PlacedGuides* sky = nullptr; ///< by which environments are sampled; null: they are not
};

/// Scratch memory of one thread for eye paths.
struct EyeScratch {
    ChosenScratch caustic;
    ChosenScratch global;
    Importons* importons = nullptr; ///< to keep the queries of photons in
};

/// Whether an eye path adds the lights that are seen (straight, over specular surfaces, and as
/// highlights of any order): they may have samples of their own, docs/error.md (16).
enum class SeenLights : std::uint8_t { added, left_out };

/// Returns whether an eye path adds the light that a ray meets behind surfaces of the class, and
/// the light samples for the followed lobes of the surface that such a ray hits.
inline bool adds_met_light(SeenLights seen, EyePathClass behind)
{
    return seen == SeenLights::added || is_gathered(behind);
}

/// Returns the radiance that arrives along an eye ray, W/(m2 sr): emission, and at every diffuse
/// surface seen directly or through mirrors and glass, direct light (if not from photons), the
/// caustic map and the global map.  docs/light_transport.md (12). May not be finite if the scene's
/// numbers overflow; the film drops such samples.  Thread-safe.
Rgb trace_eye_path(const PassMaps& maps, const Ray& ray, SeenLights seen, RandomSequence& random,
                   EyeScratch& scratch);

/// Returns only the radiance that SeenLights::left_out leaves out.  It casts rays to surfaces and
/// nothing more, so it costs a small part of an eye path.  rivals: of the pass.  Thread-safe.
Rgb trace_seen_lights(const RenderScene& scene, const Ray& ray, RandomSequence& random,
                      const GlossyRivals& rivals = {});

/// What long paths that leave the scene within 60 degrees of a sun would find of it if they did so
/// in all these directions alike: means over samples.  A path is long behind six specular surfaces,
/// or behind two surfaces with a followed lobe among them: the paths beside it say little of its
/// direction. docs/error.md (27).
struct LongPaths {
    float mean = 0, variance = 0; ///< of the light of a sample of trace_seen_lights
    float surfaces = 0;           ///< that a sample meets

    LongPaths& operator+=(const LongPaths& more);
    LongPaths& operator/=(float samples);
};

/// Returns the long paths of one eye ray.  Thread-safe.
LongPaths trace_long_paths(const RenderScene& scene, std::span<const FarLight> suns, const Ray& ray,
                           RandomSequence& random);

/// Returns the difference between what two points on emissive faces bring to the gathered lobes of
/// all surfaces that an eye path meets: its variance is twice that of one point a surface.
/// Thread-safe.
Rgb trace_emissive_difference(const RenderScene& scene, const Ray& ray, RandomSequence& random);

} // namespace hipmap
