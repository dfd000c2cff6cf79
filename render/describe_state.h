#pragma once

#include "render/film/render_state.h"

#include <optional>
#include <string>

namespace hipmap {

/// Formats passes: "0-15", "0-7,12"; "none" for none.
std::string text_of(const PassSet& passes);

/// Describes a state in a line: its image, its pixels, its passes and its error.
std::string describe_state(const RenderState& state);

/// Returns the pixels of the whole image that lack passes, and which.  passes: how many there
/// should be, from 0; none: all between the first and the last that any pixel holds.
std::vector<FilmPart> missing_from(const RenderState& state, std::optional<std::uint64_t> passes);

/// Describes the passes that some pixels lack, and how to render them.
std::string describe_missing(const FilmPart& missing, const RenderState& state);

/// Returns the share of the pixels that hold passes of two batches, whose error is known.
double known_share(const Film& film);

} // namespace hipmap
