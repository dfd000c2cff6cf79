#include "render/load_sky.h"

#include "common/image/read_image.h"
#include "common/input_error.h"

#include <algorithm>
#include <numbers>

namespace hipmap {

EnvironmentMap load_sky(const Scene& scene, double turn_deg)
{
    if (scene.environment_map_file.empty())
        return {};
    const Image map = read_image(scene.environment_map_file);
    for (std::size_t i = 0; i < map.pixels.size(); ++i) {
        const Rgb& pixel = map.pixels[i];
        const auto width = static_cast<std::size_t>(map.width);
        if (!(std::min({pixel.x, pixel.y, pixel.z}) >= 0))
            throw InputError(scene.environment_map_file + ": pixel (" + std::to_string(i % width) +
                             ", " + std::to_string(i / width) +
                             ") is below zero, which radiance cannot be; write the image again");
    }
    const double whole_turn_deg = scene.environment_turn_deg + turn_deg;
    return make_environment_map(map, scene.environment_strength,
                                static_cast<float>(whole_turn_deg * std::numbers::pi / 180));
}

} // namespace hipmap
