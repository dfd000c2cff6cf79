#include "common/command_line/frames.h"

#include "common/command_line/run_tool.h"

#include <CLI/CLI.hpp>

#include <cstdio>

namespace hipmap {

namespace {

constexpr int kMostFrame = 999'999;
constexpr double kLeastFps = 1e-3, kMostFps = 1e6;

int parse_frame(const std::string& digits, const std::string& text)
{
    const bool number = !digits.empty() && digits.size() <= 6 &&
                        digits.find_first_not_of("0123456789") == std::string::npos;
    if (!number)
        throw CLI::ValidationError("--frames", "'" + text + "' is not a range of frames; write " +
                                                   "FIRST:LAST or one number, 0 to " +
                                                   std::to_string(kMostFrame));
    return std::stoi(digits);
}

void parse_frames(const std::string& text, FrameOptions& frames)
{
    const std::size_t colon = text.find(':');
    frames.first = parse_frame(text.substr(0, colon), text);
    frames.last =
        colon == std::string::npos ? frames.first : parse_frame(text.substr(colon + 1), text);
    if (frames.last < frames.first)
        throw CLI::ValidationError("--frames", "'" + text + "' ends before it begins");
}

SettingValue value_of(const FrameOptions& frames)
{
    if (!frames.asked())
        return {};
    const std::string first = std::to_string(frames.first);
    return frames.last == frames.first ? first : first + ":" + std::to_string(frames.last);
}

} // namespace

std::vector<OptionRow> frame_rows(FrameOptions& frames)
{
    return {
        {.name = "frames",
         .section = kAnimationSection,
         .field = parsed_field([&frames](const std::string& text) { parse_frames(text, frames); },
                               [&frames] { return value_of(frames); }, "A:B"),
         .help = "Frames of the file's animation, first and last or a single one; each has "
                 "files of its own: OUT.0001.png for OUT.png, FILE.0001.hpm for FILE.hpm",
         .unset = "none: the scene as it stands in the file",
         .changes = Changes::scene},
        {.name = "fps",
         .section = kAnimationSection,
         .field = number_field(frames.fps, {kLeastFps, kMostFps}, "FPS"),
         .help = "Frames a second; frame F is at F / FPS seconds",
         .changes = Changes::scene,
         .needs = "frames"}};
}

std::filesystem::path frame_path(const std::filesystem::path& path, int frame)
{
    if (path.empty())
        return path;
    char number[16];
    std::snprintf(number, sizeof number, ".%04d", frame);
    std::filesystem::path out = path;
    out.replace_extension();
    out += number;
    out += path.extension();
    return out;
}

void set_frame(SceneOptions& options, FrameOptions& frames, int frame)
{
    frames.first = frames.last = frame;
    options.time = frame / frames.fps;
}

int for_each_frame(const FrameOptions& frames, const std::function<int(int frame)>& body)
{
    if (!frames.asked())
        return body(-1);
    for (int frame = frames.first; frame < frames.last; ++frame)
        if (const int code = body(frame); code != kExitDone)
            return code;
    return body(frames.last);
}

} // namespace hipmap
