#include "common/command_line/command_line.h"

#include "common/report.h"

#include <cmath>
#include <filesystem>
#include <sstream>

namespace hipmap {

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

} // namespace hipmap
