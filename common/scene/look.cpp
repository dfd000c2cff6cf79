#include "common/scene/look.h"

#include "common/scene/scene.h"

#include <cstdio>

namespace hipmap {

std::optional<Look> look_of_generator(std::string_view generator)
{
    int major = 0, minor = 0;
    const std::string text(generator);
    if (std::sscanf(text.c_str(), "Khronos glTF Blender I/O v%d.%d", &major, &minor) != 2)
        return std::nullopt;
    if (major >= 4)
        return Look::blender_4;
    return major == 3 && minor >= 5 ? Look::blender_3_6 : Look::blender_3_4;
}

Look choose_look(LookChoice asked, std::string_view generator)
{
    const std::optional<Look> written = look_of_generator(generator);
    switch (asked) {
    case LookChoice::gltf:
        return Look::gltf;
    case LookChoice::blender:
        return written.value_or(Look::blender_4);
    case LookChoice::blender3:
        return written && is_before_blender_4(*written) ? *written : Look::blender_3_4;
    case LookChoice::automatic:
        break;
    }
    return written.value_or(Look::gltf);
}

LookChoice choice_of(Look look)
{
    if (look == Look::gltf)
        return LookChoice::gltf;
    return is_before_blender_4(look) ? LookChoice::blender3 : LookChoice::blender;
}

std::string describe_look(Look look)
{
    const std::string versions = look == Look::blender_4     ? "4 and later"
                                 : look == Look::blender_3_6 ? "3.5 and 3.6"
                                                             : "up to 3.4";
    return "materials and lights look as in Cycles of Blender " + versions +
           " (--look gltf: as glTF specifies)";
}

void shade_like(Look look, Material& material)
{
    material.diffuse_model =
        is_before_blender_4(look) ? DiffuseModel::burley : DiffuseModel::lambert;
    material.coat_adds = is_before_blender_4(look);
    material.tint_by_root = look == Look::blender_4;
    material.energy_compensation = look == Look::blender_4;
}

} // namespace hipmap
