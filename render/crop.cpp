#include "render/crop.h"

#include "common/input_error.h"

#include <CLI/CLI.hpp>

#include <cmath>

namespace hipmap {

namespace {

std::string text_of_edge(const CropEdge& edge)
{
    return text_of(number_value(edge.at)) + (edge.percent ? "%" : "");
}

std::string text_of_crop(const Crop& crop)
{
    std::string out;
    for (const CropEdge& edge : crop.edges)
        out += (out.empty() ? "" : ",") + text_of_edge(edge);
    return out;
}

/// Returns nothing for text that is no edge.
std::optional<CropEdge> parse_edge(const std::string& text)
{
    CropEdge edge;
    edge.percent = text.ends_with('%');
    const std::string number = edge.percent ? text.substr(0, text.size() - 1) : text;
    if (!CLI::detail::lexical_cast(number, edge.at))
        return std::nullopt;
    const bool in_range = edge.at >= 0 && edge.at <= (edge.percent ? 100 : kMostPixelsAcross);
    if (!in_range || (!edge.percent && edge.at != std::floor(edge.at)))
        return std::nullopt;
    return edge;
}

Crop parse_crop(const std::string& text)
{
    const std::vector<std::string> edges = CLI::detail::split(text, ',');
    Crop out;
    bool good = edges.size() == out.edges.size();
    for (std::size_t i = 0; good && i < edges.size(); ++i) {
        const std::optional<CropEdge> edge = parse_edge(edges[i]);
        good = edge.has_value();
        out.edges[i] = edge.value_or(CropEdge());
    }
    if (!good)
        throw CLI::ValidationError("--crop", "'" + text +
                                                 "' is no part of an image; write X0,Y0,X1,Y1 in "
                                                 "pixels or percent, such as 25%,0,75%,50%");
    return out;
}

int pixel_of(const CropEdge& edge, int side)
{
    return static_cast<int>(edge.percent ? std::round(edge.at / 100 * side) : edge.at);
}

} // namespace

Crop crop_of(const PixelRect& pixels)
{
    Crop out;
    const std::array<int, 4> edges = {pixels.x0, pixels.y0, pixels.x1, pixels.y1};
    for (std::size_t i = 0; i < edges.size(); ++i)
        out.edges[i].at = edges[i];
    return out;
}

OptionField crop_field(std::optional<Crop>& into)
{
    return parsed_field(
        [&into](const std::string& text) { into = parse_crop(text); },
        [&into] { return into ? SettingValue(text_of_crop(*into)) : SettingValue(); },
        "X0,Y0,X1,Y1");
}

PixelRect pixels_of(const Crop& crop, const PictureSize& whole)
{
    const PixelRect out = {
        pixel_of(crop.edges[0], whole.width), pixel_of(crop.edges[1], whole.height),
        pixel_of(crop.edges[2], whole.width), pixel_of(crop.edges[3], whole.height)};
    const std::string size = std::to_string(whole.width) + "x" + std::to_string(whole.height);
    if (out.empty())
        throw InputError("--crop " + text_of_crop(crop) + ": holds no pixel of the image of " +
                         size + "; X0 must be less than X1, and Y0 less than Y1");
    if (out.x1 > whole.width || out.y1 > whole.height)
        throw InputError("--crop " + text_of_crop(crop) + ": reaches beyond the image of " + size +
                         "; give smaller edges or a larger --size");
    if (out == PixelRect{0, 0, whole.width, whole.height})
        return {};
    return out;
}

} // namespace hipmap
