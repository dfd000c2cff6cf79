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

/// Returns whether the file is glTF by its suffix, else OBJ.
bool is_gltf(const std::filesystem::path& path)
{
    std::error_code error;
    if (!std::filesystem::exists(path, error))
        throw scene_error(path, "", "no such file; check the name");
    if (!std::filesystem::is_regular_file(path, error))
        throw scene_error(path, "", "not a file; name a .glb, .gltf or .obj file");
    const std::string suffix = lower_suffix(path);
    if (suffix != ".glb" && suffix != ".gltf" && suffix != ".obj")
        throw scene_error(path, "", "unknown scene format; export .glb, .gltf or .obj");
    return suffix != ".obj";
}

/// What `read` returns; the error of a scene that memory does not hold.
template <typename Read>
auto within_memory(const std::filesystem::path& path, const Read& read)
{
    try {
        return read();
    } catch (const std::bad_alloc&) {
        throw OutOfMemory(path.string() +
                          ": does not fit into memory; export fewer faces or instances");
    }
}

/// OBJ names no program that wrote the file.
RawScene read_obj_as(const SceneOptions& options, const std::filesystem::path& path)
{
    RawScene scene = read_obj(path, options.texture_cache_mib);
    scene.look = choose_look(options.look, "");
    for (Material& material : scene.materials)
        shade_like(scene.look, material);
    return scene;
}

constexpr std::uint64_t kMib = 1 << 20;

void note_size(const RawScene& raw, SceneAudit& audit)
{
    audit.found.insert(audit.found.begin(), counted(raw.all_face_count(), "face") + " in " +
                                                counted(raw.objects.size(), "object") + ", " +
                                                counted(raw.materials.size(), "material"));
}

void note_textures(const std::vector<TextureImage>& images, SceneAudit& audit)
{
    const auto [all, in_memory] = bytes_of_textures(images);
    const auto mib = [](std::uint64_t bytes) {
        return std::to_string((bytes + kMib - 1) / kMib) + " MiB";
    };
    if (all > in_memory)
        audit.assumed.push_back("textures of " + mib(all) + " are in a temporary file, and " +
                                mib(in_memory) +
                                " of them in memory, as --texture-cache says: more are faster");
}

} // namespace

struct SceneSource::Impl {
    std::filesystem::path path;
    SceneOptions options;
    std::optional<GltfSource> gltf;
    RawScene obj;
};

SceneSource::SceneSource(const std::filesystem::path& path, const SceneOptions& options)
    : impl_(new Impl{path, options, {}, {}})
{
    within_memory(path, [&] {
        if (is_gltf(path))
            impl_->gltf.emplace(path, options);
        else
            impl_->obj = read_obj_as(options, path);
        return true;
    });
}

SceneSource::~SceneSource() = default;
SceneSource::SceneSource(SceneSource&&) noexcept = default;
SceneSource& SceneSource::operator=(SceneSource&&) noexcept = default;

LoadedScene SceneSource::at(std::optional<double> time, bool last)
{
    const SceneOptions& options = impl_->options;
    return within_memory(impl_->path, [&] {
        RawScene raw = impl_->gltf ? impl_->gltf->at(time, last)
                       : last      ? std::move(impl_->obj)
                                   : impl_->obj;
        if (last)
            impl_->gltf.reset(); // it holds the file, which may be as large as the scene
        exclude_objects(raw, options.exclude);
        LoadedScene loaded;
        loaded.audit = std::move(raw.audit);
        note_size(raw, loaded.audit);
        if (time && !raw.sweep)
            loaded.audit.warnings.push_back("the file has no animation: all frames show the "
                                            "same");
        if (is_blender(raw.look))
            loaded.audit.assumed.push_back(describe_look(raw.look));
        note_textures(raw.images, loaded.audit);
        loaded.scene = to_scene_units(raw);
        complete_scene(loaded, options, impl_->path);
        return loaded;
    });
}

LoadedScene load_scene(const std::filesystem::path& path, const SceneOptions& options)
{
    return SceneSource(path, options).at(options.time, true);
}

} // namespace hipmap
