#pragma once

#include "common/command_line/option_table.h"
#include "common/partition/partition.h"
#include "render/lights/environment_map.h"
#include "render/options.h"

namespace hipmap {

/// The heading of options that say what an image is like.
inline constexpr const char* kImageSection = "Image";

/// Returns every option of `render`, bound to `arguments`, which must outlive the rows.  Their
/// initial values are the defaults.
std::vector<OptionRow> option_rows(RenderArguments& arguments);

/// Returns every option of `render merge`, bound to `arguments`.
std::vector<OptionRow> option_rows(MergeArguments& arguments);

/// Adds the command lines of `render`, `render merge` and `render describe`: the files to read, and
/// the options.
void add_arguments(CLI::App& app, RenderArguments& arguments);
void add_arguments(CLI::App& app, MergeArguments& arguments);
void add_arguments(CLI::App& app, DescribeArguments& arguments);

/// Returns the value of every option except file names, in the order of the table.
std::vector<Setting> values_of(const RenderArguments& arguments);

/// Returns everything that the passes of a render depend on, except their number: states of the
/// same settings hold passes of one image.  Scene, partition and sky are hashes; options that only
/// change these are left out.  arguments: of a frame, completed.  Cost: linear in the scene.
std::vector<Setting> settings_of(const RenderArguments& arguments, const Scene& scene,
                                 const Partition& partition, const EnvironmentMap& sky);

} // namespace hipmap
