#pragma once

#include "render/photons/photon.h"
#include "render/photons/seen_surfaces.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace hipmap {

/// Counts of the light paths that reach what the image sees, by class: light x first specular
/// object x kind of photon, docs/error.md (21).  All numbers are integers or extremes, so counts of
/// several threads or passes add up to the same in any order.
struct SeenClasses {
    struct Class {
        std::uint32_t paths = 0; ///< that left a photon of it, at most kMostPaths
        std::uint32_t light = std::numeric_limits<std::uint32_t>::max(); ///< the first of them
        std::uint64_t worth = 0; ///< of their photons, in SeenSurfaces::unit
    };
    struct OfLight {
        std::uint32_t paths = 0; ///< that left a photon of any class, at most kMostPaths
        float caustic = 0; ///< the largest power of a light path that may leave caustic photons,
                           ///<   the sum of its channels
        float global = 0;  ///< the largest power of one that may leave other photons
    };
    static constexpr std::size_t kClasses = 1 << 12;      ///< classes share places by their hash
    static constexpr std::uint32_t kMostPaths = 1u << 30; ///< that are counted

    std::vector<Class> classes;  ///< [kClasses]; empty: no photon was counted
    std::vector<OfLight> lights; ///< as in LightSet::lights, up to the last that sent a path
    std::uint64_t passes = 0;
    std::uint64_t worth = 0; ///< of all photons
};

/// Adds counts to others.
void merge(SeenClasses& into, const SeenClasses& from);

/// Returns the number of light paths that reached what the image sees.
std::uint64_t count_paths(const SeenClasses& classes);

/// Counts light paths of one thread, one after another.  Of a class that many paths have reached it
/// counts only some of the others, as so many more.
class ClassCounter {
  public:
    explicit ClassCounter(const SeenSurfaces& seen);

    /// Begins a path of a light, by its place in LightSet::lights.
    void begin_path(std::size_t light, const Rgb& power);

    /// Counts a photon that the path left, if the image sees it.  first_specular: the face where
    /// the path first left a specular lobe; kNone: none.
    void add(const Photon& photon, FaceId first_specular, bool caustic);

    /// Adds the counts to others.
    void add_to(SeenClasses& into) const;

  private:
    /// Lights whose paths follow one another.
    struct LightRun {
        std::uint32_t light = 0, paths = 0;
        float largest = 0;
    };
    void enter_class(FaceId first_specular, bool caustic);

    const SeenSurfaces& seen_;
    SeenClasses counts_;
    std::vector<LightRun> lights_;
    std::uint32_t path_ = 0;
    bool path_counted_ = false;
    // The class of the last photon of the path.
    bool entered_ = false, caustic_ = false, class_counted_ = false;
    FaceId specular_ = kNone;
    std::size_t place_ = 0;
    std::uint32_t stands_for_ = 0; ///< paths; 0: it is not counted
};

} // namespace hipmap
