#include "render/paths/path_state.h"
#include "render/paths/roulette.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

struct Played {
    double survived = 0; ///< share of the paths
    double carried = 0;  ///< mean over all paths
    float least = 1, most = 0;
};

/// Plays with many paths that are alike.
Played play(EyePathClass behind, int depth, float weight)
{
    constexpr int kPaths = 20'000;
    RandomSequence random(1, RandomStream::eye_paths, 0, 0);
    Played out;
    for (int i = 0; i < kPaths; ++i) {
        PathState path;
        path.behind = behind;
        path.depth = depth;
        path.throughput = Rgb(weight);
        if (!survives(path, random))
            continue;
        out.survived += 1.0 / kPaths;
        out.carried += double{path.throughput.x} / kPaths;
        out.least = std::min(out.least, path.throughput.x);
        out.most = std::max(out.most, path.throughput.x);
    }
    return out;
}

} // namespace

TEST_CASE("Russian roulette: the mean stays", "[integrator]")
{
    for (const EyePathClass behind : {EyePathClass::specular, EyePathClass::highlight,
                                      EyePathClass::indirect, EyePathClass::caustic})
        for (const int depth : {1, 5, 6, 40, 600})
            for (const float weight : {0.9f, 0.3f, 0.04f})
                CHECK(play(behind, depth, weight).carried == Approx(weight).epsilon(0.2));
}

TEST_CASE("Russian roulette: a path that no gathered lobe sent carries little however far it goes",
          "[integrator]")
{
    for (const EyePathClass behind : {EyePathClass::specular, EyePathClass::highlight})
        for (const int depth : {1, 5, 6, 40}) {
            CHECK(play(behind, depth, 0.06f).survived == Approx(1));
            const Played dim = play(behind, depth, 0.01f);
            CHECK(dim.survived == Approx(0.2).epsilon(0.1));
            CHECK(dim.most == Approx(kSeenWeight));
        }
    CHECK(play(EyePathClass::indirect, 40, 0.06f).least == Approx(1));
    // Between perfect mirrors nothing else would end it.
    CHECK(play(EyePathClass::specular, 600, 1).survived < 1);
}
