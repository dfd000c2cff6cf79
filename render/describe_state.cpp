#include "render/describe_state.h"

#include "common/report.h"
#include "common/scene/scene_names.h"
#include "render/describe_error.h"

#include <algorithm>

namespace hipmap {

namespace {

std::string text_of(const PixelRect& pixels)
{
    return std::to_string(pixels.width()) + "x" + std::to_string(pixels.height()) + " pixels at " +
           std::to_string(pixels.x0) + "," + std::to_string(pixels.y0);
}

std::string text_of_size(const Film& film)
{
    const ImagePlace& place = film.place;
    const bool whole = place.whole_width == 0;
    return std::to_string(whole ? film.width : place.whole_width) + "x" +
           std::to_string(whole ? film.height : place.whole_height);
}

std::size_t batches_of(const PassSet& passes)
{
    std::size_t out = 0;
    for (std::uint64_t batch = 0; batch < kBatches; ++batch)
        out += count(passes, kBatches, batch) > 0 ? 1 : 0;
    return out;
}

double area_of(const PixelRect& pixels)
{
    return static_cast<double>(pixels.width()) * pixels.height();
}

} // namespace

std::string text_of(const PassSet& passes)
{
    std::string out;
    for (const PassRange& range : passes.ranges) {
        if (!out.empty())
            out += ',';
        out += std::to_string(range.first);
        if (range.end > range.first + 1)
            out.append("-").append(std::to_string(range.end - 1));
    }
    if (out.empty())
        return "none";
    return out;
}

std::string describe_state(const RenderState& state)
{
    const Film& film = state.film;
    std::string out = state.label;
    if (!out.empty())
        out += ": ";
    if (film.place.whole_width > 0)
        out += text_of(pixels_of(film)) + " of ";
    out += text_of_size(film) + ", passes " + text_of(film.passes);
    if (!film.parts.empty())
        out += ", different ones in " + counted(film.parts.size(), "part") + " of the image";
    if (!state.checks.empty())
        out += ", error " + percent(state.checks.back().error.error);
    out += ", " + brief_time(state.seconds);
    for (const Setting& setting : state.settings)
        if (setting.name == "scene")
            out += ", scene " + text_of(setting.value);
    return out;
}

std::vector<FilmPart> missing_from(const RenderState& state, std::optional<std::uint64_t> passes)
{
    const Film& film = state.film;
    const PixelRect own = pixels_of(film);
    FilmPart wanted{image_of(state), {}};
    if (passes)
        wanted.passes.ranges = {{0, *passes}};
    else if (!film.passes.ranges.empty())
        wanted.passes.ranges = {{film.passes.ranges.front().first, film.passes.ranges.back().end}};
    return missing_parts(moved(parts_of(film), own.x0, own.y0), wanted);
}

std::string describe_missing(const FilmPart& missing, const RenderState& state)
{
    const PassRange& first = missing.passes.ranges[0];
    std::string out = "missing: passes " + text_of(missing.passes);
    if (missing.pixels != image_of(state))
        out += " of " + text_of(missing.pixels);
    return out + "; render their tasks, with --first-pass " + std::to_string(first.first) +
           " --passes " + std::to_string(first.end - first.first) + " or others, and merge again";
}

double known_share(const Film& film)
{
    double known = 0;
    for (const FilmPart& part : parts_of(film))
        known += batches_of(part.passes) > 1 ? area_of(part.pixels) : 0;
    return known / static_cast<double>(film.pixel_count());
}

} // namespace hipmap
