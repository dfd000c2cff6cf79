#pragma once

#include "common/command_line/default_photons.h"
#include "common/command_line/frames.h"
#include "common/command_line/scene_arguments.h"
#include "common/image/view_transform.h"
#include "render/crop.h"
#include "render/dissertation_settings.h"
#include "render/effects/effect_plan.h"
#include "render/integrator/run_passes.h"
#include "render/layers/layer_file.h"
#include "render/picture_table.h"
#include "render/tile.h"

#include <filesystem>
#include <optional>
#include <vector>

namespace hipmap {

/// The number of passes of a render that no other rule ends.
inline constexpr std::uint64_t kDefaultPasses = 16;

/// The error that --quote compares costs at where --error is not given.
inline constexpr double kQuotedError = 0.01;

/// What --quality chooses at once; docs/accuracy.md has the evidence.
enum class Quality : std::uint8_t { standard, draft, good, final };

/// The files that `render` and `render merge` write.
struct OutputFiles {
    std::vector<std::filesystem::path> images;
    /// By row of picture_rows; empty: none.
    std::vector<std::filesystem::path> pictures{picture_rows().size()};
    std::filesystem::path layers;     ///< empty: none; not of `render merge`
    std::filesystem::path statistics; ///< empty: none
    std::filesystem::path state;      ///< to keep, and for `render` to resume; empty: none
    bool replace_state = false;       ///< start over if the state is of another render
    FireflyChoice fireflies = FireflyChoice::remove; ///< of all images
    std::optional<float> exposure_ev;                ///< of 8-bit images; none: auto
    ViewChoice view_choice;                          ///< of 8-bit images
    DisplayView view;                                ///< what it names

    /// Returns the paths of all output files but the images, so that they can be changed.
    std::vector<std::filesystem::path*> single_files()
    {
        std::vector<std::filesystem::path*> out{&layers, &statistics, &state};
        for (std::filesystem::path& picture : pictures)
            out.push_back(&picture);
        return out;
    }
};

/// How a render tells its progress.
enum class ProgressFormat : std::uint8_t { text, json };

/// The options of a `render` run.
struct RenderArguments {
    std::vector<std::string> command; ///< the tool and its arguments as typed
    std::filesystem::path scene;
    std::filesystem::path partition;
    OutputFiles files;
    LayerChoice layers;
    Quality quality = Quality::standard;
    StopRules stops;
    bool quote = false;   ///< only say what errors cost
    bool explain = false; ///< only say what is rendered and why
    std::vector<EffectSwitch> effects;
    SceneOptions scene_options;
    SkyOptions sky;
    FrameOptions frames;
    double photon_cache_mib = 1024; ///< for maps that further frames may use
    double memory_gib = 0;          ///< limit of all memory; 0: none
    double shutter = 0;             ///< frames that the shutter is open; 0: no time
    /// The options of the passes.  The size, the photons and the light classes follow from the
    /// frame.
    RenderOptions render{.maps = {},
                         .dissertation = {.local_min = kLocalMinOpen},
                         .indirect = IndirectLight::automatic,
                         .samples = kDefaultSamples,
                         .light = {}};
    bool energy_compensation = false;     ///< of all metal
    std::optional<std::uint64_t> photons; ///< of a pass; none: as many as it has samples
    PictureSize size{kDefaultWidth, 0};
    std::optional<Crop> crop; ///< none: the whole image
    std::optional<Tile> tile; ///< none: all of that
    PixelRect tiled;          ///< the pixels that have tiles, once the frame is known; empty: none
    unsigned threads = 0;     ///< 0: all cores
    bool mpi = false;         ///< one of several processes started by mpirun
    ProgressFormat progress = ProgressFormat::text;
    bool verbose = false;
};

/// Returns the arguments of one frame: its time and its own file names.
RenderArguments arguments_of_frame(const RenderArguments& all, int frame);

/// The options of a `render merge` run.
struct MergeArguments {
    std::vector<std::string> command; ///< as typed, of the name of the tool and its arguments
    std::vector<std::filesystem::path> states; ///< files and folders
    std::optional<std::uint64_t> passes;       ///< that the image should have; none: as it has
    OutputFiles files;                         ///< at least one image
};

/// The arguments of a `render describe` run.
struct DescribeArguments {
    std::vector<std::filesystem::path> states;
};

/// Makes the view of 8-bit images; throws InputError if there is none of that name.
void complete_files(OutputFiles& files);

/// Fills in options that follow from others; throws InputError if they contradict each other.
void complete_arguments(RenderArguments& arguments);

} // namespace hipmap
