#include "common/file/output_file.h"
#include "common/image/exposure.h"
#include "common/image/write_image.h"
#include "common/partition/partition_file.h"
#include "common/report.h"
#include "common/scene/print_audit.h"
#include "common/stopwatch.h"
#include "render/maps/hierarchical.h"
#include "render/options.h"
#include "render/shading/describe_reflections.h"
#include "render/statistics.h"

#include <csignal>
#include <iomanip>
#include <sstream>

namespace hipmap {

namespace {

std::atomic<bool> g_stop{false};

extern "C" void ask_to_stop(int)
{
    g_stop = true;
}

void check_outputs(const RenderArguments& arguments)
{
    for (const std::filesystem::path& image : arguments.images)
        check_writable(image);
    if (!arguments.statistics.empty())
        check_writable(arguments.statistics);
}

void choose_diffuse_model(const RenderArguments& arguments, LoadedScene& loaded)
{
    if (arguments.diffuse)
        loaded.scene.diffuse_model = *arguments.diffuse;
    else if (loaded.scene.diffuse_model == DiffuseModel::burley)
        loaded.audit.assumed.push_back(
            "matt surfaces reflect as in the Blender that wrote the file (Burley's diffuse; "
            "--diffuse lambert is glTF's own)");
}

Partition load_partition(const RenderArguments& arguments, const Scene& scene)
{
    Partition partition = read_partition(arguments.partition);
    check_partition_of(partition, scene, arguments.partition);
    return partition;
}

RenderedImage render_with_progress(const RenderScene& scene, const RenderOptions& options,
                                   Report& report)
{
    std::signal(SIGINT, ask_to_stop);
    std::signal(SIGTERM, ask_to_stop);
    RenderControl control;
    control.progress = [&report](double done) { report.progress(done); };
    control.stop = &g_stop;
    report.begin("rendering " + std::to_string(options.width) + "x" +
                 std::to_string(options.height) + ", " + std::to_string(options.passes) +
                 (options.passes == 1 ? " pass" : " passes"));
    RenderedImage out = render_image(scene, options, control);
    report.end();
    return out;
}

float write_images(const RenderArguments& arguments, const Image& image, Report& report)
{
    const float ev = arguments.exposure_ev ? *arguments.exposure_ev : auto_exposure(image);
    for (const std::filesystem::path& path : arguments.images) {
        write_image(path, image, {ev});
        const ImageFormat format = image_format(path);
        const bool exposed = format == ImageFormat::png || format == ImageFormat::ppm;
        std::ostringstream line;
        line << "wrote " << path.string();
        if (exposed)
            line << " (exposure " << std::showpos << std::fixed << std::setprecision(2) << ev
                 << " EV" << (arguments.exposure_ev ? "" : ", auto") << ")";
        report.line(line.str());
    }
    return ev;
}

void print_photons(const RenderStatistics& statistics, Report& report)
{
    std::ostringstream line;
    line << "photons: " << statistics.emitted << " light paths";
    if (statistics.aimed > 0)
        line << " and " << statistics.aimed << " aimed at specular surfaces";
    line << " left " << statistics.global.stored << " global and " << statistics.caustic.stored
         << " caustic photons; last pass: " << statistics.global.shared_maps << " global and "
         << statistics.caustic.shared_maps << " caustic maps with photons";
    if (const std::uint64_t maps = statistics.global.local_maps + statistics.caustic.local_maps)
        line << ", " << maps << " local maps";
    if (const std::uint64_t maps = statistics.global.group_maps + statistics.caustic.group_maps)
        line << ", " << maps << " group maps";
    report.line(line.str());
}

void print_tiers(const RenderStatistics& statistics, Report& report)
{
    for (const auto& [name, kind] :
         {std::pair("global", &statistics.global), std::pair("caustic", &statistics.caustic)})
        if (kind->stored > 0)
            report.line(std::string(name) + " photons: local maps " +
                        describe_plan(kind->local_plan) + "; group maps " +
                        describe_plan(kind->group_plan));
}

void warn_of_dropped(const RenderStatistics& statistics, Report& report)
{
    const std::uint64_t dropped = statistics.dropped_photons + statistics.dropped_samples;
    if (dropped > 0)
        report.warn(std::to_string(dropped) +
                    " photons or samples were not finite and were left out");
}

int render(RenderArguments& arguments)
{
    Report report;
    RunStatistics run;
    check_outputs(arguments);
    const ThreadLimit threads(arguments.threads);

    const Stopwatch reading;
    LoadedScene loaded = load_scene(arguments.scene, arguments.scene_options);
    choose_diffuse_model(arguments, loaded);
    const Scene& scene = loaded.scene;
    const Partition partition = load_partition(arguments, scene);
    print_audit(report, loaded.audit);
    for (const std::string& sentence : describe_reflections(scene))
        report.line(sentence);
    run.seconds_scene = reading.seconds();

    const PictureSize size = complete_size(arguments.size, scene.cameras[scene.camera].aspect);
    arguments.render.width = size.width;
    arguments.render.height = size.height;

    const Stopwatch building;
    const RenderScene render_scene(scene, partition);
    run.seconds_rays = building.seconds();
    const RenderedImage rendered = render_with_progress(render_scene, arguments.render, report);
    if (arguments.render.integrator == Integrator::direct)
        print_photons(rendered.statistics, report);
    if (arguments.render.maps.mode == MapMode::hierarchical &&
        arguments.render.maps.tree == TreeKind::wide &&
        arguments.render.integrator == Integrator::direct)
        print_tiers(rendered.statistics, report);
    warn_of_dropped(rendered.statistics, report);

    const Stopwatch writing;
    run.exposure_ev = write_images(arguments, rendered.image, report);
    run.seconds_write = writing.seconds();
    run.warnings = report.warnings();
    if (!arguments.statistics.empty()) {
        write_file(arguments.statistics,
                   statistics_json(arguments, scene, partition, rendered.statistics, run));
        report.line("wrote " + arguments.statistics.string());
    }
    if (rendered.stopped) {
        report.line("stopped by a signal after " + std::to_string(rendered.statistics.passes) +
                    " passes; the image holds what was done");
        return kExitStopped;
    }
    return kExitDone;
}

} // namespace

} // namespace hipmap

int main(int argc, char** argv)
{
    return hipmap::run_tool([&] {
        hipmap::RenderArguments arguments;
        CLI::App app("Renders a scene with photon maps split along its partition.", "render");
        app.set_version_flag("--version", "render " HIPMAP_VERSION);
        hipmap::add_render_arguments(app, arguments);
        if (const std::optional<int> code = hipmap::parse_arguments(app, argc, argv))
            return *code;
        hipmap::complete_arguments(app, arguments);
        return hipmap::render(arguments);
    });
}
