#include "common/scene/fingerprint.h"

#include <xxhash.h>

#include <memory>
#include <new>

namespace hipmap {

namespace {

struct FreeState {
    void operator()(XXH3_state_t* state) const { XXH3_freeState(state); }
};

template <typename T>
void add(XXH3_state_t* state, const std::vector<T>& values)
{
    const std::uint64_t size = values.size();
    XXH3_128bits_update(state, &size, sizeof size);
    XXH3_128bits_update(state, values.data(), values.size() * sizeof(T));
}

} // namespace

Fingerprint fingerprint(const Scene& scene)
{
    static_assert(sizeof(glm::vec3) == 12 && sizeof(glm::uvec3) == 12, "padding would be hashed");
    const std::unique_ptr<XXH3_state_t, FreeState> state(XXH3_createState());
    if (!state)
        throw std::bad_alloc();
    XXH3_128bits_reset(state.get());
    const std::array<double, 4> frame = {scene.frame.centre.x, scene.frame.centre.y,
                                         scene.frame.centre.z, scene.frame.metres_per_unit};
    XXH3_128bits_update(state.get(), frame.data(), sizeof frame);
    add(state.get(), scene.mesh.positions);
    add(state.get(), scene.mesh.corners);
    const XXH128_hash_t hash = XXH3_128bits_digest(state.get());
    return {{hash.low64, hash.high64}};
}

} // namespace hipmap
