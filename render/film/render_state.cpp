#include "render/film/render_state.h"

#include "common/input_error.h"
#include "render/film/state_bytes.h"
#include "render/film/state_settings.h"

#include <algorithm>

namespace hipmap {

namespace {

constexpr int kMostSide = 65536;
/// The largest exponent of the scale of a film, that of any float.
constexpr int kMostScale = 200;

void put_rect(StateWriter& out, const PixelRect& pixels)
{
    for (const int edge : {pixels.x0, pixels.y0, pixels.x1, pixels.y1})
        out.put(edge);
}

void put_parts(StateWriter& out, const std::vector<FilmPart>& parts)
{
    out.put(static_cast<std::uint64_t>(parts.size()));
    for (const FilmPart& part : parts) {
        put_rect(out, part.pixels);
        out.put_array(part.passes.ranges);
    }
}

void put_film(StateWriter& out, const Film& film)
{
    out.put(film.width);
    out.put(film.height);
    out.put(film.place.x);
    out.put(film.place.y);
    out.put(film.place.whole_width);
    out.put(film.place.whole_height);
    out.put(film.scale);
    out.put(film.allocation);
    for (const RareLight& light : film.expected.light)
        for (const double value : {light.variance, light.missing, light.finds})
            out.put(value);
    out.put(static_cast<std::uint32_t>(film.bias));
    out.put_array(film.passes.ranges);
    put_parts(out, film.parts);
    out.put_sums(film.radiance);
    out.put_sums(film.narrow);
    out.put_sums(film.narrower);
    out.put(static_cast<std::uint8_t>(film.cut.empty() ? 0 : 1));
    out.put_sums(film.cut);
    out.put(static_cast<std::uint64_t>(film.lost.size()));
    for (const auto& [key, passes] : film.lost) {
        out.put(key);
        out.put(passes);
    }
    out.put(film.saturated);
}

void put_check(StateWriter& out, const ErrorCheck& check)
{
    const ImageError& error = check.error;
    out.put(check.passes);
    out.put(static_cast<std::uint32_t>(error.bias));
    for (const double value :
         {check.seconds, error.noise2, error.photon2, error.bias2, error.clamp2, error.removed2,
          error.missing2, error.order, error.error, error.low, error.high})
        out.put(value);
}

BiasKnowledge get_bias(StateReader& in)
{
    const auto bias = in.get<std::uint32_t>();
    in.require(bias <= static_cast<std::uint32_t>(BiasKnowledge::from_radii), "kind of bias");
    return static_cast<BiasKnowledge>(bias);
}

/// Reads sums that passes can have led to, so that more passes cannot overflow them.
std::vector<std::int64_t> get_sums(StateReader& in, const Film& film, std::uint64_t batches)
{
    const std::size_t channels = 3 * film.pixel_count();
    std::vector<std::int64_t> sums = in.get_sums(batches * channels);
    for (std::uint64_t batch = 0; batch < batches; ++batch) {
        const std::int64_t most =
            largest_value() * static_cast<std::int64_t>(count(film.passes, batches, batch));
        const auto first = sums.begin() + static_cast<std::ptrdiff_t>(batch * channels);
        in.require(std::all_of(first, first + static_cast<std::ptrdiff_t>(channels),
                               [most](std::int64_t sum) { return sum >= -most && sum <= most; }),
                   "sum");
    }
    return sums;
}

void get_lost(StateReader& in, Film& film)
{
    const auto size = in.get<std::uint64_t>();
    for (std::uint64_t i = 0; i < size; ++i) {
        const auto key = in.get<std::uint64_t>();
        const auto passes = in.get<std::uint32_t>();
        const bool ordered = film.lost.empty() || key > film.lost.rbegin()->first;
        in.require(ordered && key / kBatches < film.pixel_count() && passes > 0 &&
                       passes <= count(film.passes, kBatches, key % kBatches),
                   "lost sample");
        film.lost.emplace_hint(film.lost.end(), key, passes);
    }
}

/// Reads the place of an image of this size: within the whole image, unless it is whole.
ImagePlace get_place(StateReader& in, int width, int height)
{
    ImagePlace place;
    for (int* value : {&place.x, &place.y, &place.whole_width, &place.whole_height}) {
        *value = in.get<int>();
        in.require(*value >= 0 && *value <= kMostSide, "place of the image");
    }
    in.require(place == ImagePlace() ||
                   (place.x + width <= place.whole_width && place.y + height <= place.whole_height),
               "place of the image");
    return place;
}

PixelRect get_rect(StateReader& in)
{
    PixelRect out;
    for (int* edge : {&out.x0, &out.y0, &out.x1, &out.y1}) {
        *edge = in.get<int>();
        in.require(*edge >= 0 && *edge <= kMostSide, "rectangle of pixels");
    }
    return out;
}

/// Reads the parts of a film whose size and passes are known.
std::vector<FilmPart> get_parts(StateReader& in, const Film& film)
{
    const auto size = in.get<std::uint64_t>();
    in.require(size <= kMostFilmParts, "number of parts");
    std::vector<FilmPart> out;
    PassSet all;
    std::uint64_t left = kMostPasses; // ranges, of all parts
    for (std::uint64_t i = 0; i < size; ++i) {
        const PixelRect pixels = get_rect(in);
        out.push_back({pixels, {in.get_array<PassRange>(left)}});
        in.require(is_valid(out.back().passes), "passes of a part");
        left -= out.back().passes.ranges.size();
        all = united(all, out.back().passes);
    }
    const bool whole = size == 1 && out[0].pixels == PixelRect{0, 0, film.width, film.height};
    in.require(size == 0 ||
                   (are_valid(out, film.width, film.height) && all == film.passes && !whole),
               "part of the image");
    return out;
}

/// Reads the image that a film has tiles of.
PixelRect get_image(StateReader& in, const Film& film)
{
    const PixelRect image = get_rect(in), pixels = pixels_of(film);
    const bool inside = common_pixels(image, pixels) == pixels &&
                        image.x1 <= film.place.whole_width && image.y1 <= film.place.whole_height;
    in.require(image == PixelRect() || (inside && image != pixels), "image of a tile");
    return image;
}

Film get_film(StateReader& in)
{
    Film film;
    film.width = in.get<int>();
    film.height = in.get<int>();
    in.require(film.width > 0 && film.height > 0 && film.width <= kMostSide &&
                   film.height <= kMostSide,
               "image size");
    film.place = get_place(in, film.width, film.height);
    film.scale = in.get<int>();
    in.require(film.scale >= -kMostScale && film.scale <= kMostScale, "scale");
    film.allocation = in.get<std::uint64_t>();
    for (RareLight& light : film.expected.light)
        for (double* value : {&light.variance, &light.missing, &light.finds}) {
            *value = in.get<double>();
            in.require(*value >= 0 && std::isfinite(*value), "expected light");
        }
    film.bias = get_bias(in);
    film.passes.ranges = in.get_array<PassRange>(kMostPasses);
    in.require(is_valid(film.passes) && count(film.passes) <= kMostPasses, "set of passes");
    film.parts = get_parts(in, film);
    const std::uint64_t narrow = film.bias == BiasKnowledge::from_radii ? kNarrowBatches : 0;
    film.radiance = get_sums(in, film, kBatches);
    film.narrow = get_sums(in, film, narrow);
    film.narrower = get_sums(in, film, narrow);
    const auto clamped = in.get<std::uint8_t>();
    in.require(clamped <= 1, "clamping");
    film.cut = get_sums(in, film, clamped == 1 ? kNarrowBatches : 0);
    get_lost(in, film);
    film.saturated = in.get<std::uint64_t>();
    return film;
}

ErrorCheck get_check(StateReader& in)
{
    ErrorCheck check;
    check.passes = in.get<std::uint64_t>();
    in.require(check.passes > 0 && check.passes <= kMostPasses, "check");
    check.error.bias = get_bias(in);
    ImageError& error = check.error;
    for (double* value :
         {&check.seconds, &error.noise2, &error.photon2, &error.bias2, &error.clamp2,
          &error.removed2, &error.missing2, &error.order, &error.error, &error.low}) {
        *value = in.get<double>();
        in.require(std::isfinite(*value), "check");
    }
    error.high = in.get<double>();
    in.require(check.seconds >= 0 && error.error >= 0 && error.high >= 0, "check");
    return check;
}

RenderState unpack(StateReader& in)
{
    RenderState state;
    state.label = get_text(in);
    state.settings = get_settings(in);
    state.photons_per_pass = in.get<std::uint64_t>();
    state.radius_decay = in.get<double>();
    in.require(state.radius_decay > 0 && state.radius_decay < 1, "radius decay");
    state.film = get_film(in);
    state.image = get_image(in, state.film);
    const auto checks = in.get<std::uint64_t>();
    in.require(checks <= kMostPasses, "number of checks");
    for (std::uint64_t i = 0; i < checks; ++i)
        state.checks.push_back(get_check(in));
    state.seconds = in.get<double>();
    in.require(state.seconds >= 0 && std::isfinite(state.seconds), "time");
    in.require(in.at_end(), "length");
    return state;
}

std::string text_of_tile(const RenderState& state)
{
    if (state.image.empty())
        return "";
    const PixelRect pixels = pixels_of(state.film);
    return " of the tile at " + std::to_string(pixels.x0) + "," + std::to_string(pixels.y0);
}

/// Returns the checks of two films of the same pixels and disjoint passes that are of the first
/// passes of both together.
std::vector<ErrorCheck> common_checks(const RenderState& a, const RenderState& b)
{
    if (pixels_of(a.film) != pixels_of(b.film) || !a.film.parts.empty() || !b.film.parts.empty())
        return {};
    const auto& of_a = a.film.passes.ranges;
    const auto& of_b = b.film.passes.ranges;
    if (of_a.empty() || of_b.empty())
        return of_a.empty() ? b.checks : a.checks;
    const bool begins = of_a[0].first < of_b[0].first;
    const PassRange first = begins ? of_a[0] : of_b[0];
    std::vector<ErrorCheck> kept = begins ? a.checks : b.checks;
    std::erase_if(
        kept, [first](const ErrorCheck& check) { return check.passes > first.end - first.first; });
    return kept;
}

} // namespace

void look_at_error(FireflyChoice fireflies, RenderState& state)
{
    const std::uint64_t passes = count(state.film.passes);
    if (!state.checks.empty() && state.checks.back().passes >= passes)
        return;
    if (const std::optional<ImageError> error = error_of_shown(fireflies, state.film))
        state.checks.push_back({passes, state.seconds, *error});
}

void look_again(FireflyChoice fireflies, RenderState& state)
{
    if (state.checks.empty() || state.checks.back().passes != count(state.film.passes))
        return;
    state.checks.pop_back();
    look_at_error(fireflies, state);
}

bool error_is_met(const RenderState& state, double error)
{
    const std::uint64_t passes = count(state.film.passes);
    return error > 0 && !state.checks.empty() && state.checks.back().passes == passes &&
           passes >= kFewestBatches && state.checks.back().error.error <= error;
}

void write_state(const std::filesystem::path& path, const RenderState& state)
{
    if (state.film.parts.size() > kMostFilmParts)
        throw InputError(path.string() + ": the tiles of its image hold " +
                         std::to_string(state.film.parts.size()) +
                         " different sets of passes, and a "
                         "state has at most " +
                         std::to_string(kMostFilmParts) +
                         "; render the tiles that are missing first");
    StateWriter out(path, kStateVersion);
    put_text(out, state.label);
    put_settings(out, state.settings);
    out.put(state.photons_per_pass);
    out.put(state.radius_decay);
    put_film(out, state.film);
    put_rect(out, state.image);
    out.put(static_cast<std::uint64_t>(state.checks.size()));
    for (const ErrorCheck& check : state.checks)
        put_check(out, check);
    out.put(state.seconds);
    out.finish();
}

RenderState read_state(const std::filesystem::path& path)
{
    StateReader in(path);
    if (in.version() != kStateVersion)
        throw OtherState(path.string() + ": state file of format " + std::to_string(in.version()) +
                             ", and this render reads format " + std::to_string(kStateVersion),
                         "use the version that wrote it, or another file name");
    in.begin();
    return unpack(in);
}

void check_settings(const std::filesystem::path& path, const std::vector<Setting>& found,
                    const std::vector<Setting>& wanted)
{
    for (std::size_t i = 0; i < std::max(found.size(), wanted.size()); ++i) {
        const std::string has = i < found.size() ? text_of(found[i]) : "nothing";
        const std::string wants = i < wanted.size() ? text_of(wanted[i]) : "nothing";
        if (has != wants)
            throw OtherState(path.string() + ": holds passes with " + has + ", not " + wants,
                             "use the scene and options that it was started with, or another file");
    }
}

PixelRect image_of(const RenderState& state)
{
    return state.image.empty() ? pixels_of(state.film) : state.image;
}

RenderState begin_merge(const RenderState& tile)
{
    const Film& film = tile.film;
    const PixelRect image = image_of(tile);
    RenderState out;
    out.label = tile.label;
    out.settings = tile.settings;
    out.photons_per_pass = tile.photons_per_pass;
    out.radius_decay = tile.radius_decay;
    out.film = empty_like(film, image.width(), image.height());
    if (!tile.image.empty()) {
        const int width = film.place.whole_width, height = film.place.whole_height;
        const bool whole = image.width() == width && image.height() == height;
        out.film.place = whole ? ImagePlace{} : ImagePlace{image.x0, image.y0, width, height};
    }
    return out;
}

InputError other_film(const std::filesystem::path& path)
{
    return InputError(path.string() + ": its image has another size, place or unit, or another "
                                      "allocation of samples; render it again");
}

void merge_state(RenderState& into, const RenderState& from, const std::filesystem::path& path)
{
    check_settings(path, from.settings, into.settings);
    const Film& film = from.film;
    const PixelRect pixels = pixels_of(film), all = pixels_of(into.film);
    if (image_of(from) != image_of(into) || common_pixels(pixels, all) != pixels ||
        film.scale != into.film.scale || film.allocation != into.film.allocation ||
        film.bias != into.film.bias || film.cut.empty() != into.film.cut.empty())
        throw other_film(path);
    const auto common = common_pass(moved(parts_of(film), pixels.x0, pixels.y0),
                                    moved(parts_of(into.film), all.x0, all.y0));
    if (common)
        throw InputError(path.string() + ": pass " + std::to_string(common->pass) +
                         text_of_tile(from) +
                         " is in another state too; render different passes with --first-pass");
    if (count(united(into.film.passes, film.passes)) > kMostPasses)
        throw InputError(path.string() + ": more than " + std::to_string(kMostPasses) +
                         " passes in all; merge fewer states");
    into.checks = common_checks(into, from);
    merge_film(into.film, film);
    into.seconds += from.seconds;
    into.label = std::min(into.label, from.label);
}

} // namespace hipmap
