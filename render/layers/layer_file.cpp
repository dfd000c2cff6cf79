#include "render/layers/layer_file.h"

#include "common/input_error.h"
#include "render/layers/layer_table.h"

#include <algorithm>

namespace hipmap {

namespace {

std::vector<const LayerRow*> all_layers()
{
    std::vector<const LayerRow*> out;
    for (const LayerRow& row : layer_rows())
        out.push_back(&row);
    return out;
}

const LayerRow* find_layer(std::string_view name)
{
    const auto rows = layer_rows();
    const auto found = std::ranges::find(rows, name, &LayerRow::name);
    if (found == rows.end())
        throw InputError("--layer-names: '" + std::string(name) + "' is no layer; choose from " +
                         text_of(all_layers()));
    return &*found;
}

} // namespace

std::vector<const LayerRow*> parse_layers(std::string_view text)
{
    std::vector<const LayerRow*> out;
    while (true) {
        const std::size_t comma = std::min(text.find(','), text.size());
        const LayerRow* const row = find_layer(text.substr(0, comma));
        if (std::ranges::find(out, row) == out.end())
            out.push_back(row);
        if (comma == text.size())
            return out;
        text.remove_prefix(comma + 1);
    }
}

std::string text_of(std::span<const LayerRow* const> rows)
{
    std::string out;
    for (const LayerRow* row : rows)
        (out += out.empty() ? "" : ",") += row->name;
    return out;
}

std::vector<const LayerRow*> chosen_layers(const LayerChoice& choice)
{
    return choice.rows.empty() ? all_layers() : choice.rows;
}

LayerImage film_layer(const LayerRow& row, const Image& image, const Film& film)
{
    const Image layer = std::get<OfFilm>(row.read).read(image, film);
    LayerImage out{&row, {}};
    out.values.reserve(layer.pixels.size() * row.channels.size());
    for (const Rgb& pixel : layer.pixels)
        for (std::size_t c = 0; c < row.channels.size(); ++c)
            out.values.push_back(c < 3 ? pixel[static_cast<int>(c)] : 1.0f);
    return out;
}

void write_layers(const std::filesystem::path& path, const std::string& view_layer,
                  const ExrWindow& window, std::span<const LayerImage> layers)
{
    std::vector<ExrChannel> channels;
    for (const LayerImage& layer : layers)
        for (std::size_t c = 0; c < layer.row->channels.size(); ++c)
            channels.push_back({.name = view_layer + "." + std::string(layer.row->pass) + "." +
                                        layer.row->channels[c],
                                .first = layer.values.data() + c,
                                .stride = layer.row->channels.size()});
    write_exr_channels(path, window, channels);
}

} // namespace hipmap
