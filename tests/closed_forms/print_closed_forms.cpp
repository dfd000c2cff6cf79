/// Writes docs/closed_forms.md, which compares each integrator with exact answers.

#include "common/command_line/command_line.h"
#include "common/file/output_file.h"
#include "common/report.h"
#include "tests/closed_forms/find_forms.h"

#include <ctime>
#include <iomanip>
#include <sstream>

namespace {

using namespace hipmap;

std::string today()
{
    const std::time_t now = std::time(nullptr);
    char text[16] = "";
    std::strftime(text, sizeof text, "%Y-%m-%d", std::gmtime(&now));
    return text;
}

std::vector<FoundForm> find_all(std::uint64_t passes, Report& report)
{
    std::vector<FoundForm> rows = find_power_from_glass(passes);
    const std::vector<ClosedForm> forms = closed_forms();
    report.begin("closed forms");
    std::vector<FoundForm> out;
    for (std::size_t i = 0; i < forms.size(); ++i)
        for (std::size_t m = 0; m < kMethods.size(); ++m) {
            report.progress(static_cast<double>(i * kMethods.size() + m) /
                                static_cast<double>(forms.size() * kMethods.size()),
                            forms[i].name);
            for (const FoundForm& row : find_form(forms[i], kMethods[m], passes))
                out.push_back(row);
        }
    report.end();
    out.insert(out.end(), rows.begin(), rows.end());
    return out;
}

std::string introduction(std::uint64_t passes, const std::vector<FoundForm>& rows)
{
    std::ostringstream out;
    double sought = 0, squares = 0, largest = 0;
    for (const FoundForm& row : rows)
        if (row.why_not.empty()) {
            ++sought;
            squares += z_score(row) * z_score(row);
            largest = std::max(largest, std::abs(z_score(row)));
        }
    out << std::fixed << std::setprecision(2)
        << "# Closed forms\n\nWritten by `build/release/bin/closed_forms --to "
           "docs/closed_forms.md`; do not edit. Run on "
        << today()
        << ".\n\nThis page compares every integrator with scenes whose answer is known exactly. "
           "Each line names a scene, the exact\nmean radiance of its image (for `photons`: the "
           "exact power that leaves a ball), and the mean of "
        << passes
        << "\nindependent passes of 16x16 pixels. z is the difference between the two in standard "
           "errors, converted from\nStudent's distribution to the normal one. With a correct "
           "estimator, |z| exceeds "
        << kMostZ << " in 7 of a million cases. The\nlargest |z| of the " << std::setprecision(0)
        << sought << " cases here is " << std::setprecision(2) << largest << "; the mean of z² is "
        << squares / sought << ".\n\nThe tests `closed_forms` check the same scenes with "
        << kPassesOfForms << " passes (" << kPassesOfPaths
        << " with `path`).\n\nIntegrator `direct` estimates from the k = " << kNeighbours
        << " nearest photons. Where the photons are stratified, its estimate\nis up to 1/(2k) too "
           "low ([photon_maps.md](photon_maps.md) (2)); z is 0 within that range.\n\n"
           "| symbol | meaning |\n|---|---|\n| ρ | albedo |\n| e | radiance that a wall emits |\n"
           "| L | radiance of a light or sky |\n| I | intensity |\n"
           "| E | irradiance across the light |\n| R | reflectance |\n"
           "| T | transmittance of a slab |\n| a | transmittance of the inside of glass |\n"
           "| F | form factor |\n| Ω | solid angle |\n\n";
    return out.str();
}

std::string table(const std::vector<FoundForm>& rows)
{
    std::ostringstream out;
    out << "| scene | expected | integrator | expected | found | standard error | z |\n"
        << "|---|---|---|---|---|---|---|\n";
    for (const FoundForm& row : rows) {
        out << "| " << row.form << " | " << row.formula << " | " << row.method << " | "
            << std::setprecision(6) << row.expected << " | ";
        if (row.why_not.empty())
            out << row.found.mean() << " | " << std::setprecision(2) << row.found.standard_error()
                << " | " << std::fixed << z_score(row) << std::defaultfloat << " |\n";
        else
            out << row.why_not << " | | |\n";
    }
    return out.str();
}

} // namespace

int main(int argc, char** argv)
{
    return hipmap::run_tool([&] {
        CLI::App app(
            "Renders scenes whose answer is known exactly with every integrator, and prints "
            "the errors in Markdown.",
            "closed_forms");
        std::uint64_t passes = 192;
        std::string file;
        app.add_option("--passes", passes, "Independent passes of each scene [192]")
            ->check(CLI::Range(4, 1'000'000));
        app.add_option("--to", file, "Write to this file instead of standard output")
            ->type_name("FILE");
        if (const std::optional<int> code = hipmap::parse_arguments(app, argc, argv))
            return *code;
        if (!file.empty())
            hipmap::check_writable(file);
        hipmap::Report report;
        const std::vector<hipmap::FoundForm> rows = find_all(passes, report);
        const std::string text = introduction(passes, rows) + table(rows);
        if (file.empty())
            std::printf("%s", text.c_str());
        else
            hipmap::write_file(file, text);
        return hipmap::kExitDone;
    });
}
