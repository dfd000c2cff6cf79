#include "render/serve.h"

#include "common/command_line/run_tool.h"
#include "common/file/output_file.h"
#include "common/input_error.h"
#include "common/report.h"
#include "render/previous_frame.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <csignal>
#include <iostream>

namespace hipmap {

namespace {

std::vector<std::string> words_of(const std::string& line)
{
    const auto found = nlohmann::json::parse(line, nullptr, false);
    const bool is_list =
        found.is_array() &&
        std::ranges::all_of(found, [](const nlohmann::json& word) { return word.is_string(); });
    if (!is_list)
        throw InputError(
            "standard input: not a command line; write one JSON array of words a line, "
            "such as [\"scene.glb\", \"scene.hpm\", \"-o\", \"image.png\"]");
    return found.get<std::vector<std::string>>();
}

/// The words without the value of --state: frames of an animation have a state each.
std::vector<std::string> without_state(std::vector<std::string> words)
{
    const auto at = std::ranges::find(words, "--state");
    if (at != words.end() && at + 1 != words.end())
        words.erase(at + 1);
    return words;
}

} // namespace

int serve(std::istream& in, std::ostream& out, const ServedRender& render)
{
    std::vector<std::string> last;
    std::optional<PreviousFrame> kept;
    int code = kExitDone;
    for (std::string line; code != kExitStopped && std::getline(in, line);) {
        std::vector<std::string> words = words_of(line);
        if (!kept || without_state(words) != without_state(last))
            kept.emplace();
        last = std::move(words);
        code = run_tool([&] { return render(last, *kept); });
        // Between requests a signal ends the program.
        std::signal(SIGINT, SIG_DFL);
        std::signal(SIGTERM, SIG_DFL);
        out << nlohmann::json{{"event", "done"}, {"code", code}}.dump() + '\n' << std::flush;
        std::cerr << "done\n" << std::flush;
    }
    return code;
}

} // namespace hipmap
