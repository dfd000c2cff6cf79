#pragma once

#include "tests/support/gltf_file.h"

namespace hipmap::tiny {

/// A tetrahedron with corners at the origin and one along each axis, wound outwards; node 0,
/// mesh 0, material 0.
inline GltfFile tetrahedron_file()
{
    GltfFile file;
    const int positions = file.add_vectors({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1});
    const int indices = file.add_indices({0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3});
    file.root["materials"] = {{{"name", "paint"}}};
    file.root["meshes"] = {
        {{"name", "tetrahedron"},
         {"primitives",
          {{{"attributes", {{"POSITION", positions}}}, {"indices", indices}, {"material", 0}}}}}};
    file.root["nodes"] = {{{"name", "thing"}, {"mesh", 0}}};
    return file;
}

/// Whether some sentence contains the text.
inline bool says(const std::vector<std::string>& sentences, const std::string& text)
{
    for (const std::string& sentence : sentences)
        if (sentence.find(text) != std::string::npos)
            return true;
    return false;
}

} // namespace hipmap::tiny
