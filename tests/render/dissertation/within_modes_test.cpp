#include "render/dissertation/dissertation_maps.h"
#include "tests/render/maps/within_by_hand.h"

using namespace hipmap;

TEST_CASE("fixed radius: every mode and tree gives what its definition says", "[dissertation]")
{
    std::size_t cut = 0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const auto ready =
            tiny::ready(tiny::make_scene(within::kSurfaces[seed % within::kSurfaces.size()](seed)));
        const TriangleMesh& mesh = ready->scene.mesh;
        const MapSurfaces surfaces(mesh, ready->partition);
        const std::vector<Photon> photons = within::make_photons(mesh, 500, seed);
        for (const MapMode mode :
             {MapMode::global, MapMode::shared, MapMode::thesis, MapMode::hierarchical})
            for (const TreeKind tree : {TreeKind::wide, TreeKind::balanced, TreeKind::unbalanced}) {
                DissertationOptions asked{mode, 50};
                asked.tree = tree;
                const DissertationMaps maps =
                    build_dissertation_maps(photons, surfaces, {50}, asked);
                const within::ByHand by_hand{surfaces, photons, maps.one_map()};
                ChosenScratch scratch;
                for (std::uint64_t i = 0; i < 10; ++i) {
                    const auto [query, radii] = within::random_query(mesh, seed, i);
                    INFO("seed " << seed << ", mode " << int(mode) << ", tree " << int(tree)
                                 << ", query " << i);
                    within::check_same(
                        dissertation::estimate_within(maps, surfaces, query, radii, scratch),
                        by_hand.estimate(query, radii));
                    cut += scratch.estimate.segments.empty() ? 0 : 1;
                }
            }
    }
    CHECK(cut > 500);
}
