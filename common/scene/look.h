#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace hipmap {

struct Material;

/// What images of a scene should look like: what glTF specifies, or what Cycles in a range of
/// Blender's versions shows.  docs/cycles.md lists the differences.
enum class Look : std::uint8_t {
    gltf,
    blender_3_4, ///< to 3.4
    blender_3_6, ///< 3.5 and 3.6
    blender_4,   ///< from 4.0
};

/// What was asked for.
enum class LookChoice : std::uint8_t {
    automatic, ///< of the program that wrote the file
    gltf,
    blender,  ///< of the Blender that wrote the file; of Blender 4 for files by other programs
    blender3, ///< of that Blender if older than 4; of Blender 3.4 for all other files
};

/// Returns the look of the Blender that wrote a file.  generator: `asset.generator` of glTF.
/// Nothing for files by other programs.  The exporter has Blender's version number since 3.2, and
/// lower ones before.
std::optional<Look> look_of_generator(std::string_view generator);

/// Returns the look that follows from what was asked for and the program that wrote the file.
Look choose_look(LookChoice asked, std::string_view generator);

/// Returns a choice that gives this look for the file that has it.
LookChoice choice_of(Look look);

/// Returns a sentence for the audit about a look other than glTF's.
std::string describe_look(Look look);

inline bool is_blender(Look look)
{
    return look != Look::gltf;
}

/// Returns whether Blender is older than 4, whose Principled BSDF is another one.
inline bool is_before_blender_4(Look look)
{
    return look == Look::blender_3_4 || look == Look::blender_3_6;
}

/// Sets the parts of a material that no file has and that follow from the look.
void shade_like(Look look, Material& material);

} // namespace hipmap
