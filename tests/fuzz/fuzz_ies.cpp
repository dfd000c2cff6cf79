#include "common/input_error.h"
#include "common/scene/ies_file.h"
#include "render/lights/ies_light.h"
#include "tests/fuzz/scratch_file.h"

#include <cmath>
#include <cstdlib>

namespace {

/// Makes a light of what was read, which must send unit directions and finite power.
void check_light(const hipmap::PhotometricWeb& web)
{
    hipmap::SceneIesLight of_scene;
    of_scene.intensity = glm::dvec3(1);
    of_scene.web = web;
    const hipmap::IesLight light = hipmap::light_from(of_scene, {});
    hipmap::RandomSequence random(1, hipmap::RandomStream::photons, 0, 0);
    for (int i = 0; i < 16; ++i) {
        const glm::vec3 drawn = hipmap::sample_direction(light, random);
        if (!(std::abs(glm::length(drawn) - 1) < 1e-4f) ||
            !(hipmap::candela_along(light, drawn) >= 0))
            std::abort();
    }
    if (!std::isfinite(hipmap::power(light).x))
        std::abort();
}

} // namespace

/// libFuzzer's entry: one .ies.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const hipmap::ScratchFile file("lamp.ies");
    try {
        check_light(hipmap::read_ies(file.write(data, size)));
    } catch (const hipmap::InputError&) {
        // What bad input is meant to end in.
    }
    return 0;
}
