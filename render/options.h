#pragma once

#include "common/command_line/frames.h"
#include "common/command_line/scene_arguments.h"
#include "render/effects/effect_plan.h"
#include "render/integrator/run_passes.h"

#include <filesystem>
#include <optional>
#include <vector>

namespace hipmap {

/// What the user asked of `render`.
struct RenderArguments {
    std::vector<std::string> command; ///< as typed, of the name of the tool and its arguments
    std::filesystem::path scene;
    std::filesystem::path partition;
    std::vector<std::filesystem::path> images;
    std::filesystem::path error_image; ///< empty: none
    std::filesystem::path statistics;  ///< empty: none
    std::filesystem::path state;       ///< to go on with and to keep; empty: none
    StopRules stops;
    bool quote = false;   ///< only say what errors cost
    bool explain = false; ///< only say what is rendered and why
    std::vector<EffectSwitch> effects;
    SceneOptions scene_options;
    SkyOptions sky;
    FrameOptions frames;
    double photon_cache_mib = 1024;       ///< for maps that further frames may use
    double shutter = 0;                   ///< frames that the shutter is open; 0: no time
    RenderOptions render;                 ///< its size is still to be completed
    std::optional<DiffuseModel> diffuse;  ///< none: the scene's own
    bool energy_compensation = false;     ///< of all metal
    std::optional<std::uint64_t> photons; ///< of a pass; none: as the size of the picture asks
    PictureSize size{512, 0};
    std::optional<float> exposure_ev; ///< none: auto
    unsigned threads = 0;             ///< 0: all cores
};

/// Adds every option of `render` to `app`, to be read into `arguments`, which must outlive the
/// parsing.
void add_render_arguments(CLI::App& app, RenderArguments& arguments);

/// The arguments of one frame: its moment, and files of its own.
RenderArguments arguments_of_frame(const RenderArguments& all, int frame);

/// What the user asked of `render merge`.
struct MergeArguments {
    std::vector<std::string> command; ///< as typed, of the name of the tool and its arguments
    std::vector<std::filesystem::path> states;
    std::vector<std::filesystem::path> images;
    std::filesystem::path error_image; ///< empty: none
    std::filesystem::path statistics;  ///< empty: none
    std::filesystem::path state;       ///< to write; empty: none
    std::optional<float> exposure_ev;
};

void add_merge_arguments(CLI::App& app, MergeArguments& arguments);

/// What the options mean together; throws InputError if they contradict each other.
void complete_arguments(const CLI::App& app, RenderArguments& arguments);

} // namespace hipmap
