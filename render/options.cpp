#include "render/options.h"

#include "common/image/image_format.h"
#include "common/input_error.h"
#include "render/settings.h"

namespace hipmap {

namespace {

/// The dissertation's ratio of the fewest photons of a local map to k.
constexpr std::uint32_t kLocalMinPerNeighbour = 10;

bool may_end(const StopRules& stops)
{
    return stops.passes != StopRules().passes || stops.seconds != StopRules().seconds ||
           stops.error > 0;
}

} // namespace

RenderArguments arguments_of_frame(const RenderArguments& all, int frame)
{
    RenderArguments out = all;
    set_frame(out.scene_options, out.frames, frame);
    OutputFiles& files = out.files;
    out.partition = frame_path(out.partition, frame);
    for (std::filesystem::path* file : files.single_files())
        *file = frame_path(*file, frame);
    for (std::filesystem::path& image : files.images)
        image = frame_path(image, frame);
    return out;
}

void complete_files(OutputFiles& files)
{
    files.view = make_view(files.view_choice);
}

void complete_arguments(RenderArguments& arguments)
{
    complete_files(arguments.files);
    for (const std::filesystem::path& image : arguments.files.images)
        image_format(image); // refuses an unknown suffix
    if (arguments.files.images.empty() && arguments.files.layers.empty() &&
        arguments.files.state.empty() && !arguments.quote && !arguments.explain)
        throw InputError("--output is missing; give an image with -o, or use --state, --layers, "
                         "--quote or --explain");
    if (!may_end(arguments.stops))
        arguments.stops.passes = kDefaultPasses;
    if (arguments.quote) {
        arguments.stops.passes = std::min(arguments.stops.passes, kBatches);
        arguments.stops.quoted_error =
            arguments.stops.error > 0 ? arguments.stops.error : kQuotedError;
    }
    std::uint32_t& local_min = arguments.render.dissertation.local_min;
    if (local_min == kLocalMinOpen)
        local_min = kLocalMinPerNeighbour * arguments.render.maps.neighbours;
    RenderArguments defaults;
    check_combinations(option_rows(arguments), option_rows(defaults));
}

} // namespace hipmap
