#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace hipmap {

/// The text of an OBJ file, checked as far as tinyobjloader does not.
struct ObjText {
    std::string text;                       ///< without line continuations; one line per line
    std::vector<std::string> material_libs; ///< what the mtllib lines say
    std::size_t short_faces = 0;            ///< faces of fewer than three corners
    bool has_colours = false;               ///< on vertices
    bool has_lines_or_points = false;
    bool has_curves = false;
    bool has_objects = false; ///< 'o' lines
};

/// Reads an OBJ file and checks every number of its v, vn and vt lines and every index of its f
/// lines.  Throws InputError with the line: a number that is not one or not finite, an index that
/// is 0 or out of range.  Cost: linear in the file.
ObjText read_obj_text(const std::filesystem::path& path);

} // namespace hipmap
