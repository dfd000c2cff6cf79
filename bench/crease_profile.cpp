#include "bench/even_room.h"
#include "common/command_line/command_line.h"
#include "common/file/output_file.h"

#include <cstdio>
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

std::string measure_profile(EvenRoomOptions options)
{
    constexpr std::size_t kPerCrease = kSteps + 1;
    const double radius = filter_radius(6, options.maps.neighbours, options.photons);
    const std::vector<glm::vec2> points = points_near_creases(radius);
    std::vector<std::vector<double>> by_form;
    for (const EstimateForm form : {EstimateForm::clipped, EstimateForm::thesis}) {
        options.maps.estimate = form;
        std::vector<double>& means = by_form.emplace_back();
        for (const std::vector<double>& values : estimates_in_even_room(points, options))
            means.push_back(std::accumulate(values.begin(), values.end(), 0.0) / values.size());
    }
    std::ostringstream csv;
    csv << "distance,edge clipped,edge thesis,corner clipped,corner thesis\n";
    std::printf("distance    edge: clipped  thesis    corner: clipped  thesis\n");
    for (std::size_t i = 0; i < kPerCrease; ++i) {
        const double distance = kFarthest * double(i) / kSteps;
        const std::array<double, 4> row{by_form[0][i], by_form[1][i], by_form[0][i + kPerCrease],
                                        by_form[1][i + kPerCrease]};
        std::printf("%8.3f %16.4f %7.4f %18.4f %7.4f\n", distance, row[0], row[1], row[2], row[3]);
        csv << distance << ',' << row[0] << ',' << row[1] << ',' << row[2] << ',' << row[3] << '\n';
    }
    return csv.str();
}

} // namespace

} // namespace hipmap

int main(int argc, char** argv)
{
    return hipmap::run_tool([&] {
        CLI::App app("Irradiance near an edge and a corner of a room where it is 1 everywhere, by "
                     "both estimates. Distances in radii that hold k photons.",
                     "crease_profile");
        hipmap::EvenRoomOptions options;
        std::string file;
        app.add_option("--neighbours", options.maps.neighbours, "k [50]")
            ->check(CLI::Range(2, 1000));
        app.add_option("--photons", options.photons, "Photons of a set [60000]")
            ->check(CLI::Range(1000, 10'000'000));
        app.add_option("--sets", options.sets, "Independent sets of photons to average [100]")
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
