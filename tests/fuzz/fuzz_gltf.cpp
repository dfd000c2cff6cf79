#include "tests/fuzz/fuzz_scene.h"
#include "tests/fuzz/scratch_file.h"

#include <cstring>

/// libFuzzer's entry: one .glb, or .gltf where the bytes do not begin like a container.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const hipmap::ScratchFile glb("scene.glb"), gltf("scene.gltf");
    const bool container = size >= 4 && std::memcmp(data, "glTF", 4) == 0;
    hipmap::load_and_partition((container ? glb : gltf).write(data, size));
    return 0;
}
