#include "common/scene/gltf_document.h"
#include "common/scene/raw_scene.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <string_view>

namespace hipmap {

namespace {

using nlohmann::json;

enum class Want {
    object,
    array,
    filled_array, ///< at least one element
    string,
    boolean,
    number,
    numbers,    ///< as many as `size`
    offset,     ///< integer, 0 or more
    count,      ///< integer, 1 or more
    integer_to, ///< integer, 0 to `size`
    index,      ///< into the array at `target`
};

/// One property: where it is ("[]": every element, "{}": every member), and what it must be.
struct Rule {
    const char* path;
    Want want;
    bool required = false;
    const char* target = "";
    int size = 0;
};

constexpr const char* kLights = "extensions/KHR_lights_punctual/lights";

// A container's rule comes before those of its contents.
constexpr Rule kRules[] = {
    {"extensionsUsed", Want::array},
    {"extensionsUsed/[]", Want::string},
    {"extensionsRequired", Want::array},
    {"extensionsRequired/[]", Want::string},
    {"extensions", Want::object},
    {"extensions/KHR_lights_punctual", Want::object},
    {kLights, Want::array},
    {"extensions/KHR_lights_punctual/lights/[]", Want::object},
    {"extensions/KHR_lights_punctual/lights/[]/type", Want::string, true},
    {"extensions/KHR_lights_punctual/lights/[]/name", Want::string},
    {"extensions/KHR_lights_punctual/lights/[]/color", Want::numbers, false, "", 3},
    {"extensions/KHR_lights_punctual/lights/[]/intensity", Want::number},
    {"extensions/KHR_lights_punctual/lights/[]/range", Want::number},
    {"extensions/KHR_lights_punctual/lights/[]/spot", Want::object},
    {"extensions/KHR_lights_punctual/lights/[]/spot/innerConeAngle", Want::number},
    {"extensions/KHR_lights_punctual/lights/[]/spot/outerConeAngle", Want::number},

    {"buffers", Want::array},
    {"buffers/[]", Want::object},
    {"buffers/[]/byteLength", Want::count, true},
    {"buffers/[]/uri", Want::string},
    {"bufferViews", Want::array},
    {"bufferViews/[]", Want::object},
    {"bufferViews/[]/buffer", Want::index, true, "buffers"},
    {"bufferViews/[]/byteOffset", Want::offset},
    {"bufferViews/[]/byteLength", Want::count, true},
    {"bufferViews/[]/byteStride", Want::integer_to, false, "", 252},
    {"accessors", Want::array},
    {"accessors/[]", Want::object},
    {"accessors/[]/bufferView", Want::index, false, "bufferViews"},
    {"accessors/[]/byteOffset", Want::offset},
    {"accessors/[]/componentType", Want::count, true},
    {"accessors/[]/count", Want::count, true},
    {"accessors/[]/type", Want::string, true},
    {"accessors/[]/normalized", Want::boolean},
    {"accessors/[]/sparse", Want::object},
    {"accessors/[]/sparse/count", Want::count, true},
    {"accessors/[]/sparse/indices", Want::object, true},
    {"accessors/[]/sparse/indices/bufferView", Want::index, true, "bufferViews"},
    {"accessors/[]/sparse/indices/byteOffset", Want::offset},
    {"accessors/[]/sparse/indices/componentType", Want::count, true},
    {"accessors/[]/sparse/values", Want::object, true},
    {"accessors/[]/sparse/values/bufferView", Want::index, true, "bufferViews"},
    {"accessors/[]/sparse/values/byteOffset", Want::offset},

    {"images", Want::array},
    {"images/[]", Want::object},
    {"images/[]/bufferView", Want::index, false, "bufferViews"},
    {"images/[]/uri", Want::string},
    {"samplers", Want::array},
    {"textures", Want::array},
    {"textures/[]", Want::object},
    {"textures/[]/source", Want::index, false, "images"},
    {"textures/[]/sampler", Want::index, false, "samplers"},

    {"materials", Want::array},
    {"materials/[]", Want::object},
    {"materials/[]/name", Want::string},
    {"materials/[]/doubleSided", Want::boolean},
    {"materials/[]/alphaMode", Want::string},
    {"materials/[]/alphaCutoff", Want::number},
    {"materials/[]/emissiveFactor", Want::numbers, false, "", 3},
    {"materials/[]/emissiveTexture", Want::object},
    {"materials/[]/emissiveTexture/index", Want::index, true, "textures"},
    {"materials/[]/normalTexture", Want::object},
    {"materials/[]/normalTexture/index", Want::index, true, "textures"},
    {"materials/[]/occlusionTexture", Want::object},
    {"materials/[]/occlusionTexture/index", Want::index, true, "textures"},
    {"materials/[]/pbrMetallicRoughness", Want::object},
    {"materials/[]/pbrMetallicRoughness/baseColorFactor", Want::numbers, false, "", 4},
    {"materials/[]/pbrMetallicRoughness/metallicFactor", Want::number},
    {"materials/[]/pbrMetallicRoughness/roughnessFactor", Want::number},
    {"materials/[]/pbrMetallicRoughness/baseColorTexture", Want::object},
    {"materials/[]/pbrMetallicRoughness/baseColorTexture/index", Want::index, true, "textures"},
    {"materials/[]/pbrMetallicRoughness/metallicRoughnessTexture", Want::object},
    {"materials/[]/pbrMetallicRoughness/metallicRoughnessTexture/index", Want::index, true,
     "textures"},
    {"materials/[]/extensions", Want::object},
    {"materials/[]/extensions/{}", Want::object},
    {"materials/[]/extensions/KHR_materials_emissive_strength/emissiveStrength", Want::number},
    {"materials/[]/extensions/KHR_materials_transmission/transmissionFactor", Want::number},
    {"materials/[]/extensions/KHR_materials_ior/ior", Want::number},
    {"materials/[]/extensions/KHR_materials_specular/specularFactor", Want::number},
    {"materials/[]/extensions/KHR_materials_specular/specularColorFactor", Want::numbers, false, "",
     3},
    {"materials/[]/extensions/KHR_materials_volume/attenuationDistance", Want::number},
    {"materials/[]/extensions/KHR_materials_volume/attenuationColor", Want::numbers, false, "", 3},

    {"meshes", Want::array},
    {"meshes/[]", Want::object},
    {"meshes/[]/name", Want::string},
    {"meshes/[]/primitives", Want::filled_array, true},
    {"meshes/[]/primitives/[]", Want::object},
    {"meshes/[]/primitives/[]/attributes", Want::object, true},
    {"meshes/[]/primitives/[]/attributes/{}", Want::index, false, "accessors"},
    {"meshes/[]/primitives/[]/indices", Want::index, false, "accessors"},
    {"meshes/[]/primitives/[]/material", Want::index, false, "materials"},
    {"meshes/[]/primitives/[]/mode", Want::integer_to, false, "", 6},
    {"meshes/[]/primitives/[]/targets", Want::array},
    {"meshes/[]/primitives/[]/targets/[]", Want::object},
    {"meshes/[]/primitives/[]/targets/[]/{}", Want::index, false, "accessors"},
    {"meshes/[]/primitives/[]/extensions", Want::object},

    {"cameras", Want::array},
    {"cameras/[]", Want::object},
    {"cameras/[]/name", Want::string},
    {"cameras/[]/type", Want::string, true},
    {"cameras/[]/perspective", Want::object},
    {"cameras/[]/perspective/yfov", Want::number, true},
    {"cameras/[]/perspective/znear", Want::number, true},
    {"cameras/[]/perspective/zfar", Want::number},
    {"cameras/[]/perspective/aspectRatio", Want::number},
    {"cameras/[]/orthographic", Want::object},
    {"cameras/[]/orthographic/xmag", Want::number, true},
    {"cameras/[]/orthographic/ymag", Want::number, true},
    {"cameras/[]/orthographic/znear", Want::number, true},
    {"cameras/[]/orthographic/zfar", Want::number, true},

    {"skins", Want::array},
    {"animations", Want::array},
    {"nodes", Want::array},
    {"nodes/[]", Want::object},
    {"nodes/[]/name", Want::string},
    {"nodes/[]/children", Want::array},
    {"nodes/[]/children/[]", Want::index, false, "nodes"},
    {"nodes/[]/mesh", Want::index, false, "meshes"},
    {"nodes/[]/camera", Want::index, false, "cameras"},
    {"nodes/[]/skin", Want::index, false, "skins"},
    {"nodes/[]/translation", Want::numbers, false, "", 3},
    {"nodes/[]/rotation", Want::numbers, false, "", 4},
    {"nodes/[]/scale", Want::numbers, false, "", 3},
    {"nodes/[]/matrix", Want::numbers, false, "", 16},
    {"nodes/[]/extensions", Want::object},
    {"nodes/[]/extensions/{}", Want::object},
    {"nodes/[]/extensions/KHR_lights_punctual/light", Want::index, true, kLights},
    {"scenes", Want::array},
    {"scenes/[]", Want::object},
    {"scenes/[]/name", Want::string},
    {"scenes/[]/nodes", Want::array},
    {"scenes/[]/nodes/[]", Want::index, false, "nodes"},
    {"scene", Want::index, false, "scenes"},
};

/// The first part of a path, which is cut off it.
std::string_view take_step(std::string_view& path)
{
    const std::size_t slash = path.find('/');
    const std::string_view step = path.substr(0, slash);
    path = slash == std::string_view::npos ? std::string_view() : path.substr(slash + 1);
    return step;
}

std::size_t array_size(const json& root, std::string_view path)
{
    const json* at = &root;
    while (!path.empty()) {
        const std::string_view step = take_step(path);
        if (!at->is_object() || !at->contains(step))
            return 0;
        at = &(*at)[std::string(step)];
    }
    return at->size();
}

class SchemaCheck {
  public:
    explicit SchemaCheck(const GltfDocument& document) : document_(document) {}

    void apply(const Rule& rule)
    {
        if (rule.want == Want::index)
            index_limit_ = array_size(document_.json, rule.target);
        walk(rule, document_.json, rule.path, "");
    }

  private:
    void walk(const Rule& rule, const json& value, std::string_view path, const std::string& place)
    {
        if (path.empty())
            return check(rule, value, place);
        const std::string_view step = take_step(path);
        if (step == "[]") {
            for (std::size_t i = 0; i < value.size(); ++i)
                walk(rule, value[i], path, place + "[" + std::to_string(i) + "]");
        } else if (step == "{}") {
            for (const auto& [key, member] : value.items())
                walk(rule, member, path, place + "." + key);
        } else {
            const auto member = value.find(step);
            const std::string next = (place.empty() ? "" : place + ".") + std::string(step);
            if (member != value.end())
                walk(rule, *member, path, next);
            else if (rule.required && path.empty())
                fail(next, "missing");
        }
    }

    void check(const Rule& rule, const json& value, const std::string& place) const
    {
        const auto demand = [&](bool good, const std::string& what) {
            if (!good)
                fail(place, "must be " + what);
        };
        switch (rule.want) {
        case Want::object:
            return demand(value.is_object(), "an object");
        case Want::array:
            return demand(value.is_array(), "an array");
        case Want::filled_array:
            return demand(value.is_array() && !value.empty(), "an array that is not empty");
        case Want::string:
            return demand(value.is_string(), "text");
        case Want::boolean:
            return demand(value.is_boolean(), "true or false");
        case Want::number:
            return demand(value.is_number(), "a number");
        case Want::numbers:
            return demand(is_numbers(value, rule.size), std::to_string(rule.size) + " numbers");
        case Want::offset:
            return demand(is_integer_in(value, 0, kLargest), "an integer, 0 or more");
        case Want::count:
            return demand(is_integer_in(value, 1, kLargest), "an integer, 1 or more, below 2^53");
        case Want::integer_to:
            return demand(is_integer_in(value, 0, static_cast<std::uint64_t>(rule.size)),
                          "an integer from 0 to " + std::to_string(rule.size));
        case Want::index:
            if (!is_integer_in(value, 0, kLargest))
                fail(place, "must be an index");
            if (value.get<std::uint64_t>() >= index_limit_)
                fail(place, "names number " + value.dump() + " of " + std::to_string(index_limit_) +
                                " in '" + rule.target + "'");
            return;
        }
    }

    static bool is_integer_in(const json& value, std::uint64_t low, std::uint64_t high)
    {
        return value.is_number_unsigned() && value.get<std::uint64_t>() >= low &&
               value.get<std::uint64_t>() <= high;
    }

    static bool is_numbers(const json& value, int size)
    {
        if (!value.is_array() || value.size() != static_cast<std::size_t>(size))
            return false;
        for (const json& element : value)
            if (!element.is_number())
                return false;
        return true;
    }

    [[noreturn]] void fail(const std::string& place, const std::string& what) const
    {
        throw scene_error(document_.path, place, what + "; the file is damaged, export it again");
    }

    static constexpr std::uint64_t kLargest = std::uint64_t{1} << 53;

    const GltfDocument& document_;
    std::size_t index_limit_ = 0;
};

/// Every bufferView lies within the length its buffer declares.
void check_buffer_views(const GltfDocument& document)
{
    const json& root = document.json;
    for (std::size_t i = 0; i < array_size(root, "bufferViews"); ++i) {
        const json& view = root["bufferViews"][i];
        const auto offset = view.value("byteOffset", std::uint64_t{0});
        const auto length = view["byteLength"].get<std::uint64_t>();
        const json& buffer = root["buffers"][view["buffer"].get<std::size_t>()];
        const auto room = buffer["byteLength"].get<std::uint64_t>();
        if (offset > room || length > room - offset)
            throw scene_error(document.path, "bufferViews[" + std::to_string(i) + "]",
                              "runs past the end of its buffer; the file is damaged, export it "
                              "again");
    }
}

} // namespace

void check_gltf_schema(const GltfDocument& document)
{
    SchemaCheck check(document);
    for (const Rule& rule : kRules)
        check.apply(rule);
    check_buffer_views(document);
}

} // namespace hipmap
