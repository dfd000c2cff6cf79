#include "common/input_error.h"
#include "render/film/render_state.h"
#include "tests/fuzz/scratch_file.h"

/// libFuzzer's entry: one state of a render.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const hipmap::ScratchFile file("render.state");
    try {
        hipmap::read_state(file.write(data, size));
    } catch (const hipmap::InputError&) {
        // What bad input is meant to end in.
    }
    return 0;
}
