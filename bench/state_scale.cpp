// The memory and the time that writing and reading the state of a large image take, beside its
// film: peaks of the resident set, by stage.
//
//     state_scale [WIDTH HEIGHT]      default: 2048 2048

#include "common/command_line/command_line.h"
#include "common/math/random.h"
#include "common/stopwatch.h"
#include "render/film/render_state.h"

#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <string>

namespace hipmap {

namespace {

/// Bytes, of the line of /proc/self/status that begins so.
double status_bytes(const std::string& name)
{
    std::ifstream in("/proc/self/status");
    for (std::string line; std::getline(in, line);)
        if (line.starts_with(name))
            return 1024 * std::stod(line.substr(name.size()));
    return 0;
}

template <typename Work>
void measure(const char* name, double pixels, const Work& work)
{
    std::ofstream("/proc/self/clear_refs") << "5"; // the peak begins at what is resident now
    const Stopwatch watch;
    work();
    std::printf("  %-22s %7.2f s  %8.2f GiB at most, %6.1f bytes a pixel\n", name, watch.seconds(),
                status_bytes("VmHWM:") / (1 << 30), status_bytes("VmHWM:") / pixels);
}

/// A film of one pass in each batch: values around a mean, as noisy as a pass is.
Film noisy_film(int width, int height)
{
    Film film = make_film(width, height, 1, BiasKnowledge::unbiased);
    film.passes = {{{0, kBatches}}};
    constexpr std::int64_t kMean = 1 << 24;
    std::uint64_t bits = 1;
    for (std::int64_t& sum : film.radiance) {
        bits = mix_bits(bits + 1);
        sum = kMean / 2 + static_cast<std::int64_t>(bits % kMean);
    }
    return film;
}

int state_scale(int width, int height)
{
    const std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("hipmap-state-scale-" + std::to_string(getpid()));
    const double pixels = static_cast<double>(width) * height;
    std::printf("%d x %d pixels, film of %.2f GiB\n", width, height, 192 * pixels / (1 << 30));
    {
        RenderState state;
        measure("making the film", pixels, [&] { state.film = noisy_film(width, height); });
        measure("writing its state", pixels, [&] { write_state(path, state); });
    }
    std::printf("  file: %.2f GiB\n",
                static_cast<double>(std::filesystem::file_size(path)) / (1 << 30));
    measure("reading it", pixels, [&] { read_state(path); });
    std::filesystem::remove(path);
    return kExitDone;
}

} // namespace

} // namespace hipmap

int main(int argc, char** argv)
{
    return hipmap::run_tool([&] {
        std::vector<int> size{2048, 2048};
        CLI::App app("Measures the memory that the state of a large image takes.", "state_scale");
        app.add_option("SIZE", size, "Width and height [2048 2048]")->expected(2);
        if (const std::optional<int> code = hipmap::parse_arguments(app, argc, argv))
            return *code;
        return hipmap::state_scale(size[0], size[1]);
    });
}
