#include "common/command_line/command_line.h"
#include "common/input_error.h"
#include "common/report.h"
#include "render/merge.h"
#include "render/run_frames.h"
#include "render/serve.h"
#include "render/settings.h"

#include <algorithm>
#include <iostream>

namespace {

const char* const kMemoryAdvice =
    "lower --size or --photons, leave out --layers, use fewer --threads, or export fewer faces";

/// kept: as in render_frames.
int render_main(int argc, char** argv, hipmap::PreviousFrame* kept)
{
    // Before anything is printed, so that one process alone prints it.
    std::optional<hipmap::Ranks> ranks;
    if (kept == nullptr && std::any_of(argv, argv + argc, [](const char* word) {
            return word == std::string_view("--mpi");
        }))
        ranks.emplace();
    hipmap::RenderArguments arguments;
    CLI::App app(
        "Renders a scene with photon maps split along its partition.  `render merge` "
        "combines the states that several runs kept by --state, and `render describe` says "
        "what a state holds; see render merge --help.",
        hipmap::started_as(argv[0]));
    app.set_version_flag("--version", "render " HIPMAP_VERSION);
    hipmap::add_arguments(app, arguments);
    const bool works = ranks && !ranks->leads();
    if (const std::optional<int> code = hipmap::parse_arguments(app, argc, argv))
        return works ? hipmap::kExitDone : *code;
    arguments.command = hipmap::command_of("render", argc, argv);
    if (ranks)
        return hipmap::render_in_ranks(std::move(arguments), *ranks);
    if (arguments.mpi)
        throw hipmap::InputError("--mpi: render serve renders in one process; leave it out");
    hipmap::complete_arguments(arguments);
    return hipmap::render_frames(arguments, kept);
}

/// argv begins with "merge".
int merge_main(int argc, char** argv, const std::string& tool)
{
    hipmap::MergeArguments arguments;
    CLI::App app("Combines the passes of several states of one render and writes their image.",
                 tool + " merge");
    hipmap::add_arguments(app, arguments);
    if (const std::optional<int> code = hipmap::parse_arguments(app, argc, argv))
        return *code;
    arguments.command = hipmap::command_of("render", argc + 1, argv - 1);
    hipmap::limit_threads(0);
    return hipmap::merge_states(arguments);
}

/// argv begins with "describe".
int describe_main(int argc, char** argv, const std::string& tool)
{
    hipmap::DescribeArguments arguments;
    CLI::App app(
        "Prints what states of renders hold: image, pixels, passes and error, a line each.",
        tool + " describe");
    hipmap::add_arguments(app, arguments);
    if (const std::optional<int> code = hipmap::parse_arguments(app, argc, argv))
        return *code;
    hipmap::limit_threads(0);
    return hipmap::describe_states(arguments);
}

/// argv begins with "serve".
int serve_main(int argc, char** argv, std::string tool)
{
    CLI::App app("Renders command lines of render that come on standard input, a JSON array of "
                 "words a line.  Photon maps and images are reused while the words stay the same "
                 "and only the camera of the scene changes; see docs/progress.md.",
                 tool + " serve");
    if (const std::optional<int> code = hipmap::parse_arguments(app, argc, argv))
        return *code;
    return hipmap::serve(std::cin, std::cout,
                         [&](std::vector<std::string> words, hipmap::PreviousFrame& kept) {
                             std::vector<char*> arguments = {tool.data()};
                             for (std::string& word : words)
                                 arguments.push_back(word.data());
                             const auto number = static_cast<int>(arguments.size());
                             arguments.push_back(nullptr);
                             return render_main(number, arguments.data(), &kept);
                         });
}

} // namespace

int main(int argc, char** argv)
{
    const std::string_view first = argc > 1 ? argv[1] : "";
    return hipmap::run_tool(kMemoryAdvice, [&] {
        const std::string tool = hipmap::started_as(argv[0]);
        if (first == "merge")
            return merge_main(argc - 1, argv + 1, tool);
        if (first == "describe")
            return describe_main(argc - 1, argv + 1, tool);
        if (first == "serve")
            return serve_main(argc - 1, argv + 1, tool);
        return render_main(argc, argv, nullptr);
    });
}
