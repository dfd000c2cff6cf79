#pragma once

#include <functional>
#include <iosfwd>
#include <optional>

namespace hipmap {

struct PreviousFrame;

/// Runs one command line of `render`: the arguments without the program, and what the previous
/// request of the same arguments left.  Returns the exit code.
using ServedRender = std::function<int(const std::vector<std::string>& words, PreviousFrame& kept)>;

/// Renders the command lines that come on `in`, a JSON array of words each, in order, until it
/// ends or a render is stopped by a signal.  While requests have the same words but the file of
/// --state, the photon maps and the image of the last one serve the next one as those of frames do.
/// After each it prints
/// {"event":"done","code":N} to `out` and "done" to standard error.  Returns the exit code of the
/// last one.  Throws InputError for a line that is no such array.
int serve(std::istream& in, std::ostream& out, const ServedRender& render);

} // namespace hipmap
