#include "common/scene/gltf_model.h"

#include "common/file/output_file.h"
#include "common/scene/gltf_unread.h"
#include "common/scene/raw_scene.h"
#include "common/scene/scene_file.h"
#include "common/scene/scene_names.h"

#include <cstring>
#include <map>
#include <optional>

namespace hipmap {

namespace {

/// Files that may be opened, by the name tinygltf asks for: the buffers' and no others.
struct BufferFiles {
    struct File {
        std::filesystem::path path;
        std::size_t length = 0;
    };
    std::map<std::string, File> by_name;
};

bool is_buffer_file(const std::string& name, void* files)
{
    return static_cast<const BufferFiles*>(files)->by_name.contains(name);
}

std::string same_path(const std::string& name, void*)
{
    return name;
}

bool read_buffer_file(std::vector<unsigned char>* out, std::string*, const std::string& name,
                      void* files)
{
    const BufferFiles::File& file = static_cast<const BufferFiles*>(files)->by_name.at(name);
    const std::vector<std::byte> bytes = read_file(file.path);
    // A file may be longer than its buffer; tinygltf wants it exact.
    out->resize(std::min(bytes.size(), file.length));
    if (!out->empty())
        std::memcpy(out->data(), bytes.data(), out->size());
    return true;
}

bool write_nothing(std::string*, const std::string&, const std::vector<unsigned char>&, void*)
{
    return false;
}

bool skip_picture(tinygltf::Image*, const int, std::string*, std::string*, int, int,
                  const unsigned char*, int, void*)
{
    return true;
}

/// The text of a percent-encoded URI; nothing if a code is broken or stands for NUL.
std::optional<std::string> decode_percent(const std::string& uri)
{
    const auto digit = [](char c) {
        const char* const digits = "0123456789abcdef";
        const char* const at = c == 0 ? nullptr : std::strchr(digits, c | 0x20);
        return at ? static_cast<int>(at - digits) : -1;
    };
    std::string text;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        char c = uri[i];
        if (c == '%') {
            const int high = i + 1 < uri.size() ? digit(uri[i + 1]) : -1;
            const int low = i + 2 < uri.size() ? digit(uri[i + 2]) : -1;
            if (high < 0 || low < 0)
                return std::nullopt;
            c = static_cast<char>(16 * high + low);
            i += 2;
        }
        if (c == 0)
            return std::nullopt;
        text += c;
    }
    return text;
}

/// The name tinygltf will ask for: it also decodes '+'.
std::string name_asked_for(const std::string& uri)
{
    std::string plus = uri;
    for (char& c : plus)
        if (c == '+')
            c = ' ';
    return *decode_percent(plus);
}

BufferFiles find_buffer_files(const GltfDocument& document)
{
    BufferFiles files;
    if (!document.json.contains("buffers"))
        return files;
    for (std::size_t i = 0; i < document.json["buffers"].size(); ++i) {
        const nlohmann::json& buffer = document.json["buffers"][i];
        const std::string place = "buffers[" + std::to_string(i) + "]";
        const std::string uri = buffer.value("uri", std::string());
        const bool embedded = document.binary && uri.empty();
        if (embedded || tinygltf::IsDataURI(uri))
            continue;
        const std::optional<std::string> name = decode_percent(uri);
        if (!name || uri.starts_with("data:"))
            throw scene_error(document.path, place,
                              "its uri cannot be read; export the file again as .glb");
        const std::filesystem::path path = file_beside(document.path, place, *name);
        const auto length = buffer["byteLength"].get<std::size_t>();
        if (std::filesystem::file_size(path) < length)
            throw scene_error(document.path, place,
                              quote_name(*name) +
                                  " is shorter than the scene says; export it again");
        files.by_name[name_asked_for(uri)] = {path, length};
    }
    return files;
}

} // namespace

tinygltf::Model parse_gltf(const GltfDocument& document)
{
    check_required_extensions(document);
    BufferFiles files = find_buffer_files(document);
    tinygltf::TinyGLTF loader;
    loader.SetImageLoader(skip_picture, nullptr);
    loader.SetFsCallbacks({is_buffer_file, same_path, read_buffer_file, write_nothing, &files});

    tinygltf::Model model;
    std::string error, warning;
    const auto size = static_cast<unsigned int>(document.bytes.size());
    bool good = false;
    try {
        if (document.binary) {
            const auto* bytes = reinterpret_cast<const unsigned char*>(document.bytes.data());
            good = loader.LoadBinaryFromMemory(&model, &error, &warning, bytes, size);
        } else {
            const auto* text = reinterpret_cast<const char*>(document.bytes.data());
            good = loader.LoadASCIIFromString(&model, &error, &warning, text, size, "");
        }
    } catch (const InputError&) {
        throw;
    } catch (const std::exception& failure) {
        error = failure.what();
    }
    if (!good)
        throw scene_error(document.path, "glTF",
                          "cannot be read (" + quote_name(error.substr(0, error.find('\n'))) +
                              "); export it again");
    return model;
}

} // namespace hipmap
