#pragma once

#include "common/scene/scene.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace hipmap {

/// The meaning of the numbers of punctual lights, which Blender's exporter calls Standard, Unitless
/// and Raw: lumen-based as the specification has it, W/sr and W/m2, or watts.
enum class LightUnits { spec, compat, raw };

struct SceneOptions {
    LightUnits light_units = LightUnits::spec;
    std::optional<Rgb> environment;   ///< overrides the sky; none: grey if the scene has no light
    std::vector<std::string> exclude; ///< names of objects left out
    std::string camera;               ///< name; empty: the first
    LookChoice look = LookChoice::automatic;
    std::optional<double> time; ///< of the animation, s; none: as the file places its nodes
    /// Instances of a mesh become copies in TriangleMesh where they would otherwise add so many
    /// faces: fewer take little memory.
    std::uint64_t least_copied_faces = 100'000;
    /// Memory for the pixels of textures.  Where they need more, tiles of them are read from a
    /// temporary file as they are needed.
    double texture_cache_mib = 4096;
};

/// What loading found in a scene file, what it assumed, and what it lost, as sentences.
struct SceneAudit {
    std::vector<std::string> found;
    std::vector<std::string> assumed;
    std::vector<std::string> warnings;
};

struct LoadedScene {
    Scene scene;
    SceneAudit audit;
};

/// A scene file that is read once and returns the scene at any time of its animation.
class SceneSource {
  public:
    /// Reads .glb, .gltf or .obj by suffix and checks it.  Throws InputError: no such file, not a
    /// scene, an index out of range, an unknown required extension.
    SceneSource(const std::filesystem::path& path, const SceneOptions& options);
    ~SceneSource();
    SceneSource(SceneSource&&) noexcept;
    SceneSource& operator=(SceneSource&&) noexcept;

    /// Returns the scene at `time` of its animation, in seconds; none: as the file places it.  The
    /// scene is moved into its SceneFrame, which is the same at all times, and completed with a
    /// camera that frames everything and a uniform grey sky where it has no camera or no light.
    /// The faces and their order are the same at all times, and instances of a file with an
    /// animation are stored one by one.  Throws InputError: a number that is
    /// not finite, no face at all, an unknown camera or excluded name.  last: no other time will be
    /// asked for, which saves memory.  Not for several threads at once.
    LoadedScene at(std::optional<double> time, bool last = false);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// Returns SceneSource(path, options).at(options.time, true).  Cost: linear in the file.
LoadedScene load_scene(const std::filesystem::path& path, const SceneOptions& options);

} // namespace hipmap
