#include "common/file/output_file.h"
#include "common/input_error.h"
#include "render/film/render_state.h"
#include "tests/render/film/synthetic_passes.h"
#include "tests/support/temporary_folder.h"

#include <catch2/catch.hpp>

#include <functional>

using namespace hipmap;

namespace {

RenderState state_of(std::uint64_t first, std::uint64_t end, bool radii = true)
{
    SyntheticPasses passes;
    passes.side = 6;
    passes.radii = radii;
    RenderState state;
    state.settings = {{"scene", "0123"},
                      {"photons", std::uint64_t{1000}},
                      {"alpha", 0.5},
                      {"caustics", true},
                      {"sky", {}}};
    state.photons_per_pass = 1000;
    state.radius_decay = 0.5;
    state.film = make_film(6, 6, 1, radii ? BiasKnowledge::from_radii : BiasKnowledge::unbiased);
    add_light({.variance = 0.5, .missing = 0.02, .finds = 0.01}, state.film.expected);
    for (std::uint64_t pass = first; pass < end; ++pass) {
        PassImages images = passes.pass(pass);
        images.kept[pass % 36] = 0;
        add_pass(state.film, pass, images);
    }
    if (const auto error = estimate_error(state.film))
        state.checks.push_back({end - first, 1.5, *error});
    state.seconds = 2.5;
    return state;
}

std::string refusal(const std::function<void()>& body)
{
    try {
        body();
    } catch (const InputError& error) {
        return error.what();
    }
    return "nothing was refused";
}

} // namespace

TEST_CASE("render state: what is read is what was written", "[film]")
{
    const TemporaryFolder folder;
    for (const bool radii : {false, true})
        for (const std::uint64_t end : {3, 4, 5, 20}) {
            const RenderState state = state_of(3, end, radii);
            write_state(folder / "a.state", state);
            CHECK(read_state(folder / "a.state") == state);
        }
    RenderState clamped = state_of(0, 9, false);
    clamped.film.cut.assign(kNarrowBatches * 3 * 36, 5);
    write_state(folder / "a.state", clamped);
    CHECK(read_state(folder / "a.state") == clamped);
    CHECK_THAT(refusal([&] { merge_state(clamped, state_of(9, 12, false), "b"); }),
               Catch::Contains("another size"));
    CHECK(folder.file_count() == 1);
}

TEST_CASE("render state: tiles keep their place, and what is put together of them its parts",
          "[film]")
{
    const TemporaryFolder folder;
    RenderState tile = state_of(0, 3);
    tile.label = "room.glb, frame 3";
    tile.film.place = {6, 2, 12, 8};
    tile.image = {0, 0, 12, 8};
    RenderState merged = begin_merge(tile);
    CHECK(merged.film.place == ImagePlace());
    merge_state(merged, tile, "a");
    CHECK(merged.film.parts == std::vector<FilmPart>{{{6, 2, 12, 8}, {{{0, 3}}}}});
    CHECK_THAT(refusal([&] { merge_state(merged, tile, "b"); }),
               Catch::Contains("b: pass 0 of the tile at 6,2 is in another"));
    for (const RenderState& state : {tile, merged}) {
        write_state(folder / "a.state", state);
        CHECK(read_state(folder / "a.state") == state);
    }
    RenderState other = tile;
    other.image = {0, 0, 12, 7};
    CHECK_THAT(refusal([&] { merge_state(merged, other, "b"); }), Catch::Contains("another size"));
    other = begin_merge(merged); // of what was put together
    merge_state(other, merged, "c");
    CHECK(other.film == merged.film);
}

TEST_CASE("render state: damaged files are refused, whatever the damage", "[film]")
{
    const TemporaryFolder folder;
    write_state(folder / "a.state", state_of(0, 9));
    const std::vector<std::byte> whole = read_file(folder / "a.state");
    const auto read_bytes = [&](const std::vector<std::byte>& bytes) {
        write_file(folder / "b.state", bytes);
        return refusal([&] { read_state(folder / "b.state"); });
    };
    for (std::size_t length = 0; length < whole.size(); length += 1 + length / 8)
        CHECK_THAT(read_bytes({whole.begin(), whole.begin() + static_cast<long>(length)}),
                   Catch::Contains("b.state"));
    for (std::size_t at = 0; at < whole.size(); at += 1 + at / 8) {
        std::vector<std::byte> changed = whole;
        changed[at] ^= std::byte{0x10};
        CHECK_THAT(read_bytes(changed), Catch::Contains("b.state"));
    }
    std::vector<std::byte> longer = whole;
    longer.push_back(std::byte{0});
    CHECK_THAT(read_bytes(longer), Catch::Contains("checksum"));
    CHECK_THAT(refusal([&] { read_state(folder / "none"); }), Catch::Contains("none"));
}

TEST_CASE("render state: values no render writes are refused, though the checksum is right",
          "[film]")
{
    const TemporaryFolder folder;
    const std::vector<std::function<void(RenderState&)>> spoilers = {
        [](RenderState& state) { state.film.width = 0; },
        [](RenderState& state) { state.film.width = -6, state.film.height = -6; },
        [](RenderState& state) { state.film.height = 7; },
        [](RenderState& state) { state.film.width = 1 << 30; },
        [](RenderState& state) { state.film.scale = std::numeric_limits<int>::min(); },
        [](RenderState& state) { state.film.bias = static_cast<BiasKnowledge>(9); },
        [](RenderState& state) { state.film.bias = BiasKnowledge::unbiased; },
        [](RenderState& state) {
            state.film.passes.ranges = {{0, 4}, {3, 9}};
        },
        [](RenderState& state) {
            state.film.passes.ranges = {{0, kMostPasses + 1}};
        },
        [](RenderState& state) { state.film.expected.light[2].missing = -1; },
        [](RenderState& state) { state.film.expected.light.back().finds = std::nan(""); },
        [](RenderState& state) { state.film.radiance[5] = 3 * largest_value(); },
        [](RenderState& state) { state.film.radiance.back() = -3 * largest_value(); },
        [](RenderState& state) { state.film.narrow.pop_back(); },
        [](RenderState& state) { state.film.cut.push_back(0); },
        [](RenderState& state) { state.film.lost[36 * kBatches] = 1; },
        [](RenderState& state) { state.film.lost[2] = 100; },
        [](RenderState& state) { state.film.lost[2] = 0; },
        [](RenderState& state) { state.settings[0].name = "scene\n"; },
        [](RenderState& state) { state.label = "r\x80m"; },
        [](RenderState& state) {
            state.image = {0, 0, 9, 9};
        },
        [](RenderState& state) {
            state.film.place = {1, 1, 9, 9};
            state.image = {0, 0, 10, 9};
        },
        [](RenderState& state) {
            state.film.place = {1, 1, 9, 9};
            state.image = {2, 0, 9, 9};
        },
        [](RenderState& state) { state.film.parts = parts_of(state.film); },
        [](RenderState& state) {
            state.film.parts = {{{0, 0, 7, 6}, {{{0, 9}}}}};
        },
        [](RenderState& state) {
            state.film.parts = {{{0, 0, 3, 6}, {{{0, 8}}}}};
        },
        [](RenderState& state) {
            state.film.parts = {{{0, 0, 3, 6}, {{{0, 9}}}}, {{2, 0, 6, 6}, {{{0, 4}}}}};
        },
        [](RenderState& state) { state.settings[0].value = "0123\n"; },
        [](RenderState& state) { state.settings[2].value = std::nan(""); },
        [](RenderState& state) { state.radius_decay = 0; },
        [](RenderState& state) { state.radius_decay = 1; },
        [](RenderState& state) { state.radius_decay = std::nan(""); },
        [](RenderState& state) { state.seconds = -1; },
        [](RenderState& state) { state.checks[0].passes = 0; },
        [](RenderState& state) { state.checks[0].error.error = std::nan(""); },
    };
    for (std::size_t i = 0; i < spoilers.size(); ++i) {
        RenderState state = state_of(0, 9);
        spoilers[i](state);
        write_state(folder / "a.state", state);
        INFO("spoiler " << i);
        CHECK_THAT(refusal([&] { read_state(folder / "a.state"); }), Catch::Contains("damaged"));
    }
}

TEST_CASE("render state: states merge in any order into the bits of one run", "[film]")
{
    const RenderState one = state_of(0, 20);
    for (const bool reverse : {false, true}) {
        std::vector<RenderState> parts = {state_of(0, 5), state_of(11, 20), state_of(5, 11)};
        const std::vector<ErrorCheck> first = parts[0].checks;
        if (reverse)
            std::reverse(parts.begin(), parts.end());
        RenderState merged = parts[0];
        merge_state(merged, parts[1], "b");
        merge_state(merged, parts[2], "c");
        CHECK(merged.film == one.film);
        CHECK(merged.seconds == 7.5);
        CHECK(merged.checks == first);
        look_at_error(FireflyChoice::keep, merged);
        look_at_error(FireflyChoice::keep, merged);
        look_again(FireflyChoice::keep, merged);
        REQUIRE(merged.checks.size() == 2);
        CHECK(merged.checks[1] == ErrorCheck{20, 7.5, estimate_error(one.film).value()});
    }
}

TEST_CASE("render state: of merged checks those of the first passes stay", "[film]")
{
    RenderState apart = state_of(0, 5);
    merge_state(apart, state_of(11, 20), "b"); // passes 5 to 10 are missing
    look_at_error(FireflyChoice::keep, apart);
    REQUIRE(apart.checks.size() == 2);
    merge_state(apart, state_of(5, 11), "c");
    REQUIRE(apart.checks.size() == 1); // what held of 14 passes holds of the first 14 no more
    CHECK(apart.checks[0].passes == 5);
    RenderState empty = apart;
    empty.film = make_film(6, 6, 1, BiasKnowledge::from_radii);
    empty.checks.clear();
    merge_state(empty, apart, "d");
    CHECK(empty.checks == apart.checks);
}

TEST_CASE("render state: overlapping passes and other settings do not merge", "[film]")
{
    RenderState state = state_of(0, 5);
    const RenderState before = state;
    CHECK_THAT(refusal([&] { merge_state(state, state_of(4, 6), "b.state"); }),
               Catch::Contains("b.state") && Catch::Contains("pass 4"));
    RenderState other = state_of(5, 6);
    other.settings[1].value = std::uint64_t{2000};
    CHECK_THAT(refusal([&] { merge_state(state, other, "b.state"); }),
               Catch::Contains("photons=2000") && Catch::Contains("photons=1000"));
    other.settings.resize(1);
    CHECK_THAT(refusal([&] { merge_state(state, other, "b.state"); }),
               Catch::Contains("photons=1000"));
    other = state_of(5, 6);
    ++other.film.scale;
    CHECK_THAT(refusal([&] { merge_state(state, other, "b.state"); }), Catch::Contains("unit"));
    other = state_of(5, 6);
    other.film.passes.ranges = {{5, kMostPasses + 1}};
    CHECK_THAT(refusal([&] { merge_state(state, other, "b.state"); }), Catch::Contains("fewer"));
    CHECK(state == before);
}
