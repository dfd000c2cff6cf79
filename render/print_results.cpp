#include "render/print_results.h"

#include "render/describe_error.h"
#include "render/integrator/integrators.h"

#include <sstream>

namespace hipmap {

namespace {

/// Costs of errors that are not practical have photons beyond any count.
constexpr double kMostPhotonsTold = 1e15;

void print_photons(const RenderStatistics& statistics, Report& report)
{
    std::ostringstream line;
    line << "photons: " << grouped(statistics.emitted) << " light paths";
    if (statistics.aimed > 0)
        line << " and " << grouped(statistics.aimed) << " aimed at specular surfaces";
    line << " stored " << grouped(statistics.global.stored) << " global and "
         << grouped(statistics.caustic.stored) << " caustic photons";
    if (statistics.volume_photons > 0)
        line << ", and " << grouped(statistics.volume_photons) << " in media";
    line << "; last pass: " << statistics.global.shared_maps << " global and "
         << statistics.caustic.shared_maps << " caustic maps with photons";
    if (const std::uint64_t maps =
            statistics.global.levels.local_maps + statistics.caustic.levels.local_maps)
        line << ", " << maps << " local maps";
    if (const std::uint64_t maps =
            statistics.global.levels.group_maps + statistics.caustic.levels.group_maps)
        line << ", " << maps << " group maps";
    report.detail(line.str());
}

void print_guides(const RenderArguments& arguments, const RenderStatistics& statistics,
                  Report& report)
{
    const auto say = [&](const char* paths, double variance) {
        if (variance < 1)
            report.detail(std::string(paths) + ": guided; the variance of their contribution is " +
                          percent(variance) + " of that by power");
    };
    if (statistics.indirect_by == IndirectLight::paths)
        report.detail("indirect light: by paths, as these find light easily here (--indirect-by)");
    else if (arguments.render.indirect == IndirectLight::paths &&
             arguments.render.integrator == Integrator::progressive)
        report.warn("--indirect-by paths has no effect: there is no indirect light, or photons "
                    "bring it, as always with media and with methods of the dissertation");
    say("light paths", statistics.guided_variance);
    say("light paths aimed at specular surfaces", statistics.guided_variance_aimed);
}

void print_levels(const RenderStatistics& statistics, Report& report)
{
    for (const auto& [name, kind] :
         {std::pair("global", &statistics.global), std::pair("caustic", &statistics.caustic)})
        if (kind->levels.local_plan.asking > 0) // planned
            report.detail(std::string(name) + " photons: local maps " +
                          describe_plan(kind->levels.local_plan) + "; group maps " +
                          describe_plan(kind->levels.group_plan));
}

void warn_of_missed(const RenderArguments& arguments, const RenderedFrame& frame, Report& report)
{
    if (kind_of(arguments.render.integrator).bounces && !frame.unreachable.empty())
        report.warn(describe_unreachable(frame.unreachable));
    const RenderStatistics& statistics = frame.statistics;
    if (frame.state.film.saturated > 0)
        report.warn(std::to_string(frame.state.film.saturated) +
                    " pixel values exceeded the range of the film and were clamped");
    const std::uint64_t dropped = statistics.dropped_photons + statistics.dropped_samples;
    if (dropped > 0)
        report.warn(std::to_string(dropped) +
                    " photons or samples were not finite and were dropped");
    std::optional<ImageError> error;
    if (!frame.state.checks.empty())
        error = frame.state.checks.back().error;
    if (is_much(frame.missed.lost, error))
        report.warn(describe_lost(frame.missed.lost));
    if (frame.missed.unseen && is_much(*frame.missed.unseen, error))
        report.warn(describe_unseen(*frame.missed.unseen, frame.unseen));
}

/// Tells what errors cost.
void print_prices(const RenderArguments& arguments, const RenderedFrame& frame, Report& report)
{
    const bool photons = kind_of(arguments.render.integrator).photons;
    bool rare = false;
    for (const ErrorCost& cost :
         error_costs(frame.state, arguments.stops.error, seconds_before_passes(frame))) {
        std::string line = percent(cost.error) + " error " + describe_need(cost);
        if (photons && cost.photons > 0 && cost.photons < kMostPhotonsTold)
            line += ", " + grouped(static_cast<std::uint64_t>(cost.photons)) +
                    (cost.is_range() ? " light paths or more" : " light paths");
        report.line(line);
        rare = rare || cost.is_range();
    }
    if (rare)
        report.line("the larger figures are for passes that find light which few samples find");
}

} // namespace

void print_statistics(const RenderArguments& arguments, const RenderedFrame& frame, Report& report)
{
    const RenderStatistics& statistics = frame.statistics;
    if (kind_of(arguments.render.integrator).photons) {
        if (statistics.emitted + statistics.aimed > 0)
            print_photons(statistics, report);
        print_guides(arguments, statistics, report);
        print_levels(statistics, report);
    }
    warn_of_missed(arguments, frame, report);
}

void print_error(const RenderArguments& arguments, const RenderedFrame& frame, Report& report)
{
    const RenderState& state = frame.state;
    if (state.checks.empty())
        return;
    if (!frame.seen.empty()) {
        report.line(
            "accuracy: the image is black, so its error is not known: the camera looks at " +
            frame.seen + ", and no light was found there");
        return;
    }
    ErrorCheck last = state.checks.back();
    last.error = with_lost_light(last.error, frame.missed.lost);
    report.line(describe_error(last));
    if (const std::string line = describe_fireflies(frame.fireflies); !line.empty())
        report.line(line);
    report.line(describe_cost(state, arguments.stops.error, seconds_before_passes(frame)));
    if (!arguments.quote)
        return;
    print_prices(arguments, frame, report);
    if (frame.quote)
        for (const std::string& line : describe(*frame.quote))
            report.line(line);
    report.line("memory: " + std::to_string(peak_memory() >> 20) + " MiB, whatever the error");
}

} // namespace hipmap
