#pragma once

#include "common/command_line/run_tool.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <vector>

namespace hipmap {

/// Parses the arguments of main.  Returns the exit code if the program is to end now: after --help
/// or
/// --version, or after one line on standard error that says what is wrong with the arguments.
std::optional<int> parse_arguments(CLI::App& app, int argc, char** argv);

/// Returns the name by which a program was started, without its folder: "render" in the build
/// folder, "hipmap-render" where it is installed.
std::string started_as(const char* first_argument);

/// Returns the command as it was typed, with the tool's bare name first, whatever folder the tool
/// lies in.
std::vector<std::string> command_of(const std::string& tool, int argc, char** argv);

/// Formats a number without an exponent where it is whole: "4,000,000,000", "0.001".
std::string plain_number(double number);

/// Accepts a finite number within [low, high].  CLI11's own range check lets NaN through.
CLI::Validator finite_in(double low, double high);

} // namespace hipmap
