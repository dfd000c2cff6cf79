#include "common/input_error.h"
#include "render/film/render_state.h"
#include "tests/fuzz/scratch_file.h"

#include <xxhash.h>

#include <cstring>
#include <vector>

/// libFuzzer's entry: one state of a render, with its checksum put right, so that what lies behind
/// it is come to.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const hipmap::ScratchFile file("render.state");
    std::vector<std::uint8_t> bytes(data, data + size);
    constexpr std::size_t kChecksum = sizeof(std::uint64_t); // the last bytes of a state
    if (size > kChecksum) {
        const std::uint64_t checksum = XXH3_64bits(data, size - kChecksum);
        std::memcpy(&bytes[size - kChecksum], &checksum, kChecksum);
    }
    try {
        hipmap::read_state(file.write(bytes.data(), bytes.size()));
    } catch (const hipmap::InputError&) {
        // What bad input is meant to end in.
    }
    return 0;
}
