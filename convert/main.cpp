#include "common/command_line/command_line.h"
#include "common/file/output_file.h"
#include "common/report.h"
#include "common/scene/density_file.h"
#include "convert/vdb_grid.h"

#include <CLI/CLI.hpp>

#include <map>
#include <sstream>

namespace hipmap {

namespace {

const std::map<std::string, UpAxis> kUps{{"y", UpAxis::y}, {"z", UpAxis::z}};

struct Arguments {
    std::filesystem::path vdb, output;
    std::string grid;
    UpAxis up = UpAxis::z;
};

void add_arguments(CLI::App& app, Arguments& arguments)
{
    app.add_option("VDB", arguments.vdb, "OpenVDB file to read")->required()->type_name("FILE.vdb");
    app.add_option("-o,--output", arguments.output, "Density grid to write")
        ->required()
        ->type_name("FILE.vol");
    app.add_option("--grid", arguments.grid,
                   "Name of the grid of floats [density, or the only one]")
        ->type_name("NAME");
    app.add_option_function<std::string>(
           "--up", [&arguments](const std::string& name) { arguments.up = kUps.at(name); },
           "Axis of the file that points upwards: z (Blender) or y (glTF, Houdini) [z]")
        ->check(CLI::IsMember(kUps))
        ->type_name("AXIS");
}

std::string written(const glm::dvec3& point)
{
    std::ostringstream out;
    out << '(' << point.x << ", " << point.y << ", " << point.z << ')';
    return out.str();
}

int convert(const Arguments& arguments)
{
    Report report;
    check_writable(arguments.output);
    const VdbGrid grid = read_vdb(arguments.vdb, arguments.grid, arguments.up);
    const glm::uvec3 n = grid.density.nodes;
    report.line("grid '" + grid.name + "': " + std::to_string(n.x) + " x " + std::to_string(n.y) +
                " x " + std::to_string(n.z) + " values, y up");
    report.line("box: " + written(grid.low) + " to " + written(grid.high) +
                "; the mesh of the medium should fill this box");
    if (grid.negative > 0)
        report.warn(std::to_string(grid.negative) + " values below 0 were set to 0");
    write_density(arguments.output, grid.density, grid.low, grid.high);
    report.line("wrote " + arguments.output.string());
    return kExitDone;
}

} // namespace

} // namespace hipmap

int main(int argc, char** argv)
{
    return hipmap::run_tool([&] {
        hipmap::Arguments arguments;
        CLI::App app(
            "Converts a grid of an OpenVDB file into a .vol file for the density of a medium.",
            "vdb_to_vol");
        app.set_version_flag("--version", "vdb_to_vol " HIPMAP_VERSION);
        hipmap::add_arguments(app, arguments);
        if (const std::optional<int> code = hipmap::parse_arguments(app, argc, argv))
            return *code;
        return hipmap::convert(arguments);
    });
}
