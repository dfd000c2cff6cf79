#pragma once

namespace hipmap {

/// What a property of a glTF file must be.
enum class GltfWant {
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
struct GltfRule {
    const char* path;
    GltfWant want;
    bool required = false;
    const char* target = "";
    int size = 0;
};

inline constexpr const char* kGltfLights = "extensions/KHR_lights_punctual/lights";

// A container's rule comes before those of its contents.
inline constexpr GltfRule kGltfRules[] = {
    {"extensionsUsed", GltfWant::array},
    {"extensionsUsed/[]", GltfWant::string},
    {"extensionsRequired", GltfWant::array},
    {"extensionsRequired/[]", GltfWant::string},
    {"extensions", GltfWant::object},
    {"extensions/KHR_lights_punctual", GltfWant::object},
    {kGltfLights, GltfWant::array},
    {"extensions/KHR_lights_punctual/lights/[]", GltfWant::object},
    {"extensions/KHR_lights_punctual/lights/[]/type", GltfWant::string, true},
    {"extensions/KHR_lights_punctual/lights/[]/name", GltfWant::string},
    {"extensions/KHR_lights_punctual/lights/[]/color", GltfWant::numbers, false, "", 3},
    {"extensions/KHR_lights_punctual/lights/[]/intensity", GltfWant::number},
    {"extensions/KHR_lights_punctual/lights/[]/range", GltfWant::number},
    {"extensions/KHR_lights_punctual/lights/[]/spot", GltfWant::object},
    {"extensions/KHR_lights_punctual/lights/[]/spot/innerConeAngle", GltfWant::number},
    {"extensions/KHR_lights_punctual/lights/[]/spot/outerConeAngle", GltfWant::number},

    {"buffers", GltfWant::array},
    {"buffers/[]", GltfWant::object},
    {"buffers/[]/byteLength", GltfWant::count, true},
    {"buffers/[]/uri", GltfWant::string},
    {"bufferViews", GltfWant::array},
    {"bufferViews/[]", GltfWant::object},
    {"bufferViews/[]/buffer", GltfWant::index, true, "buffers"},
    {"bufferViews/[]/byteOffset", GltfWant::offset},
    {"bufferViews/[]/byteLength", GltfWant::count, true},
    {"bufferViews/[]/byteStride", GltfWant::integer_to, false, "", 252},
    {"accessors", GltfWant::array},
    {"accessors/[]", GltfWant::object},
    {"accessors/[]/bufferView", GltfWant::index, false, "bufferViews"},
    {"accessors/[]/byteOffset", GltfWant::offset},
    {"accessors/[]/componentType", GltfWant::count, true},
    {"accessors/[]/count", GltfWant::count, true},
    {"accessors/[]/type", GltfWant::string, true},
    {"accessors/[]/normalized", GltfWant::boolean},
    {"accessors/[]/sparse", GltfWant::object},
    {"accessors/[]/sparse/count", GltfWant::count, true},
    {"accessors/[]/sparse/indices", GltfWant::object, true},
    {"accessors/[]/sparse/indices/bufferView", GltfWant::index, true, "bufferViews"},
    {"accessors/[]/sparse/indices/byteOffset", GltfWant::offset},
    {"accessors/[]/sparse/indices/componentType", GltfWant::count, true},
    {"accessors/[]/sparse/values", GltfWant::object, true},
    {"accessors/[]/sparse/values/bufferView", GltfWant::index, true, "bufferViews"},
    {"accessors/[]/sparse/values/byteOffset", GltfWant::offset},

    {"images", GltfWant::array},
    {"images/[]", GltfWant::object},
    {"images/[]/bufferView", GltfWant::index, false, "bufferViews"},
    {"images/[]/uri", GltfWant::string},
    {"samplers", GltfWant::array},
    {"textures", GltfWant::array},
    {"textures/[]", GltfWant::object},
    {"textures/[]/source", GltfWant::index, false, "images"},
    {"textures/[]/sampler", GltfWant::index, false, "samplers"},

    {"materials", GltfWant::array},
    {"materials/[]", GltfWant::object},
    {"materials/[]/name", GltfWant::string},
    {"materials/[]/doubleSided", GltfWant::boolean},
    {"materials/[]/alphaMode", GltfWant::string},
    {"materials/[]/alphaCutoff", GltfWant::number},
    {"materials/[]/emissiveFactor", GltfWant::numbers, false, "", 3},
    {"materials/[]/emissiveTexture", GltfWant::object},
    {"materials/[]/emissiveTexture/index", GltfWant::index, true, "textures"},
    {"materials/[]/normalTexture", GltfWant::object},
    {"materials/[]/normalTexture/index", GltfWant::index, true, "textures"},
    {"materials/[]/occlusionTexture", GltfWant::object},
    {"materials/[]/occlusionTexture/index", GltfWant::index, true, "textures"},
    {"materials/[]/pbrMetallicRoughness", GltfWant::object},
    {"materials/[]/pbrMetallicRoughness/baseColorFactor", GltfWant::numbers, false, "", 4},
    {"materials/[]/pbrMetallicRoughness/metallicFactor", GltfWant::number},
    {"materials/[]/pbrMetallicRoughness/roughnessFactor", GltfWant::number},
    {"materials/[]/pbrMetallicRoughness/baseColorTexture", GltfWant::object},
    {"materials/[]/pbrMetallicRoughness/baseColorTexture/index", GltfWant::index, true, "textures"},
    {"materials/[]/pbrMetallicRoughness/metallicRoughnessTexture", GltfWant::object},
    {"materials/[]/pbrMetallicRoughness/metallicRoughnessTexture/index", GltfWant::index, true,
     "textures"},
    {"materials/[]/extensions", GltfWant::object},
    {"materials/[]/extensions/{}", GltfWant::object},
    {"materials/[]/extensions/KHR_materials_emissive_strength/emissiveStrength", GltfWant::number},
    {"materials/[]/extensions/KHR_materials_transmission/transmissionFactor", GltfWant::number},
    {"materials/[]/extensions/KHR_materials_ior/ior", GltfWant::number},
    {"materials/[]/extensions/KHR_materials_specular/specularFactor", GltfWant::number},
    {"materials/[]/extensions/KHR_materials_specular/specularColorFactor", GltfWant::numbers, false,
     "", 3},
    {"materials/[]/extensions/KHR_materials_volume/attenuationDistance", GltfWant::number},
    {"materials/[]/extensions/KHR_materials_volume/attenuationColor", GltfWant::numbers, false, "",
     3},

    {"meshes", GltfWant::array},
    {"meshes/[]", GltfWant::object},
    {"meshes/[]/name", GltfWant::string},
    {"meshes/[]/primitives", GltfWant::filled_array, true},
    {"meshes/[]/primitives/[]", GltfWant::object},
    {"meshes/[]/primitives/[]/attributes", GltfWant::object, true},
    {"meshes/[]/primitives/[]/attributes/{}", GltfWant::index, false, "accessors"},
    {"meshes/[]/primitives/[]/indices", GltfWant::index, false, "accessors"},
    {"meshes/[]/primitives/[]/material", GltfWant::index, false, "materials"},
    {"meshes/[]/primitives/[]/mode", GltfWant::integer_to, false, "", 6},
    {"meshes/[]/primitives/[]/targets", GltfWant::array},
    {"meshes/[]/primitives/[]/targets/[]", GltfWant::object},
    {"meshes/[]/primitives/[]/targets/[]/{}", GltfWant::index, false, "accessors"},
    {"meshes/[]/primitives/[]/extensions", GltfWant::object},

    {"cameras", GltfWant::array},
    {"cameras/[]", GltfWant::object},
    {"cameras/[]/name", GltfWant::string},
    {"cameras/[]/type", GltfWant::string, true},
    {"cameras/[]/perspective", GltfWant::object},
    {"cameras/[]/perspective/yfov", GltfWant::number, true},
    {"cameras/[]/perspective/znear", GltfWant::number, true},
    {"cameras/[]/perspective/zfar", GltfWant::number},
    {"cameras/[]/perspective/aspectRatio", GltfWant::number},
    {"cameras/[]/orthographic", GltfWant::object},
    {"cameras/[]/orthographic/xmag", GltfWant::number, true},
    {"cameras/[]/orthographic/ymag", GltfWant::number, true},
    {"cameras/[]/orthographic/znear", GltfWant::number, true},
    {"cameras/[]/orthographic/zfar", GltfWant::number, true},

    {"skins", GltfWant::array},
    {"animations", GltfWant::array},
    {"nodes", GltfWant::array},
    {"nodes/[]", GltfWant::object},
    {"nodes/[]/name", GltfWant::string},
    {"nodes/[]/children", GltfWant::array},
    {"nodes/[]/children/[]", GltfWant::index, false, "nodes"},
    {"nodes/[]/mesh", GltfWant::index, false, "meshes"},
    {"nodes/[]/camera", GltfWant::index, false, "cameras"},
    {"nodes/[]/skin", GltfWant::index, false, "skins"},
    {"nodes/[]/translation", GltfWant::numbers, false, "", 3},
    {"nodes/[]/rotation", GltfWant::numbers, false, "", 4},
    {"nodes/[]/scale", GltfWant::numbers, false, "", 3},
    {"nodes/[]/matrix", GltfWant::numbers, false, "", 16},
    {"nodes/[]/extensions", GltfWant::object},
    {"nodes/[]/extensions/{}", GltfWant::object},
    {"nodes/[]/extensions/KHR_lights_punctual/light", GltfWant::index, true, kGltfLights},
    {"scenes", GltfWant::array},
    {"scenes/[]", GltfWant::object},
    {"scenes/[]/name", GltfWant::string},
    {"scenes/[]/nodes", GltfWant::array},
    {"scenes/[]/nodes/[]", GltfWant::index, false, "nodes"},
    {"scene", GltfWant::index, false, "scenes"},
};

} // namespace hipmap
