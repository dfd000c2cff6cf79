#include "render/merge.h"

#include "common/command_line/run_tool.h"
#include "common/input_error.h"
#include "common/scene/scene_names.h"
#include "render/describe_error.h"
#include "render/describe_state.h"
#include "render/hide_fireflies.h"
#include "render/merge_files.h"
#include "render/outputs.h"
#include "render/statistics.h"

#include <iostream>

namespace hipmap {

namespace {

/// Lines on what is missing before the rest is only counted.
constexpr std::size_t kMostLines = 8;

void print_missing(const RenderState& state, const std::vector<FilmPart>& missing, Report& report)
{
    for (std::size_t i = 0; i < std::min(missing.size(), kMostLines); ++i)
        report.warn(describe_missing(missing[i], state));
    if (missing.size() > kMostLines)
        report.warn("missing: " + counted(missing.size() - kMostLines, "more part") +
                    " of the image; --stats lists all");
}

void print_merged(const RenderState& state, const ShownFireflies& fireflies, Report& report)
{
    if (state.checks.empty())
        return;
    const double known = known_share(state.film);
    report.line(describe_error(state.checks.back()) +
                (known < 1
                     ? "; of the " + percent(known) + " of the pixels that hold two passes or more"
                     : ""));
    if (const std::string line = describe_fireflies(fireflies); !line.empty())
        report.line(line);
    if (state.film.parts.empty())
        report.line(describe_cost(state, 0, 0));
}

} // namespace

int merge_states(const MergeArguments& arguments)
{
    Report report;
    OutputFiles files = arguments.files;
    complete_files(files);
    check_outputs(files);
    MergedFiles merged = merge_files(arguments.states, files.fireflies);
    RenderState& state = merged.state;
    report.line(counted(count(state.film.passes), "pass", "passes") + " from " +
                counted(merged.files.size(), "state"));
    for (const std::string& problem : merged.left_out)
        report.warn(problem + "; left out");
    const std::vector<FilmPart> missing = missing_from(state, arguments.passes);
    print_missing(state, missing, report);
    if (!files.state.empty())
        write_state(files.state, state);
    const ShownFireflies fireflies = hide_fireflies(files.fireflies, state);
    print_merged(state, fireflies, report);
    if (!files.state.empty())
        report.wrote(files.state);
    const WrittenFiles written = write_images(files, film_image(state.film), state, report);
    write_statistics(files, merged_statistics_json(arguments, merged, missing, fireflies, written),
                     report);
    report.list_files();
    return kExitDone;
}

int describe_states(const DescribeArguments& arguments)
{
    for (const std::filesystem::path& path : arguments.states)
        std::cout << path.string() + ": " + describe_state(read_state(path)) + "\n" << std::flush;
    return kExitDone;
}

} // namespace hipmap
