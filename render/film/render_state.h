#pragma once

#include "common/input_error.h"
#include "common/setting.h"
#include "render/film/error_cost.h"
#include "render/film/fireflies.h"

#include <filesystem>
#include <string>

namespace hipmap {

/// The version of the format of states.
inline constexpr std::uint32_t kStateVersion = 9;

/// Everything needed to resume a render, or to merge it with others; docs/error.md.
struct RenderState {
    /// What a person calls the image: scene file and frame, in printable ASCII.  Nothing depends on
    /// it.
    std::string label;
    /// What makes its passes: scene, partition, options.  States that differ in one hold passes of
    /// different images.
    std::vector<Setting> settings;
    std::uint64_t photons_per_pass = 0; ///< light paths; costs count them
    double radius_decay = 2.0 / 3;      ///< alpha of docs/error.md (1), by which costs extrapolate
    PixelRect image; ///< that tiles make up, of which the film holds some; empty: the film's pixels
    Film film;
    std::vector<ErrorCheck> checks; ///< by passes, each of so many of the film's first
    double seconds = 0;             ///< spent on its passes
    bool operator==(const RenderState&) const = default;
};

/// Records the error of the image that the film shows, unless it was already recorded at this
/// number of passes.
void look_at_error(FireflyChoice fireflies, RenderState& state);

/// Replaces the error recorded at this number of passes, if there is one: an earlier run may have
/// shown an image of the other choice.
void look_again(FireflyChoice fireflies, RenderState& state);

/// Returns whether the error recorded after the last pass is at most `error` and has an interval.
/// error: 0: none is asked for, and none is met.
bool error_is_met(const RenderState& state, double error);

/// Writes a state to a temporary name, syncs and renames it: if the program is killed, the old
/// state or the new one is there.  Throws InputError if the file cannot be written.
void write_state(const std::filesystem::path& path, const RenderState& state);

/// Reports a state that is whole, but of another render or another version of the format.
class OtherState : public InputError {
  public:
    OtherState(const std::string& what_differs, const std::string& cure)
        : InputError(what_differs + "; " + cure), difference(what_differs)
    {
    }
    const std::string difference; ///< the line without the cure
};

/// Reads a state and checks every value in it.  Throws InputError: no such file, damaged;
/// OtherState: another version of the format.
RenderState read_state(const std::filesystem::path& path);

/// Throws OtherState, naming `path` and the first setting that differs, unless both are the same.
void check_settings(const std::filesystem::path& path, const std::vector<Setting>& found,
                    const std::vector<Setting>& wanted);

/// Returns the pixels of the image that a state is for, in the whole image.
PixelRect image_of(const RenderState& state);

/// Makes a state of the same image as `tile`, of all its pixels and without passes.
RenderState begin_merge(const RenderState& tile);

/// The error for a state whose film cannot be added to that of the render.
InputError other_film(const std::filesystem::path& path);

/// Adds the passes of `from`, read from `path`, to those of `into`, whose film holds its pixels:
/// the same bits in any order of merging.  Of the checks it keeps those of the first passes of the
/// merged film.  Throws InputError, naming `path`: other settings, or a pass that both have of a
/// pixel.
void merge_state(RenderState& into, const RenderState& from, const std::filesystem::path& path);

} // namespace hipmap
