#include "common/command_line/command_line.h"

#include "common/report.h"

#include <cmath>
#include <filesystem>
#include <sstream>

namespace hipmap {

namespace {

int parse_pixels(const std::string& digits, const std::string& text)
{
    int value = 0;
    const bool number = !digits.empty() && digits.size() <= 5 &&
                        digits.find_first_not_of("0123456789") == std::string::npos;
    if (number)
        value = std::stoi(digits);
    if (value < 1 || value > kMostPixelsAcross)
        throw CLI::ValidationError("--size", "'" + text +
                                                 "' is not an image size; write WIDTHxHEIGHT or "
                                                 "WIDTH in pixels, 1 to 65536, or a percentage");
    return value;
}

/// Returns `text` percent of a size; a side of 0 stays.
PictureSize share_of(const PictureSize& whole, const std::string& text)
{
    double percent = 0;
    if (!CLI::detail::lexical_cast(text.substr(0, text.size() - 1), percent))
        percent = 0; // refused below
    const auto share = [&](int side) {
        const double pixels = side * percent / 100;
        if (side == 0 || (pixels > 0 && pixels < 1))
            return std::min(side, 1);
        const bool possible = pixels <= kMostPixelsAcross;
        return parse_pixels(possible ? std::to_string(std::lround(pixels)) : "", text);
    };
    return {share(whole.width), share(whole.height)};
}

} // namespace

std::optional<int> parse_arguments(CLI::App& app, int argc, char** argv)
{
    try {
        app.parse(argc, argv);
        return std::nullopt;
    } catch (const CLI::ParseError& problem) {
        if (problem.get_exit_code() == 0) { // --help, --version
            app.exit(problem);
            return kExitDone;
        }
        print_error(std::string(problem.what()) + "; see " + app.get_name() + " --help");
        return kExitInput;
    }
}

std::string started_as(const char* first_argument)
{
    return std::filesystem::path(first_argument).filename().string();
}

std::vector<std::string> command_of(const std::string& tool, int argc, char** argv)
{
    std::vector<std::string> command(argv, argv + argc);
    command[0] = tool;
    return command;
}

std::string plain_number(double number)
{
    constexpr double kLargest = 1e18; // fits a whole number
    const bool whole = number == std::floor(number) && std::abs(number) < kLargest;
    if (whole)
        return std::string(number < 0 ? "-" : "")
            .append(grouped(static_cast<std::uint64_t>(std::abs(number))));
    std::ostringstream text;
    text << number;
    return text.str();
}

CLI::Validator finite_in(double low, double high)
{
    const auto check = [low, high](std::string& text) -> std::string {
        double value = 0;
        const bool number = CLI::detail::lexical_cast(text, value);
        if (number && std::isfinite(value) && value >= low && value <= high)
            return {};
        std::ostringstream message;
        message << "'" << text << "' is not a number from " << plain_number(low) << " to "
                << plain_number(high);
        return message.str();
    };
    return {check, plain_number(low) + " to " + plain_number(high)};
}

PictureSize parse_picture_size(const std::string& text, const PictureSize& whole)
{
    if (text.ends_with('%'))
        return share_of(whole, text);
    const std::size_t cross = text.find_first_of("xX");
    if (cross == std::string::npos)
        return {parse_pixels(text, text), 0};
    return {parse_pixels(text.substr(0, cross), text), parse_pixels(text.substr(cross + 1), text)};
}

PictureSize complete_size(PictureSize size, float aspect)
{
    if (size.height == 0) {
        const double height = std::round(size.width / (aspect > 0 ? double{aspect} : 1.0));
        size.height = static_cast<int>(std::clamp(height, 1.0, double{kMostPixelsAcross}));
    }
    return size;
}

} // namespace hipmap
