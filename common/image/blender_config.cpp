#include "common/image/blender_config.h"

#include "common/input_error.h"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <sstream>
#include <string>

namespace hipmap {

namespace {

namespace fs = std::filesystem;

constexpr const char* kConfig = "datafiles/colormanagement/config.ocio";

/// The version that a folder is named by, such as 4.2.
std::optional<std::pair<int, int>> version_of(const fs::path& folder)
{
    std::istringstream name(folder.filename().string());
    int major = 0, minor = 0;
    char dot = 0;
    if (!(name >> major >> dot >> minor) || dot != '.' || !name.eof())
        return std::nullopt;
    return std::pair(major, minor);
}

/// The folders of versions below `folder`, newest first.
std::vector<fs::path> versions_below(const fs::path& folder)
{
    std::vector<fs::path> found;
    std::error_code unreadable;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, unreadable))
        if (version_of(entry.path()))
            found.push_back(entry.path());
    std::sort(found.begin(), found.end(),
              [](const fs::path& a, const fs::path& b) { return version_of(a) > version_of(b); });
    return found;
}

} // namespace

std::vector<fs::path> blender_folders()
{
    std::vector<fs::path> out;
    const char* const variable = std::getenv("PATH");
    std::istringstream path(variable != nullptr ? variable : "");
    for (std::string folder; std::getline(path, folder, ':');) {
        std::error_code missing;
        const fs::path program = fs::canonical(fs::path(folder) / "blender", missing);
        if (!missing)
            out.push_back(program.parent_path());
    }
    out.insert(out.end(), {"/usr/share/blender", "/opt/blender"});
    return out;
}

fs::path find_blender_config(std::span<const fs::path> folders)
{
    for (const fs::path& folder : folders) {
        std::vector<fs::path> places = versions_below(folder);
        places.push_back(folder);
        for (const fs::path& place : places)
            if (std::error_code none; fs::is_regular_file(place / kConfig, none))
                return place / kConfig;
    }
    throw InputError("--ocio blender: found no Blender; name its file " + std::string(kConfig));
}

} // namespace hipmap
