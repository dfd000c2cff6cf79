#include "bench/even_room.h"
#include "common/command_line/command_line.h"
#include "common/file/output_file.h"

#include <cmath>
#include <cstdio>
#include <iomanip>
#include <numeric>
#include <sstream>

namespace hipmap {

namespace {

/// The largest distance, and the steps to it, in radii that hold k photons away from all walls.
constexpr double kFarthest = 2.0;
constexpr std::size_t kSteps = 16;

/// Points at growing distances from the wall x = 0, then from that and the wall y = 0 at once.
std::vector<glm::vec2> points_near_creases(double radius)
{
    std::vector<glm::vec2> points;
    for (const bool corner : {false, true})
        for (std::size_t i = 0; i <= kSteps; ++i) {
            const auto d = static_cast<float>(radius * kFarthest * double(i) / kSteps);
            points.emplace_back(d, corner ? d : 0.5f);
        }
    return points;
}

/// What is estimated at the points.
struct Series {
    const char* name;
    MapMode mode;
    EstimateForm form;
    bool dark_floor; ///< light falls on the walls alone, and what the floor shows has leaked
};

constexpr Series kSeries[] = {{"shared clipped", MapMode::shared, EstimateForm::clipped, false},
                              {"shared thesis", MapMode::shared, EstimateForm::thesis, false},
                              {"global thesis", MapMode::global, EstimateForm::thesis, false},
                              {"dark shared", MapMode::shared, EstimateForm::thesis, true},
                              {"dark global", MapMode::global, EstimateForm::thesis, true}};

/// A mean of independent estimates and its standard error.
struct Mean {
    double value, error;
};

Mean mean_of(const std::vector<double>& values)
{
    const double n = static_cast<double>(values.size());
    const double mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
    double squares = 0;
    for (const double value : values)
        squares += (value - mean) * (value - mean);
    return {mean, n > 1 ? std::sqrt(squares / (n - 1) / n) : 0};
}

std::vector<Mean> measure_series(const Series& series, const std::vector<glm::vec2>& points,
                                 EvenRoomOptions options)
{
    options.dissertation.mode = series.mode;
    options.dissertation.estimate = series.form;
    options.dark_floor = series.dark_floor;
    std::vector<Mean> means;
    for (const std::vector<double>& values : estimates_in_even_room(points, options))
        means.push_back(mean_of(values));
    return means;
}

std::string measure_profile(const EvenRoomOptions& options)
{
    const double radius = filter_radius(6, options.maps.neighbours, options.photons);
    const std::vector<glm::vec2> points = points_near_creases(radius);
    std::ostringstream csv, table;
    csv << "crease,distance";
    table << "        distance";
    std::vector<std::vector<Mean>> means;
    for (const Series& series : kSeries) {
        csv << ',' << series.name << ',' << series.name << " error";
        table << std::setw(16) << series.name;
        means.push_back(measure_series(series, points, options));
    }
    table << std::fixed << std::setprecision(4);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double distance = kFarthest * double(i % (kSteps + 1)) / kSteps;
        const char* const crease = i <= kSteps ? "edge" : "corner";
        csv << '\n' << crease << ',' << distance;
        table << '\n' << std::setw(6) << crease << std::setw(10) << distance;
        for (const std::vector<Mean>& mean : means) {
            csv << ',' << mean[i].value << ',' << mean[i].error;
            table << std::setw(16) << mean[i].value;
        }
    }
    csv << '\n';
    std::printf("%s\n", table.str().c_str());
    return csv.str();
}

} // namespace

} // namespace hipmap

int main(int argc, char** argv)
{
    return hipmap::run_tool([&] {
        CLI::App app("Irradiance near an edge and a corner of a room where it is 1 everywhere, by "
                     "both estimates, and of a floor where it is 0 (dark) between walls where it "
                     "is 1. Distances in radii that hold k photons.",
                     "crease_profile");
        hipmap::EvenRoomOptions options;
        std::string file;
        app.add_option("--neighbours", options.maps.neighbours, "k [50]")
            ->check(CLI::Range(2, 1000));
        app.add_option("--photons", options.photons, "Photons of a set [6000]")
            ->check(CLI::Range(1000, 10'000'000));
        app.add_option("--sets", options.sets, "Independent sets of photons to average [10000]")
            ->check(CLI::Range(1, 100'000));
        app.add_option("--csv", file, "Write the table as CSV")->type_name("FILE");
        if (const std::optional<int> code = hipmap::parse_arguments(app, argc, argv))
            return *code;
        if (!file.empty())
            hipmap::check_writable(file);
        const std::string csv = hipmap::measure_profile(options);
        if (!file.empty())
            hipmap::write_file(file, csv);
        return hipmap::kExitDone;
    });
}
