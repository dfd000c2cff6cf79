#pragma once

#include "common/command_line/frames.h"
#include "common/command_line/scene_arguments.h"
#include "preprocess/partition/connected_edges.h"

#include <filesystem>
#include <optional>

namespace hipmap {

inline constexpr Choice<SplitBy> kSplits[] = {
    {"angle", SplitBy::angle}, {"normals", SplitBy::normals}, {"both", SplitBy::both}};

/// The options of a `preprocess` run.
struct PreprocessArguments {
    std::vector<std::string> command; ///< the tool and its arguments as typed
    std::filesystem::path scene;
    std::filesystem::path output;
    std::filesystem::path images;   ///< folder; empty: none
    std::filesystem::path json;     ///< empty: none
    std::filesystem::path coloured; ///< .glb; empty: none
    double angle_deg = 30;
    SplitBy split = SplitBy::angle;
    double weld_metres = 0;               ///< 0: identical positions only
    std::optional<std::uint64_t> photons; ///< light paths of a pass of `render`; none: its default
    std::uint32_t neighbours = 50;        ///< k of `render`
    SceneOptions scene_options;
    SkyOptions sky; ///< read, but not used by preprocess
    FrameOptions frames;
    PictureSize size{768, 0}; ///< of pictures of the partition
    bool candidates = false;  ///< paint images of candidates for local and group maps too
    unsigned threads = 0;     ///< 0: all cores
    bool verbose = false;
    bool quiet = false;
};

/// Returns every option of `preprocess`, bound to `arguments`, which must outlive the rows.
std::vector<OptionRow> option_rows(PreprocessArguments& arguments);

/// Adds the command line of `preprocess`: the scene and the options.
void add_arguments(CLI::App& app, PreprocessArguments& arguments);

/// Returns the arguments of one frame: its time and its own file names.
PreprocessArguments arguments_of_frame(const PreprocessArguments& all, int frame);

/// Throws InputError unless every output file could be written and none of them is the scene or
/// another one.  Changes no file.
void check_outputs(const PreprocessArguments& arguments);

} // namespace hipmap
