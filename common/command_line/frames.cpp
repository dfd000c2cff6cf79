#include "common/command_line/frames.h"

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
        throw CLI::ValidationError("--frames", "'" + text + "' is no range of frames; write " +
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

} // namespace

void add_frame_arguments(CLI::App& app, FrameOptions& frames)
{
    CLI::Option* const range =
        app.add_option_function<std::string>(
               "--frames", [&frames](const std::string& text) { parse_frames(text, frames); },
               "Frames of the file's animation, first and last or one alone; each has files of its "
               "own, OUT.png as OUT.0001.png and FILE.hpm as FILE.0001.hpm [none: the scene as it "
               "stands in the file]")
            ->type_name("A:B");
    app.add_option("--fps", frames.fps, "Frames a second; frame F is at F / FPS seconds [24]")
        ->check(finite_in(kLeastFps, kMostFps))
        ->needs(range)
        ->type_name("FPS");
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
