#include "common/image/exr_file.h"
#include "common/input_error.h"
#include "render/layers/layer_file.h"
#include "render/layers/layer_table.h"
#include "tests/support/temporary_folder.h"

#include <catch2/catch.hpp>

#include <set>

using namespace hipmap;

TEST_CASE("layer_rows: names are unique, and each layer has channels and a help", "[layers]")
{
    std::set<std::string_view> names, passes;
    for (const LayerRow& row : layer_rows()) {
        INFO(row.name);
        CHECK(names.insert(row.name).second);
        CHECK(passes.insert(row.pass).second);
        CHECK(row.channels.size() >= 1);
        CHECK(row.channels.size() <= 4);
        CHECK(!row.help.empty());
        CHECK(text_of(parse_layers(row.name)) == row.name);
    }
}

TEST_CASE("parse_layers: keeps the order, drops repeats and lists the names for a wrong one",
          "[layers]")
{
    CHECK(text_of(parse_layers("normal,depth,normal")) == "normal,depth");
    for (const char* wrong : {"", "depth,", "Depth", "depth normal"})
        CHECK_THROWS_WITH(parse_layers(wrong),
                          Catch::Contains("is no layer; choose from combined,depth"));
    CHECK(chosen_layers({}).size() == layer_rows().size());
}

TEST_CASE("write_layers: channels have the names of view layer, pass and component", "[layers]")
{
    const TemporaryFolder folder;
    const auto rows = parse_layers("combined,noise");
    Image image(2, 1);
    image.pixels = {{1, 2, 3}, {4, 5, 6}};
    const std::vector<LayerImage> layers = {film_layer(*rows[0], image, {}),
                                            {rows[1], {6, 5, 4, 3, 2, 1}}};
    CHECK(layers[0].values == std::vector<float>{1, 2, 3, 1, 4, 5, 6, 1});
    write_layers(folder / "a.exr", "My Layer", {2, 1}, layers);
    CHECK(read_exr(folder / "a.exr", "My Layer.Combined").pixels == image.pixels);
    CHECK(read_exr(folder / "a.exr", "My Layer.Noise").pixels[1] == Rgb(3, 2, 1));
    CHECK_THROWS_WITH(read_exr(folder / "a.exr"), Catch::Contains("no channel R"));
}
