#include "common/scene/load_scene.h"

#include "common/scene/complete_scene.h"
#include "common/scene/exclude_objects.h"
#include "common/scene/raw_scene.h"
#include "common/scene/read_gltf.h"
#include "common/scene/read_obj.h"
#include "common/scene/scene_frame.h"
#include "common/scene/scene_names.h"

#include <algorithm>
#include <cctype>
#include <new>
#include <system_error>

namespace hipmap {

namespace {

std::string lower_suffix(const std::filesystem::path& path)
{
    std::string suffix = path.extension().string();
    for (char& c : suffix)
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return suffix;
}

RawScene read_raw_scene(const std::filesystem::path& path, std::optional<double> time)
{
    std::error_code error;
    if (!std::filesystem::exists(path, error))
        throw scene_error(path, "", "no such file; check the name");
    if (!std::filesystem::is_regular_file(path, error))
        throw scene_error(path, "", "not a file; name a .glb, .gltf or .obj file");
    const std::string suffix = lower_suffix(path);
    if (suffix == ".glb" || suffix == ".gltf")
        return read_gltf(path, time);
    if (suffix == ".obj")
        return read_obj(path);
    throw scene_error(path, "", "not a kind of scene that is read; export .glb, .gltf or .obj");
}

void note_size(const RawScene& raw, SceneAudit& audit)
{
    audit.found.insert(audit.found.begin(), counted(raw.corners.size(), "face") + " in " +
                                                counted(raw.objects.size(), "object") + ", " +
                                                counted(raw.materials.size(), "material"));
}

} // namespace

LoadedScene load_scene(const std::filesystem::path& path, const SceneOptions& options)
{
    try {
        RawScene raw = read_raw_scene(path, options.time);
        exclude_objects(raw, options.exclude);
        LoadedScene loaded;
        loaded.audit = std::move(raw.audit);
        note_size(raw, loaded.audit);
        if (options.time && !raw.sweep)
            loaded.audit.warnings.push_back("nothing in the file is animated: all frames show the "
                                            "same");
        loaded.scene = to_scene_units(raw, options.light_units);
        complete_scene(loaded, options, path);
        return loaded;
    } catch (const std::bad_alloc&) {
        throw scene_error(path, "", "does not fit into memory; export fewer faces or instances");
    }
}

} // namespace hipmap
