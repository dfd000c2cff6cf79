#include "common/image/legend.h"

#include "common/image/srgb.h"
#include "common/image/write_image.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <map>

namespace hipmap {

namespace {

constexpr int kGlyphWidth = 5;
constexpr int kGlyphHeight = 7;
constexpr int kAdvance = 6;
constexpr int kSwatchHeight = 12;
constexpr int kRow = 20;
constexpr int kMargin = 8;
constexpr float kPaper = 0.96f;
constexpr float kInk = 0.1f;

/// Rows from the top, five bits each, the leftmost highest.
using Glyph = std::array<std::uint8_t, kGlyphHeight>;

const std::map<char, Glyph>& glyphs()
{
    static const std::map<char, Glyph> kGlyphs{
        {'0', {14, 17, 19, 21, 25, 17, 14}}, {'1', {4, 12, 4, 4, 4, 4, 14}},
        {'2', {14, 17, 1, 6, 8, 16, 31}},    {'3', {14, 17, 1, 6, 1, 17, 14}},
        {'4', {2, 6, 10, 18, 31, 2, 2}},     {'5', {31, 16, 30, 1, 1, 17, 14}},
        {'6', {6, 8, 16, 30, 17, 17, 14}},   {'7', {31, 1, 2, 4, 8, 8, 8}},
        {'8', {14, 17, 17, 14, 17, 17, 14}}, {'9', {14, 17, 17, 15, 1, 2, 12}},
        {'a', {0, 0, 14, 1, 15, 17, 15}},    {'b', {16, 16, 30, 17, 17, 17, 30}},
        {'c', {0, 0, 14, 17, 16, 17, 14}},   {'d', {1, 1, 15, 17, 17, 17, 15}},
        {'e', {0, 0, 14, 17, 31, 16, 14}},   {'f', {6, 8, 28, 8, 8, 8, 8}},
        {'g', {0, 0, 15, 17, 15, 1, 14}},    {'h', {16, 16, 30, 17, 17, 17, 17}},
        {'i', {4, 0, 12, 4, 4, 4, 14}},      {'j', {2, 0, 6, 2, 2, 18, 12}},
        {'k', {16, 16, 18, 20, 24, 20, 18}}, {'l', {12, 4, 4, 4, 4, 4, 14}},
        {'m', {0, 0, 26, 21, 21, 21, 21}},   {'n', {0, 0, 30, 17, 17, 17, 17}},
        {'o', {0, 0, 14, 17, 17, 17, 14}},   {'p', {0, 0, 30, 17, 30, 16, 16}},
        {'q', {0, 0, 15, 17, 15, 1, 1}},     {'r', {0, 0, 22, 24, 16, 16, 16}},
        {'s', {0, 0, 15, 16, 14, 1, 30}},    {'t', {8, 8, 28, 8, 8, 8, 6}},
        {'u', {0, 0, 17, 17, 17, 17, 15}},   {'v', {0, 0, 17, 17, 17, 10, 4}},
        {'w', {0, 0, 17, 21, 21, 21, 10}},   {'x', {0, 0, 17, 10, 4, 10, 17}},
        {'y', {0, 0, 17, 17, 15, 1, 14}},    {'z', {0, 0, 31, 2, 4, 8, 31}},
        {'.', {0, 0, 0, 0, 0, 12, 12}},      {',', {0, 0, 0, 0, 4, 4, 8}},
        {':', {0, 4, 4, 0, 4, 4, 0}},        {'-', {0, 0, 0, 14, 0, 0, 0}},
        {'%', {24, 25, 2, 4, 8, 19, 3}},     {'(', {2, 4, 8, 8, 8, 4, 2}},
        {')', {8, 4, 2, 2, 2, 4, 8}},        {'/', {1, 1, 2, 4, 8, 16, 16}},
        {'+', {0, 4, 4, 31, 4, 4, 0}},
    };
    return kGlyphs;
}

int text_width(const std::string& text)
{
    return kAdvance * static_cast<int>(text.size());
}

int swatch_width(const LegendEntry& entry)
{
    return entry.colours.size() > 1 ? 96 : 16;
}

void draw_text(Image& image, int left, int top, const std::string& text)
{
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto glyph =
            glyphs().find(static_cast<char>(std::tolower(static_cast<unsigned char>(text[i]))));
        if (glyph == glyphs().end())
            continue;
        for (int y = 0; y < kGlyphHeight; ++y)
            for (int x = 0; x < kGlyphWidth; ++x)
                if (glyph->second[y] >> (kGlyphWidth - 1 - x) & 1)
                    if (const int column = left + kAdvance * static_cast<int>(i) + x;
                        column < image.width)
                        image.at(column, top + y) = Rgb(kInk);
    }
}

void draw_swatch(Image& image, int left, int top, const LegendEntry& entry)
{
    const int width = swatch_width(entry);
    for (int x = 0; x < width && left + x < image.width; ++x) {
        const Rgb& linear = entry.colours[entry.colours.size() * x / width];
        const Rgb display(srgb_from_linear(linear.x), srgb_from_linear(linear.y),
                          srgb_from_linear(linear.z));
        for (int y = 0; y < kSwatchHeight; ++y)
            image.at(left + x, top + y) = display;
    }
}

struct Place {
    int left;
    int row;
};

/// Where each entry goes, in rows as wide as the picture.
std::vector<Place> arrange(const std::vector<LegendEntry>& entries, int width)
{
    std::vector<Place> places;
    Place next{kMargin, 0};
    for (const LegendEntry& entry : entries) {
        const int wide =
            (entry.colours.empty() ? 0 : swatch_width(entry) + 6) + text_width(entry.text);
        if (next.left > kMargin && next.left + wide + kMargin > width)
            next = {kMargin, next.row + 1};
        places.push_back(next);
        next.left += wide + 3 * kMargin;
    }
    return places;
}

} // namespace

Image add_legend(const Image& picture, const std::vector<LegendEntry>& entries)
{
    if (entries.empty())
        return picture;
    const std::vector<Place> places = arrange(entries, picture.width);
    Image out(picture.width, picture.height + kRow * (places.back().row + 1) + kMargin);
    std::ranges::fill(out.pixels, Rgb(kPaper));
    std::ranges::copy(picture.pixels, out.pixels.begin());
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const int top = picture.height + kMargin + kRow * places[i].row;
        int left = places[i].left;
        if (!entries[i].colours.empty()) {
            draw_swatch(out, left, top, entries[i]);
            left += swatch_width(entries[i]) + 6;
        }
        draw_text(out, left, top + (kSwatchHeight - kGlyphHeight) / 2, entries[i].text);
    }
    return out;
}

std::string hex_colour(const Rgb& linear)
{
    char text[8];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", level_of(srgb_from_linear(linear.x)),
                  level_of(srgb_from_linear(linear.y)), level_of(srgb_from_linear(linear.z)));
    return text;
}

LegendedPicture write_with_legend(const std::filesystem::path& path, const Image& picture,
                                  std::vector<LegendEntry> legend)
{
    write_display_png(path, add_legend(picture, legend));
    return {path, picture.width, picture.height, std::move(legend)};
}

} // namespace hipmap
