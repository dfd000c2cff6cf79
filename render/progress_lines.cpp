#include "render/progress_lines.h"

#include "common/image/write_image.h"
#include "render/outputs.h"

#include <string>

namespace hipmap {

namespace {

using nlohmann::json;

constexpr double kSecondsBetweenLines = 0.1;

/// The share of the time that rewriting images may take.
constexpr double kWritingShare = 0.05;

json last_error(const RenderState& state)
{
    return state.checks.empty() ? json() : json(state.checks.back().error.error);
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

/// Rewrites the images that need no exposure.  Returns their names.
json rewrite_linear(const OutputFiles& files, const Film& film)
{
    json names = json::array();
    const Image image = film_image(film);
    for (const std::filesystem::path& path : files.images) {
        if (is_exposed(path))
            continue;
        write_image(path, image, {});
        names.push_back(path.string());
    }
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
           {"done", progress.done ? json(*progress.done) : json()},
           {"error", progress.error ? json(progress.error->error) : json()}});
}

void ProgressLines::pass(const RenderState& state)
{
    const std::lock_guard lock(mutex_);
    json images = json::array();
    const double begun = watch_.seconds();
    if (writing_ <= kWritingShare * (begun - written_)) {
        images = rewrite_linear(arguments_.files, state.film);
        written_ = watch_.seconds();
        writing_ = written_ - begun;
    }
    print({{"event", "pass"},
           {"passes", count(state.film.passes)},
           {"error", last_error(state)},
           {"images", std::move(images)}});
}

void ProgressLines::end(const RunResult& result, const RenderState& state)
{
    const std::lock_guard lock(mutex_);
    json images = json::array();
    for (const std::filesystem::path& path : arguments_.files.images)
        images.push_back(path.string());
    print({{"event", "end"},
           {"reason", name_of(result.reason)},
           {"passes", count(state.film.passes)},
           {"error", last_error(state)},
           {"images", std::move(images)}});
}

void ProgressLines::print(json line)
{
    line["seconds"] = watch_.seconds();
    if (arguments_.frames.asked())
        line["frame"] = arguments_.frames.first;
    to_ << line.dump() + '\n' << std::flush;
}

} // namespace hipmap
