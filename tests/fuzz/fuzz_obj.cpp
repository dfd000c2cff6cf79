#include "tests/fuzz/fuzz_scene.h"
#include "tests/fuzz/scratch_file.h"

#include <algorithm>

/// libFuzzer's entry: an .obj; what follows a zero byte is the .mtl that it may name scene.mtl.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const hipmap::ScratchFile obj("scene.obj"), mtl("scene.mtl");
    const auto cut = static_cast<std::size_t>(std::find(data, data + size, 0) - data);
    if (cut < size)
        mtl.write(data + cut + 1, size - cut - 1);
    hipmap::load_and_partition(obj.write(data, cut));
    return 0;
}
