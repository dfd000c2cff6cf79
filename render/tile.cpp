#include "render/tile.h"

#include "common/input_error.h"
#include "render/film/film.h"

#include <CLI/CLI.hpp>

namespace hipmap {

namespace {

std::string text_of_tile(const Tile& tile)
{
    return std::to_string(tile.number) + "/" + std::to_string(tile.columns) + "x" +
           std::to_string(tile.rows);
}

Tile parse_tile(const std::string& text)
{
    const std::vector<std::string> words = CLI::detail::split(text, '/');
    const std::vector<std::string> sides = CLI::detail::split(words.back(), 'x');
    Tile out;
    const bool good = words.size() == 2 && sides.size() == 2 &&
                      CLI::detail::lexical_cast(words[0], out.number) &&
                      CLI::detail::lexical_cast(sides[0], out.columns) &&
                      CLI::detail::lexical_cast(sides[1], out.rows);
    const auto most = static_cast<int>(kMostFilmParts);
    if (!good || out.columns < 1 || out.rows < 1 || out.columns > most || out.rows > most ||
        out.columns * out.rows > most || out.number < 0 || out.number >= out.columns * out.rows)
        throw CLI::ValidationError(
            "--tile", "'" + text +
                          "' is no tile; write NUMBER/COLUMNSxROWS, such as 0/4x3 to 11/4x3 "
                          "for the 12 tiles of a grid, " +
                          std::to_string(most) + " at most");
    return out;
}

/// The place where tile `number` of `count` begins along a side.
int edge_of(int number, int count, int low, int high)
{
    return low + static_cast<int>(std::int64_t{high - low} * number / count);
}

} // namespace

OptionField tile_field(std::optional<Tile>& into)
{
    return parsed_field(
        [&into](const std::string& text) { into = parse_tile(text); },
        [&into] { return into ? SettingValue(text_of_tile(*into)) : SettingValue(); },
        "N/COLUMNSxROWS");
}

PixelRect pixels_of(const Tile& tile, const PixelRect& image)
{
    if (tile.columns > image.width() || tile.rows > image.height())
        throw InputError("--tile " + text_of_tile(tile) +
                         ": more columns or rows than the image of " +
                         std::to_string(image.width()) + "x" + std::to_string(image.height()) +
                         " has pixels; give fewer");
    const int column = tile.number % tile.columns, row = tile.number / tile.columns;
    return {edge_of(column, tile.columns, image.x0, image.x1),
            edge_of(row, tile.rows, image.y0, image.y1),
            edge_of(column + 1, tile.columns, image.x0, image.x1),
            edge_of(row + 1, tile.rows, image.y0, image.y1)};
}

} // namespace hipmap
