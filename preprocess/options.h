#pragma once

#include "common/command_line/frames.h"
#include "common/command_line/scene_arguments.h"
#include "preprocess/partition/connected_edges.h"

#include <filesystem>

namespace hipmap {

inline constexpr Choice<SplitBy> kSplits[] = {
    {"angle", SplitBy::angle}, {"normals", SplitBy::normals}, {"both", SplitBy::both}};

/// What the user asked of `preprocess`.
struct PreprocessArguments {
    std::vector<std::string> command; ///< as typed, of the name of the tool and its arguments
    std::filesystem::path scene;
    std::filesystem::path output;
    std::filesystem::path images;   ///< folder; empty: none
    std::filesystem::path json;     ///< empty: none
    std::filesystem::path coloured; ///< .glb; empty: none
    double angle_deg = 30;
    SplitBy split = SplitBy::angle;
    double weld_metres = 0; ///< 0: identical positions only
    SceneOptions scene_options;
    SkyOptions sky; ///< what it lights is no matter here
    FrameOptions frames;
    PictureSize size{768, 0};
    unsigned threads = 0; ///< 0: all cores
};

/// Every option of `preprocess`, bound to `arguments`, which must outlive the rows.
std::vector<OptionRow> option_rows(PreprocessArguments& arguments);

/// The command line of `preprocess`: the scene, and the options.
void add_arguments(CLI::App& app, PreprocessArguments& arguments);

/// The arguments of one frame: its moment, and files of its own.
PreprocessArguments arguments_of_frame(const PreprocessArguments& all, int frame);

/// Throws InputError unless every file asked for could be written and none of them is the scene or
/// another one.  Changes no file.
void check_outputs(const PreprocessArguments& arguments);

} // namespace hipmap
