#include "preprocess/colouring/partition_pictures.h"

#include "common/image/colour_scale.h"
#include "common/input_error.h"
#include "preprocess/colouring/painters.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace hipmap {

namespace {

using Legend = std::vector<LegendEntry>;

Legend legend_of_maps(const Partition& partition)
{
    return {{{}, std::to_string(partition.map_count) + " shared maps, a colour each"}};
}

Legend legend_of_edges(const Partition& partition)
{
    static constexpr std::array<const char*, 5> kNames{"connected", "unconnected", "border",
                                                       "non-manifold", "degenerate"};
    Legend legend;
    for (std::size_t i = 0; i < kNames.size(); ++i) {
        const auto edge_class = static_cast<EdgeClass>(i);
        if (std::ranges::find(partition.edge_class, edge_class) != partition.edge_class.end())
            legend.push_back({{edge_colour(edge_class)}, kNames[i]});
    }
    return legend;
}

Legend legend_of_candidates(const Partition& partition, std::span<const float> photons)
{
    constexpr int kSteps = 96;
    Legend legend;
    const PhotonRange range = photons_of_candidates(partition, photons);
    if (range.largest > 0) {
        LegendEntry scale;
        for (int i = 0; i < kSteps; ++i)
            scale.colours.push_back(scale_colour(i / (kSteps - 1.0)));
        std::ostringstream text;
        text << "candidates by expected photons: " << std::lround(range.least) << " to "
             << std::lround(range.largest);
        scale.text = text.str();
        legend.push_back(scale);
    } else if (photons.empty()) {
        legend.push_back({{scale_colour(1)}, "candidates by shape alone, as no light emits"});
    }
    legend.push_back({{kPlainFace}, "no candidate"});
    return legend;
}

Legend legend_of_groups(const Partition& partition)
{
    return {{{},
             std::to_string(partition.group_count) +
                 " candidates for group maps, a colour each, darker toward the rim"},
            {{kPlainFace}, "in no group"}};
}

} // namespace

std::vector<LegendedPicture> write_partition_pictures(const std::filesystem::path& folder,
                                                      const PartitionView& shown, int width,
                                                      int height)
{
    const auto& [scene, partition, candidates, photons] = shown;
    std::error_code problem;
    std::filesystem::create_directory(folder, problem);
    if (problem)
        throw InputError(folder.string() + ": " + problem.message() + "; name another folder");

    const EmbreeScene rays(scene.mesh);
    const PictureView view{scene.mesh, rays, scene.cameras[scene.camera], width, height};
    std::vector<const char*> names = {"shared_maps.png", "edges.png"};
    std::vector<Painter> paints = {paint_maps(partition), paint_edges(scene.mesh, partition)};
    std::vector<Legend> legends = {legend_of_maps(partition), legend_of_edges(partition)};
    if (candidates) {
        names.insert(names.end(), {"candidates.png", "groups.png"});
        paints.push_back(paint_candidates(partition, photons));
        paints.push_back(paint_groups(scene.mesh, partition));
        legends.push_back(legend_of_candidates(partition, photons));
        legends.push_back(legend_of_groups(partition));
    }
    const std::vector<Image> images = colour_images(view, paints);
    std::vector<LegendedPicture> written;
    for (std::size_t i = 0; i < names.size(); ++i)
        written.push_back(write_with_legend(folder / names[i], images[i], legends[i]));
    return written;
}

} // namespace hipmap
