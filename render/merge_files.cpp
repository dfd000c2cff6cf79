#include "render/merge_files.h"

#include "common/input_error.h"

#include <tbb/parallel_pipeline.h>

#include <algorithm>

namespace hipmap {

namespace {

constexpr std::size_t kStatesInMemory = 4;

struct StateFile {
    std::filesystem::path path;
    bool found = false; ///< in a folder
};

/// A state that was read, or why it was not.
struct ReadState {
    StateFile file;
    RenderState state;
    std::string problem;
};

/// The passes that a merged file holds, in pixels of the whole image.
struct HeldByFile {
    std::filesystem::path path;
    std::vector<FilmPart> parts;
};

std::vector<StateFile> files_in(const std::filesystem::path& folder)
{
    std::vector<StateFile> out;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().extension() == ".state" && entry.is_regular_file())
            out.push_back({entry.path(), true});
    std::ranges::sort(out, {}, &StateFile::path);
    if (out.empty())
        throw InputError(folder.string() + ": has no file FILE.state; name the states, or render "
                                           "some with --state");
    return out;
}

std::vector<StateFile> files_of(const std::vector<std::filesystem::path>& named)
{
    std::vector<StateFile> out;
    for (const std::filesystem::path& path : named) {
        if (!std::filesystem::is_directory(path)) {
            out.push_back({path, false});
            continue;
        }
        const std::vector<StateFile> more = files_in(path);
        out.insert(out.end(), more.begin(), more.end());
    }
    return out;
}

ReadState read_file_of(const StateFile& file)
{
    ReadState out{file, {}, {}};
    try {
        out.state = read_state(file.path);
    } catch (const OtherState&) {
        throw;
    } catch (const InputError& error) {
        if (!file.found)
            throw;
        out.problem = error.what();
    }
    return out;
}

/// Throws InputError if a file that was merged has a pass of a pixel that `one` has too.
void check_overlap(const std::vector<HeldByFile>& held, const HeldByFile& one)
{
    for (const HeldByFile& other : held)
        if (const auto common = common_pass(other.parts, one.parts))
            throw InputError(one.path.string() + ": pass " + std::to_string(common->pass) +
                             " of pixel " + std::to_string(common->pixels.x0) + "," +
                             std::to_string(common->pixels.y0) + " is in " + other.path.string() +
                             " too; leave one out, or render different passes with --first-pass");
}

void add(const ReadState& read, std::vector<HeldByFile>& held, MergedFiles& into)
{
    if (!read.problem.empty()) {
        into.left_out.push_back(read.problem);
        return;
    }
    const Film& film = read.state.film;
    if (into.files.empty())
        into.state = begin_merge(read.state);
    const HeldByFile one = {read.file.path,
                            moved(parts_of(film), pixels_of(film).x0, pixels_of(film).y0)};
    check_settings(one.path, read.state.settings, into.state.settings);
    check_overlap(held, one);
    merge_state(into.state, read.state, one.path);
    into.files.push_back(one.path);
    held.push_back(one);
}

} // namespace

MergedFiles merge_files(const std::vector<std::filesystem::path>& named, FireflyChoice fireflies)
{
    using tbb::filter_mode;
    const std::vector<StateFile> files = files_of(named);
    MergedFiles out;
    std::vector<HeldByFile> held;
    std::size_t next = 0;
    tbb::parallel_pipeline(
        kStatesInMemory,
        tbb::make_filter<void, StateFile>(filter_mode::serial_in_order,
                                          [&](tbb::flow_control& control) {
                                              if (next == files.size()) {
                                                  control.stop();
                                                  return StateFile();
                                              }
                                              return files[next++];
                                          }) &
            tbb::make_filter<StateFile, ReadState>(
                filter_mode::parallel, [](const StateFile& file) { return read_file_of(file); }) &
            tbb::make_filter<ReadState, void>(
                filter_mode::serial_in_order,
                [&](const ReadState& read) { add(read, held, out); }));
    if (out.files.empty())
        throw InputError(out.left_out[0]);
    if (count(out.state.film.passes) == 0)
        throw InputError(out.files[0].string() + ": has no passes yet; render some first");
    look_again(fireflies, out.state);
    look_at_error(fireflies, out.state);
    return out;
}

} // namespace hipmap
