#include "common/scene/scene_file.h"

#include "common/scene/raw_scene.h"
#include "common/scene/scene_names.h"

#include <system_error>

namespace hipmap {

namespace {

constexpr std::size_t kLongestPath = 1000;

/// "file:", "http:", "c:": letters before a colon, before any slash.
bool has_scheme(const std::string& name)
{
    const std::size_t colon = name.find(':');
    return colon != std::string::npos && name.find('/') > colon;
}

bool leaves_folder(const std::filesystem::path& path)
{
    for (const std::filesystem::path& part : path)
        if (part == "..")
            return true;
    return false;
}

} // namespace

std::filesystem::path file_beside(const std::filesystem::path& scene, std::string_view place,
                                  const std::string& name)
{
    const std::filesystem::path relative(name);
    if (name.empty() || name.size() > kLongestPath || name.find('\0') != std::string::npos ||
        name.find('\\') != std::string::npos || has_scheme(name))
        throw scene_error(scene, place,
                          quote_name(name) + " does not name a file in the folder of the "
                                             "scene; put the file there");
    if (relative.is_absolute() || leaves_folder(relative))
        throw scene_error(scene, place,
                          quote_name(name) + " lies outside the scene's folder and was "
                                             "not opened; put the file beside the scene");
    const std::filesystem::path path = scene.parent_path() / relative;
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error))
        throw scene_error(scene, place,
                          quote_name(name) + " is missing or not a file; put it beside "
                                             "the scene");
    return path;
}

} // namespace hipmap
