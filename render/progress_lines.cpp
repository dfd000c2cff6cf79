#include "render/progress_lines.h"

#include <string>

namespace hipmap {

namespace {

constexpr double kSecondsBetweenLines = 0.1;

nlohmann::json last_error(const RenderState& state)
{
    return state.checks.empty() ? nlohmann::json()
                                : nlohmann::json(state.checks.back().error.error);
}

const char* name_of(StopReason reason)
{
    switch (reason) {
    case StopReason::passes:
        return "passes";
    case StopReason::time:
        return "time";
    case StopReason::error:
        return "error";
    case StopReason::caller:
        return "signal";
    }
    return "";
}

/// All images of a render that has ended.
std::vector<std::filesystem::path> all_images(const OutputFiles& files, const RenderState& state)
{
    std::vector<std::filesystem::path> out = files.images;
    for (const RequestedPicture& picture : known_pictures(files.pictures, state))
        out.push_back(picture.path);
    if (!files.layers.empty())
        out.push_back(files.layers);
    return out;
}

nlohmann::json names_of(const std::vector<std::filesystem::path>& files)
{
    nlohmann::json names = nlohmann::json::array();
    for (const std::filesystem::path& file : files)
        names.push_back(file.string());
    return names;
}

} // namespace

ProgressLines::ProgressLines(std::ostream& to, const RenderArguments& arguments)
    : to_(to), arguments_(arguments)
{
}

void ProgressLines::progress(const RunProgress& progress)
{
    const std::lock_guard lock(mutex_);
    const double now = watch_.seconds();
    if (now - shown_ < kSecondsBetweenLines)
        return;
    shown_ = now;
    print({{"event", "progress"},
           {"passes", progress.passes},
           {"done", progress.done ? nlohmann::json(*progress.done) : nlohmann::json()},
           {"left", progress.left ? nlohmann::json(*progress.left) : nlohmann::json()},
           {"error", progress.error ? nlohmann::json(progress.error->error) : nlohmann::json()}});
}

void ProgressLines::coarse(const std::vector<std::filesystem::path>& written)
{
    const std::lock_guard lock(mutex_);
    print({{"event", "coarse"},
           {"passes", 0},
           {"error", nlohmann::json()},
           {"images", names_of(written)}});
}

void ProgressLines::pass(const RenderState& state,
                         const std::vector<std::filesystem::path>& rewritten)
{
    const std::lock_guard lock(mutex_);
    print({{"event", "pass"},
           {"passes", count(state.film.passes)},
           {"error", last_error(state)},
           {"images", names_of(rewritten)}});
}

void ProgressLines::end(const RunResult& result, const RenderState& state)
{
    const std::lock_guard lock(mutex_);
    print({{"event", "end"},
           {"reason", name_of(result.reason)},
           {"passes", count(state.film.passes)},
           {"error", last_error(state)},
           {"images", names_of(all_images(arguments_.files, state))}});
}

void ProgressLines::print(nlohmann::json line)
{
    line["seconds"] = watch_.seconds();
    if (arguments_.frames.asked())
        line["frame"] = arguments_.frames.first;
    to_ << line.dump() + '\n' << std::flush;
}

} // namespace hipmap
