#include "common/input_error.h"
#include "common/partition/partition_file.h"
#include "tests/fuzz/scratch_file.h"

/// libFuzzer's entry: one .hpm.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const hipmap::ScratchFile file("partition.hpm");
    try {
        hipmap::read_partition(file.write(data, size));
    } catch (const hipmap::InputError&) {
        // What bad input is meant to end in.
    }
    return 0;
}
