#include "common/image/view_transform.h"

#include "common/image/blender_config.h"
#include "common/input_error.h"

#ifdef HIPMAP_OPENCOLORIO
#include <OpenColorIO/OpenColorIO.h>

#include <array>
#endif

namespace hipmap {

#ifdef HIPMAP_OPENCOLORIO

namespace {

namespace ocio = OCIO_NAMESPACE;

/// Names of linear Rec. 709 with the white point D65 in the configurations of Blender up to 3 and
/// from 4 on, of ACES, and of others.
constexpr std::array kLinearNames{
    "Linear Rec.709",          "Linear",     "Linear Rec.709 (sRGB)",
    "lin_rec709_scene",        "lin_rec709", "Utility - Linear - Rec.709",
    "Utility - Linear - sRGB", "lin_srgb"};

/// Errors of OpenColorIO name neither the file nor what to do.
[[noreturn]] void fail(const std::string& config, std::string what)
{
    while (what.ends_with('.'))
        what.pop_back();
    throw InputError(config + ": " + what + "; name another configuration or view");
}

std::string linear_space(const ocio::Config& config, const std::string& path)
{
    for (const char* name : kLinearNames)
        if (const ocio::ConstColorSpaceRcPtr space = config.getColorSpace(name))
            return space->getName();
    fail(path, "has no linear Rec. 709 colour space, such as 'Linear Rec.709'");
}

/// The view asked for; the default one where none is.
std::string view_named(const ocio::Config& config, const ViewChoice& choice,
                       const std::string& path)
{
    const char* const display = config.getDefaultDisplay();
    if (choice.view.empty())
        return config.getDefaultView(display);
    std::string names;
    for (int i = 0; i < config.getNumViews(display); ++i) {
        const std::string name = config.getView(display, i);
        if (name == choice.view)
            return name;
        names += (i > 0 ? ", '" : "'") + name + "'";
    }
    fail(path, "has no view '" + choice.view + "', but " + names);
}

ocio::ConstCPUProcessorRcPtr make_processor(const ViewChoice& choice, const std::string& path)
{
    const ocio::ConstConfigRcPtr config = ocio::Config::CreateFromFile(path.c_str());
    const ocio::DisplayViewTransformRcPtr transform = ocio::DisplayViewTransform::Create();
    transform->setSrc(linear_space(*config, path).c_str());
    transform->setDisplay(config->getDefaultDisplay());
    transform->setView(view_named(*config, choice, path).c_str());
    return config->getProcessor(transform)->getDefaultCPUProcessor();
}

} // namespace

DisplayView make_view(const ViewChoice& choice)
{
    if (choice.config.empty()) {
        if (!choice.view.empty())
            throw InputError("--view needs --ocio; name a configuration, or give --ocio blender");
        return {};
    }
    const std::string path = choice.config == "blender"
                                 ? find_blender_config(blender_folders()).string()
                                 : choice.config;
    try {
        return [processor = make_processor(choice, path)](std::span<Rgb> pixels) {
            ocio::PackedImageDesc row(pixels.data(), static_cast<long>(pixels.size()), 1, 3);
            processor->apply(row);
        };
    } catch (const ocio::Exception& problem) {
        fail(path, problem.what());
    }
}

#else

DisplayView make_view(const ViewChoice& choice)
{
    if (choice.config.empty() && choice.view.empty())
        return {};
    throw InputError("--ocio and --view: this build has no OpenColorIO; install "
                     "libopencolorio-dev and build hipmap again");
}

#endif

} // namespace hipmap
