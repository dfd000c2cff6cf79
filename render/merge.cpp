#include "render/merge.h"

#include "common/file/output_file.h"
#include "common/image/image_format.h"
#include "common/input_error.h"
#include "render/outputs.h"

namespace hipmap {

int merge_states(const MergeArguments& arguments)
{
    Report report;
    for (const std::filesystem::path& image : arguments.images) {
        image_format(image); // refuses an unknown suffix
        check_writable(image);
    }
    if (!arguments.state.empty())
        check_writable(arguments.state);
    RenderState state = read_state(arguments.states[0]);
    for (std::size_t i = 1; i < arguments.states.size(); ++i)
        merge_state(state, read_state(arguments.states[i]), arguments.states[i]);
    const std::uint64_t passes = count(state.film.passes);
    if (passes == 0)
        throw InputError(arguments.states[0].string() + ": holds no pass yet; render some first");
    report.line(std::to_string(passes) + " passes of " + std::to_string(arguments.states.size()) +
                (arguments.states.size() == 1 ? " state" : " states"));

    if (const std::optional<ImageError> error = estimate_error(state.film)) {
        state.checks = {{passes, state.seconds, *error}};
        report.line(describe_error(state.checks[0]));
    }
    if (!arguments.state.empty()) {
        write_state(arguments.state, state);
        report.line("wrote " + arguments.state.string());
    }
    write_images(arguments.images, film_image(state.film), state.film, state.checks,
                 arguments.exposure_ev, report);
    return kExitDone;
}

} // namespace hipmap
