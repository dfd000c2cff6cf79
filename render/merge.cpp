#include "render/merge.h"

#include "common/file/output_file.h"
#include "common/image/image_format.h"
#include "common/input_error.h"
#include "common/stopwatch.h"
#include "render/outputs.h"
#include "render/statistics.h"

namespace hipmap {

namespace {

void check_outputs(const MergeArguments& arguments)
{
    for (const std::filesystem::path& image : arguments.images) {
        image_format(image); // refuses an unknown suffix
        check_writable(image);
    }
    for (const std::filesystem::path& file :
         {arguments.error_image, arguments.statistics, arguments.state})
        if (!file.empty())
            check_writable(file);
}

/// All passes of the states, at least one, with a look at the error that they have together.
RenderState read_states(const std::vector<std::filesystem::path>& paths)
{
    RenderState state = read_state(paths[0]);
    for (std::size_t i = 1; i < paths.size(); ++i)
        merge_state(state, read_state(paths[i]), paths[i]);
    if (count(state.film.passes) == 0)
        throw InputError(paths[0].string() + ": holds no pass yet; render some first");
    look_at_error(state);
    return state;
}

} // namespace

int merge_states(const MergeArguments& arguments)
{
    Report report;
    WrittenFiles written;
    check_outputs(arguments);
    const RenderState state = read_states(arguments.states);
    report.line(std::to_string(count(state.film.passes)) + " passes of " +
                std::to_string(arguments.states.size()) +
                (arguments.states.size() == 1 ? " state" : " states"));
    if (!state.checks.empty()) {
        report.line(describe_error(state.checks.back()));
        report.line(describe_price(state, 0));
    }

    const Stopwatch writing;
    if (!arguments.state.empty()) {
        write_state(arguments.state, state);
        report.line("wrote " + arguments.state.string());
    }
    written.exposure_ev = write_images(arguments.images, film_image(state.film), state.film,
                                       state.checks, arguments.exposure_ev, report);
    if (!arguments.error_image.empty())
        written.error_image =
            write_error_image(arguments.error_image, state.film, state.checks, report);
    written.seconds = writing.seconds();
    written.warnings = report.warnings();
    if (!arguments.statistics.empty()) {
        write_file(arguments.statistics, merged_statistics_json(arguments, state, written));
        report.line("wrote " + arguments.statistics.string());
    }
    return kExitDone;
}

} // namespace hipmap
