#include "common/input_error.h"
#include "render/film/render_state.h"
#include "render/film/state_bytes.h"
#include "tests/fuzz/scratch_file.h"

#include <xxhash.h>

#include <cstring>
#include <vector>

namespace {

/// Writes a state with its checksum put right, so that what lies behind it is reached.
void write_file_of(const hipmap::ScratchFile& file, const std::uint8_t* data, std::size_t size)
{
    std::vector<std::uint8_t> bytes(data, data + size);
    constexpr std::size_t kChecksum = sizeof(std::uint64_t); // the last bytes of a state
    if (size > kChecksum) {
        const std::uint64_t checksum = XXH3_64bits(data, size - kChecksum);
        std::memcpy(&bytes[size - kChecksum], &checksum, kChecksum);
    }
    file.write(bytes.data(), bytes.size());
}

/// Writes a state whose values, before they are compressed, are the bytes.
void write_values(const std::filesystem::path& path, const std::uint8_t* data, std::size_t size)
{
    hipmap::StateWriter out(path, hipmap::kStateVersion);
    for (std::size_t i = 0; i < size; ++i)
        out.put(data[i]);
    out.finish();
}

} // namespace

/// libFuzzer's entry: one state of a render if the first byte is its mark's, otherwise its values.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const hipmap::ScratchFile file("render.state");
    const std::filesystem::path path = file.write(data, size);
    if (size > 0 && data[0] == 'H')
        write_file_of(file, data, size);
    else
        write_values(path, data, size);
    try {
        hipmap::read_state(path);
    } catch (const hipmap::InputError&) {
        // What bad input is meant to end in.
    }
    return 0;
}
