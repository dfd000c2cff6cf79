#include "render/fit_memory.h"

#include "common/report.h"
#include "render/integrator/integrators.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace hipmap {

namespace {

constexpr double kMib = 1 << 20;
constexpr double kGib = 1 << 30;

/// Bytes by measure, docs/memory.md.
constexpr double kProgram = 54 * kMib;
constexpr double kCopy = 3400;     ///< of shared faces, and its node in the file
constexpr double kFace = 240;      ///< mesh, partition, ray tracing structure, borders of maps
constexpr double kPassPixel = 250; ///< tiles and images of a pass, estimates of the error
constexpr double kSkyPixel = 32;
constexpr double kPhoton = 99;          ///< as it is traced, and in its map
constexpr double kComparedPhoton = 150; ///< with the maps of the dissertation
constexpr double kVolumePhoton = 160;
constexpr double kLearntPath = 440; ///< a light path of each round from which guides learn

/// Light paths of the pass that counts photons, and a longer side of its image.
constexpr std::uint64_t kPilotPaths = 1 << 15;
constexpr int kPilotSide = 32;
/// The part of the light paths of a pass in the first round that guides learn from and in the
/// others, and light paths from which on a round has no more of them.
constexpr double kFirstRound = 0.125, kGuidedRound = 0.5;
constexpr double kMostLearning = 1 << 22;
/// No scene leaves more photons of a path but one of nearly white surfaces that light cannot leave.
constexpr double kMostOfPath = 24;
/// An image of fewer is of no use.
constexpr std::uint64_t kFewestPaths = 10'000;

double scene_bytes(const PreparedFrame& frame)
{
    const Scene& scene = frame.loaded.scene;
    double out = kFace * static_cast<double>(scene.mesh.face_count()) +
                 kCopy * static_cast<double>(scene.mesh.copies.size()) +
                 kSkyPixel * static_cast<double>(frame.sky.radiance.pixels.size());
    out += static_cast<double>(bytes_of_textures(scene.images).in_memory);
    for (const Material& material : scene.materials)
        if (material.density)
            out += static_cast<double>(material.density->values.size() * sizeof(float));
    return out;
}

double image_bytes(const RenderArguments& arguments)
{
    const RenderOptions& options = arguments.render;
    const PixelRect pixels = rendered_pixels(options);
    double film = 3 * sizeof(std::int64_t) * kBatches;
    if (options.integrator == Integrator::progressive)
        film += 2 * 3 * sizeof(std::int64_t) * kNarrowBatches;
    if (options.clamp > 0)
        film += 3 * sizeof(std::int64_t) * kNarrowBatches;
    // One of a round of several processes, or of the previous frame.
    const bool second = arguments.mpi || arguments.frames.last > arguments.frames.first;
    const double layers = arguments.files.layers.empty()
                              ? 0
                              : static_cast<double>(chosen_layers(arguments.layers).size());
    const double bytes = film * (second ? 2 : 1) + kPassPixel + 2 * sizeof(glm::vec4) * layers;
    return bytes * pixels.width() * static_cast<double>(pixels.height());
}

double bytes_of_surface_photon(const RenderOptions& options)
{
    const DissertationOptions& asked = options.dissertation;
    const bool plain = asked.mode == MapMode::shared && asked.tree == TreeKind::wide &&
                       asked.irradiance == GatheredIrradiance::estimated;
    return plain ? kPhoton : kComparedPhoton;
}

/// What light paths need, bytes for each.
struct PathBytes {
    double pass = 0;   ///< all of a pass
    double guides = 0; ///< learning where they start, at most
};

/// By a small image of the scene with few light paths.
PathBytes measure_paths(const PreparedFrame& frame)
{
    RenderOptions few = frame.arguments.render;
    few.crop = {};
    few.photons = kPilotPaths;
    few.samples = 1;
    if (few.indirect == IndirectLight::automatic) // that of an image so small may be another
        few.indirect = IndirectLight::photons;
    const double scale = static_cast<double>(kPilotSide) / std::max(few.width, few.height);
    few.width = std::max(1, static_cast<int>(few.width * scale));
    few.height = std::max(1, static_cast<int>(few.height * scale));
    const RenderScene scene(frame.loaded.scene, frame.partition, frame.sky);
    RenderStatistics found;
    make_pass_source(scene, few, found).render(0, {});
    const std::uint64_t on_surfaces =
        found.caustic.stored + found.global.stored + found.indirect.stored;
    PathBytes out;
    out.pass = (bytes_of_surface_photon(few) * static_cast<double>(on_surfaces) +
                kVolumePhoton * static_cast<double>(found.volume_photons)) /
               static_cast<double>(kPilotPaths);
    const bool guided = found.guided_variance < 1 || found.guided_variance_aimed < 1;
    out.guides = (guided ? kGuidedRound : kFirstRound) * (out.pass + kLearntPath);
    return out;
}

/// Returns how many light paths fit into `room` bytes.
double fitting_paths(const PathBytes& path, double room)
{
    const double with_guides = room / std::max(path.pass, path.guides);
    return with_guides < kMostLearning ? with_guides : room / path.pass;
}

std::string gib(double bytes)
{
    std::ostringstream out;
    out.precision(3);
    out << bytes / kGib;
    return out.str();
}

/// Rounds down to two digits, which people can read and repeat.
std::uint64_t rounded_down(double number)
{
    const double unit = std::pow(10.0, std::floor(std::log10(number)) - 1);
    return static_cast<std::uint64_t>(std::floor(number / unit) * unit);
}

/// Lowers the light paths to what fits into `room` bytes; returns what they need.
double fit_photons(PreparedFrame& frame, double room, double others)
{
    RenderArguments& arguments = frame.arguments;
    const auto paths = static_cast<double>(arguments.render.photons);
    const double most =
        (kMostOfPath * bytes_of_surface_photon(arguments.render) + kLearntPath) * paths;
    if (!kind_of(arguments.render.integrator).photons || paths == 0)
        return 0;
    if (most <= room && !frame.effects.has(Effect::media))
        return most;
    const PathBytes path = measure_paths(frame);
    const double bytes = std::max(path.pass, path.guides);
    const double possible = fitting_paths(path, room);
    if (possible >= paths)
        return bytes * paths;
    const std::string memory = "--memory " + gib(arguments.memory_gib * kGib);
    if (possible < static_cast<double>(kFewestPaths))
        throw InputError(memory + ": scene, image and as few as " + grouped(kFewestPaths) +
                         " light paths need " + gib(others + bytes * kFewestPaths) +
                         " GiB; raise it, or use a smaller --size or a --crop");
    const std::uint64_t fitting = rounded_down(possible);
    frame.loaded.audit.assumed.push_back("--photons " + std::to_string(fitting) + " instead of " +
                                         std::to_string(arguments.render.photons) + ", as " +
                                         memory + " allows: " + gib(others) +
                                         " GiB are for scene and image, and a light path takes " +
                                         std::to_string(std::lround(bytes)) + " bytes");
    arguments.render.photons = fitting;
    arguments.photons = fitting;
    return bytes * static_cast<double>(fitting);
}

} // namespace

void fit_memory(PreparedFrame& frame)
{
    RenderArguments& arguments = frame.arguments;
    if (!(arguments.memory_gib > 0))
        return;
    const double limit = arguments.memory_gib * kGib;
    const double others = kProgram + scene_bytes(frame) + image_bytes(arguments);
    if (others > limit)
        throw InputError("--memory " + gib(limit) + ": scene and image alone need " + gib(others) +
                         " GiB; raise it, or use a smaller --size or a --crop");
    const double photons = fit_photons(frame, limit - others, others);
    const double left = std::max(0.0, limit - others - photons);
    arguments.photon_cache_mib = std::min(arguments.photon_cache_mib, left / kMib);
}

} // namespace hipmap
