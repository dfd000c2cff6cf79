/// Compares a picture with a reference of the same scene.

#include "bench/image_difference.h"
#include "common/command_line/command_line.h"
#include "common/image/exposure.h"
#include "common/image/read_image.h"
#include "common/image/write_image.h"
#include "common/input_error.h"

#include <cstdio>
#include <optional>
#include <string>

namespace {

using namespace hipmap;

void print_means(const Image& image, const Image& reference)
{
    const glm::dvec3 a = mean_radiance(image);
    const glm::dvec3 b = mean_radiance(reference);
    std::printf("mean radiance of A      %.6g %.6g %.6g\n", a.x, a.y, a.z);
    std::printf("mean radiance of B      %.6g %.6g %.6g\n", b.x, b.y, b.z);
    std::printf("ratio A / B             %.4f %.4f %.4f\n", a.x / b.x, a.y / b.y, a.z / b.z);
    std::printf("relMSE of A against B   %.4g\n", relative_mse(image, reference));
}

void compare(const std::string& image_path, const std::string& reference_path,
             const std::string& picture_path)
{
    const Image image = read_image(image_path);
    const Image reference = read_image(reference_path);
    if (image.width != reference.width || image.height != reference.height)
        throw InputError(image_path + ": " + std::to_string(image.width) + "x" +
                         std::to_string(image.height) + " pixels, but " + reference_path + " has " +
                         std::to_string(reference.width) + "x" + std::to_string(reference.height) +
                         "; render both at one size");
    print_means(image, reference);
    if (!picture_path.empty())
        write_image(picture_path, side_by_side(image, reference),
                    {.exposure_ev = auto_exposure(reference)});
}

} // namespace

int main(int argc, char** argv)
{
    return hipmap::run_tool([&] {
        CLI::App app("Compares linear pictures (.exr, .pfm or .hdr) of one scene.",
                     "compare_images");
        std::string image_path, reference_path, picture_path;
        app.add_option("A", image_path, "Picture to judge")->required();
        app.add_option("B", reference_path, "Reference of the same size")->required();
        app.add_option("--side-by-side", picture_path,
                       "Write A beside B, both exposed as suits the reference")
            ->type_name("FILE");
        if (const std::optional<int> code = hipmap::parse_arguments(app, argc, argv))
            return *code;
        compare(image_path, reference_path, picture_path);
        return hipmap::kExitDone;
    });
}
