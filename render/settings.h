#pragma once

#include "common/command_line/option_table.h"
#include "common/partition/partition.h"
#include "render/lights/environment_map.h"
#include "render/options.h"

namespace hipmap {

/// Every option of `render`, bound to `arguments`, which must outlive the rows.  The values at
/// first are the defaults.
std::vector<OptionRow> option_rows(RenderArguments& arguments);

/// Every option of `render merge`, bound to `arguments`.
std::vector<OptionRow> option_rows(MergeArguments& arguments);

/// The command lines of `render` and `render merge`: the files to read, and the options.
void add_arguments(CLI::App& app, RenderArguments& arguments);
void add_arguments(CLI::App& app, MergeArguments& arguments);

/// The value of every option but the names of files, in the order of the table.
std::vector<Setting> values_of(const RenderArguments& arguments);

/// All that the passes of a render depend on but their number: states of the same settings hold
/// passes of one image.  Scene, partition and sky are hashes; options that only change these are
/// left out.  arguments: of a frame, completed.  Cost: linear in the scene.
std::vector<Setting> settings_of(const RenderArguments& arguments, const Scene& scene,
                                 const Partition& partition, const EnvironmentMap& sky);

} // namespace hipmap
