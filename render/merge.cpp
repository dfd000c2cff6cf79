#include "render/merge.h"

#include "common/input_error.h"
#include "common/scene/scene_names.h"
#include "render/describe_error.h"
#include "render/outputs.h"
#include "render/statistics.h"

namespace hipmap {

namespace {

/// All passes of the states, at least one, with a look at the error that they have together.
RenderState read_states(const std::vector<std::filesystem::path>& paths)
{
    RenderState state = read_state(paths[0]);
    for (std::size_t i = 1; i < paths.size(); ++i)
        merge_state(state, read_state(paths[i]), paths[i]);
    if (count(state.film.passes) == 0)
        throw InputError(paths[0].string() + ": has no passes yet; render some first");
    look_at_error(state);
    return state;
}

} // namespace

int merge_states(const MergeArguments& arguments)
{
    Report report;
    OutputFiles files = arguments.files;
    complete_files(files);
    check_outputs(files);
    const RenderState state = read_states(arguments.states);
    report.line(counted(count(state.film.passes), "pass", "passes") + " from " +
                counted(arguments.states.size(), "state"));
    std::optional<Fireflies> fireflies;
    if (!state.checks.empty()) {
        report.line(describe_error(state.checks.back()));
        fireflies = find_fireflies(state.film, state.checks.back().error);
        if (fireflies)
            report.line(describe_fireflies(*fireflies));
        report.line(describe_cost(state, 0));
    }
    if (!files.state.empty()) {
        write_state(files.state, state);
        report.wrote(files.state);
    }
    const WrittenFiles written = write_images(files, film_image(state.film), state, report);
    write_statistics(files, merged_statistics_json(arguments, state, fireflies, written), report);
    report.list_files();
    return kExitDone;
}

} // namespace hipmap
