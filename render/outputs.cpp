#include "render/outputs.h"

#include "common/file/output_file.h"
#include "common/image/exposure.h"
#include "common/image/exr_file.h"
#include "common/image/write_image.h"
#include "common/stopwatch.h"
#include "render/film/error_picture.h"

#include <sys/resource.h>

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace hipmap {

namespace {

void write_exr_with_error(const std::filesystem::path& path, const Image& image, const Film& film,
                          const std::vector<ErrorCheck>& checks)
{
    if (checks.empty()) {
        write_exr(path, image, {});
        return;
    }
    const ErrorLayers layers = error_layers(film);
    std::vector<Layer> named = {{"noise", &layers.noise}, {"error", &layers.error}};
    if (!layers.bias.pixels.empty())
        named.push_back({"bias", &layers.bias});
    write_exr(path, image, named);
}

std::string whole(double number)
{
    std::ostringstream text;
    text << std::fixed << std::setprecision(0) << number;
    return text.str();
}

/// Returns the exposure of 8-bit images.
float write_each(const OutputFiles& files, const Image& image, const RenderState& state,
                 Report& report)
{
    const float ev = files.exposure_ev ? *files.exposure_ev : auto_exposure(image);
    for (const std::filesystem::path& path : files.images) {
        if (image_format(path) == ImageFormat::exr)
            write_exr_with_error(path, image, state.film, state.checks);
        else
            write_image(path, image, {ev});
        std::ostringstream line;
        line << "wrote " << path.string();
        if (is_exposed(path))
            line << " (exposure " << std::showpos << std::fixed << std::setprecision(2) << ev
                 << " EV" << (files.exposure_ev ? "" : ", auto") << ")";
        report.line(line.str());
    }
    return ev;
}

std::optional<LegendedPicture> write_error_image(const std::filesystem::path& path,
                                                 const Film& film,
                                                 const std::vector<ErrorCheck>& checks,
                                                 Report& report)
{
    if (checks.empty()) {
        report.warn(path.string() + ": not written; an error image needs two passes or more");
        return std::nullopt;
    }
    const std::vector<double> errors = relative_errors(film);
    const LegendedPicture written =
        write_with_legend(path, error_picture(film.width, film.height, errors), legend_of_errors());
    report.line("wrote " + path.string());
    return written;
}

} // namespace

void check_outputs(const OutputFiles& files)
{
    for (const std::filesystem::path& image : files.images) {
        image_format(image); // refuses an unknown suffix
        check_writable(image);
    }
    for (const std::filesystem::path& file : {files.error_image, files.statistics, files.state})
        if (!file.empty())
            check_writable(file);
}

bool is_exposed(const std::filesystem::path& image)
{
    const ImageFormat format = image_format(image);
    return format == ImageFormat::png || format == ImageFormat::ppm;
}

WrittenFiles write_images(const OutputFiles& files, const Image& image, const RenderState& state,
                          Report& report)
{
    const Stopwatch writing;
    WrittenFiles out;
    out.exposure_ev = write_each(files, image, state, report);
    if (!files.error_image.empty())
        out.error_image = write_error_image(files.error_image, state.film, state.checks, report);
    out.seconds = writing.seconds();
    out.warnings = report.warnings();
    return out;
}

void write_statistics(const OutputFiles& files, const std::string& json, Report& report)
{
    if (files.statistics.empty())
        return;
    write_file(files.statistics, json);
    report.line("wrote " + files.statistics.string());
}

std::string percent(double share)
{
    const double value = 100 * share;
    std::ostringstream text;
    if (value >= 1)
        text << std::fixed << std::setprecision(value < 10 ? 1 : 0);
    else
        text << std::setprecision(2);
    text << value << " %";
    return text.str();
}

std::string brief_time(double seconds)
{
    std::ostringstream text;
    if (seconds < 9.95)
        text << std::setprecision(2) << seconds << " s";
    else if (seconds < 99.5)
        text << std::lround(seconds) << " s";
    else if (seconds < 99.5 * 60)
        text << std::lround(seconds / 60) << " min";
    else
        text << std::fixed << std::setprecision(seconds < 36'000 ? 1 : 0) << seconds / 3600 << " h";
    return text.str();
}

std::string describe_error(const ErrorCheck& check)
{
    const ImageError& error = check.error;
    std::string text = "accuracy: error " + percent(error.error);
    if (std::isfinite(error.high))
        text += " (95 % confidence: " + percent(error.low) + " to " + percent(error.high) + ")";
    if (error.bias == BiasKnowledge::unknown)
        text += " of noise alone; the bias of estimates from the k nearest photons is unknown";
    if (error.bias == BiasKnowledge::from_radii)
        text += "; noise " + percent(std::sqrt(error.noise2)) + ", bias " +
                percent(std::sqrt(std::max(error.bias2, 0.0)));
    return text;
}

std::string describe_cost(const RenderState& state, double target)
{
    const ErrorCheck& last = state.checks.back();
    const ErrorLaw law = error_law(state.checks, state.radius_decay);
    const bool of_target = target > 0 && target / 2 < last.error.error;
    const ErrorCost half =
        error_cost(state.checks, law, (of_target ? target : last.error.error) / 2, 0);
    std::string text = "cost: " + percent(last.error.error) + " in " + std::to_string(last.passes) +
                       " passes, " + brief_time(last.seconds);
    if (!std::isfinite(half.passes) || last.error.error == 0)
        return text;
    return text + "; " + percent(half.error) + " would take about " + whole(half.passes) +
           " passes, " + brief_time(half.seconds);
}

std::vector<ErrorCost> error_costs(const RenderState& state, double target)
{
    const std::vector<ErrorCheck>& checks = state.checks;
    std::vector<ErrorCost> costs;
    if (checks.empty() || !(checks.back().error.error > 0))
        return costs;
    std::vector<double> errors = {0.2, 0.1, 0.05, 0.02, 0.01, 0.005, checks.back().error.error / 2};
    if (target > 0)
        errors.insert(errors.end(), {target, target / 2});
    std::sort(errors.begin(), errors.end(), std::greater<>());
    errors.erase(std::unique(errors.begin(), errors.end()), errors.end());
    const ErrorLaw law = error_law(checks, state.radius_decay);
    for (const double error : errors)
        costs.push_back(error_cost(checks, law, error, state.photons_per_pass));
    return costs;
}

std::uint64_t peak_memory()
{
    constexpr std::uint64_t kUnit = 1024; // Linux counts in KiB
    rusage usage = {};
    if (::getrusage(RUSAGE_SELF, &usage) != 0)
        return 0;
    return static_cast<std::uint64_t>(usage.ru_maxrss) * kUnit;
}

} // namespace hipmap
