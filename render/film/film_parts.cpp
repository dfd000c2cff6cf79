#include "render/film/film_parts.h"

#include <algorithm>

namespace hipmap {

namespace {

/// Part of a row of pixels that hold the same passes.
struct Run {
    int x0 = 0, x1 = 0;
    PassSet passes;
    bool operator==(const Run&) const = default;
};

/// The edges of all rectangles along one axis, in order.
std::vector<int> edges_of(const std::vector<FilmPart>& parts, int PixelRect::*low,
                          int PixelRect::*high)
{
    std::vector<int> out;
    for (const FilmPart& part : parts) {
        out.push_back(part.pixels.*low);
        out.push_back(part.pixels.*high);
    }
    std::ranges::sort(out);
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
}

/// The longest runs of a row of pixels.  parts: those that reach into the row.
std::vector<Run> runs_of(const std::vector<FilmPart>& parts)
{
    const std::vector<int> edges = edges_of(parts, &PixelRect::x0, &PixelRect::x1);
    std::vector<PassSet> held(edges.size());
    for (const FilmPart& part : parts)
        for (auto at = std::ranges::lower_bound(edges, part.pixels.x0); *at < part.pixels.x1;
             ++at) {
            PassSet& passes = held[static_cast<std::size_t>(at - edges.begin())];
            passes = united(passes, part.passes);
        }
    std::vector<Run> out;
    for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
        if (held[i].ranges.empty())
            continue;
        if (!out.empty() && out.back().x1 == edges[i] && out.back().passes == held[i])
            out.back().x1 = edges[i + 1];
        else
            out.push_back({edges[i], edges[i + 1], std::move(held[i])});
    }
    return out;
}

bool above(const FilmPart& a, const FilmPart& b)
{
    return a.pixels.y0 != b.pixels.y0 ? a.pixels.y0 < b.pixels.y0 : a.pixels.x0 < b.pixels.x0;
}

/// Adds the runs of rows y0 to y1 to parts, of which `open` end at y0.
void add_rows(int y0, int y1, const std::vector<Run>& runs, std::vector<FilmPart>& open,
              std::vector<FilmPart>& done)
{
    std::vector<FilmPart> next;
    for (const Run& run : runs) {
        const auto same = std::ranges::find_if(open, [&](const FilmPart& part) {
            return part.pixels.x0 == run.x0 && part.pixels.x1 == run.x1 && part.pixels.y1 == y0 &&
                   part.passes == run.passes;
        });
        if (same == open.end()) {
            next.push_back({{run.x0, y0, run.x1, y1}, run.passes});
            continue;
        }
        next.push_back(*same);
        next.back().pixels.y1 = y1;
        open.erase(same);
    }
    done.insert(done.end(), open.begin(), open.end());
    open = std::move(next);
}

} // namespace

PixelRect common_pixels(const PixelRect& a, const PixelRect& b)
{
    return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}

std::optional<CommonPass> common_pass(const std::vector<FilmPart>& a,
                                      const std::vector<FilmPart>& b)
{
    for (const FilmPart& one : a)
        for (const FilmPart& other : b) {
            const PixelRect pixels = common_pixels(one.pixels, other.pixels);
            if (pixels.empty())
                continue;
            if (const auto pass = common_pass(one.passes, other.passes))
                return CommonPass{pixels, *pass};
        }
    return std::nullopt;
}

std::vector<FilmPart> joined_parts(const std::vector<FilmPart>& parts)
{
    const std::vector<int> rows = edges_of(parts, &PixelRect::y0, &PixelRect::y1);
    std::vector<FilmPart> open, done;
    for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
        std::vector<FilmPart> here;
        for (const FilmPart& part : parts)
            if (part.pixels.y0 <= rows[i] && part.pixels.y1 > rows[i])
                here.push_back(part);
        add_rows(rows[i], rows[i + 1], runs_of(here), open, done);
    }
    done.insert(done.end(), open.begin(), open.end());
    std::ranges::sort(done, above);
    return done;
}

bool are_valid(const std::vector<FilmPart>& parts, int width, int height)
{
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const PixelRect& pixels = parts[i].pixels;
        const bool inside = pixels.x0 >= 0 && pixels.y0 >= 0 && pixels.x1 <= width &&
                            pixels.y1 <= height && !pixels.empty();
        if (!inside || parts[i].passes.ranges.empty() || !is_valid(parts[i].passes))
            return false;
        for (std::size_t j = 0; j < i; ++j)
            if (!common_pixels(pixels, parts[j].pixels).empty())
                return false;
    }
    return joined_parts(parts) == parts;
}

std::vector<FilmPart> missing_parts(const std::vector<FilmPart>& held, const FilmPart& wanted)
{
    // Rows and columns of the rectangles cut the wanted pixels into cells that hold the same.
    std::vector<FilmPart> all = held;
    all.push_back(wanted);
    const std::vector<int> xs = edges_of(all, &PixelRect::x0, &PixelRect::x1);
    const std::vector<int> ys = edges_of(all, &PixelRect::y0, &PixelRect::y1);
    std::vector<FilmPart> out;
    for (std::size_t y = 0; y + 1 < ys.size(); ++y)
        for (std::size_t x = 0; x + 1 < xs.size(); ++x) {
            FilmPart cell = {{xs[x], ys[y], xs[x + 1], ys[y + 1]}, wanted.passes};
            if (common_pixels(cell.pixels, wanted.pixels).empty())
                continue;
            for (const FilmPart& part : held)
                if (!common_pixels(cell.pixels, part.pixels).empty())
                    cell.passes = without(cell.passes, part.passes);
            if (!cell.passes.ranges.empty())
                out.push_back(std::move(cell));
        }
    return joined_parts(out);
}

} // namespace hipmap
