#include "common/image/legend.h"

#include "common/image/srgb.h"
#include "common/image/write_image.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <map>
#include <sstream>

namespace hipmap {

namespace {

constexpr int kGlyphWidth = 5;
constexpr int kGlyphHeight = 7;
constexpr int kAdvance = 6;
constexpr int kSwatchHeight = 12;
constexpr int kRow = 20;
constexpr int kMargin = 8;
constexpr int kGap = 6; ///< between swatch and text
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

/// A line of an entry's text, of which the first has the swatch.
struct Line {
    const LegendEntry& entry;
    std::string text;
    bool first = true;
    int left = 0, row = 0;

    int text_left() const
    {
        return left + (entry.colours.empty() ? 0 : swatch_width(entry) + kGap);
    }
};

/// Breaks a text at blanks into lines of at most so many letters, or of one word;
/// at least one.
std::vector<std::string> broken(const std::string& text, int letters)
{
    std::vector<std::string> lines;
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        const bool fits =
            !lines.empty() && static_cast<int>(lines.back().size() + 1 + word.size()) <= letters;
        if (fits)
            lines.back() += ' ' + word;
        else
            lines.push_back(word);
    }
    return lines.empty() ? std::vector<std::string>{""} : lines;
}

/// Where each line goes, in rows as wide as the picture.  Entries that are too long for a row are
/// broken.
std::vector<Line> arrange(const std::vector<LegendEntry>& entries, int width)
{
    std::vector<Line> lines;
    int left = kMargin, row = 0;
    for (const LegendEntry& entry : entries) {
        Line line{entry, entry.text, true, kMargin, row};
        const int wide = line.text_left() - kMargin + text_width(entry.text);
        if (left > kMargin && left + wide + kMargin > width) {
            left = kMargin;
            line.row = ++row;
        }
        line.left = left;
        left += wide + 3 * kMargin;
        if (line.left + wide + kMargin <= width) {
            lines.push_back(line);
            continue;
        }
        for (const std::string& text :
             broken(entry.text, (width - kMargin - line.text_left()) / kAdvance)) {
            line.text = text;
            line.row = row++;
            lines.push_back(line);
            line.first = false;
        }
        --row;
    }
    return lines;
}

} // namespace

Image add_legend(const Image& picture, const std::vector<LegendEntry>& entries)
{
    if (entries.empty())
        return picture;
    const std::vector<Line> lines = arrange(entries, picture.width);
    Image out(picture.width, picture.height + kRow * (lines.back().row + 1) + kMargin);
    std::ranges::fill(out.pixels, Rgb(kPaper));
    std::ranges::copy(picture.pixels, out.pixels.begin());
    for (const Line& line : lines) {
        const int top = picture.height + kMargin + kRow * line.row;
        if (line.first && !line.entry.colours.empty())
            draw_swatch(out, line.left, top, line.entry);
        draw_text(out, line.text_left(), top + (kSwatchHeight - kGlyphHeight) / 2, line.text);
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
