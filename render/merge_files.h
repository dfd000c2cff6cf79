#pragma once

#include "render/film/render_state.h"

#include <filesystem>
#include <vector>

namespace hipmap {

/// States of one image put together.
struct MergedFiles {
    RenderState state;
    std::vector<std::filesystem::path> files; ///< that are in it
    std::vector<std::string> left_out; ///< why a damaged file of a folder is not, a line each
};

/// Reads states and puts them together.  named: files, or folders, of which all files FILE.state
/// are taken, in order of their names.  fireflies: in the image whose error is recorded.  Reads in
/// parallel and holds the film of the image and at most four states at a time, however many there
/// are; the order changes no bit.  A damaged file is left out if its folder was named.  Throws
/// InputError: no state, a damaged one that was named itself, states of different images, a pass of
/// a pixel that two of them have, no pass in all of them.
MergedFiles merge_files(const std::vector<std::filesystem::path>& named, FireflyChoice fireflies);

} // namespace hipmap
