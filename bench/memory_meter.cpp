#include "bench/memory_meter.h"

#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace hipmap {

namespace {

std::atomic<std::size_t> in_use{0};
std::atomic<std::size_t> peak{0};

void* counted(void* memory)
{
    if (!memory)
        throw std::bad_alloc();
    const std::size_t size = malloc_usable_size(memory);
    const std::size_t now = in_use.fetch_add(size) + size;
    std::size_t seen = peak.load();
    while (now > seen && !peak.compare_exchange_weak(seen, now)) {
    }
    return memory;
}

void release(void* memory)
{
    in_use.fetch_sub(malloc_usable_size(memory)); // 0 for a null pointer
    std::free(memory);
}

} // namespace

std::size_t memory_in_use()
{
    return in_use;
}

std::size_t memory_peak()
{
    return peak;
}

void start_memory_peak()
{
    peak = in_use.load();
}

} // namespace hipmap

void* operator new(std::size_t size)
{
    return hipmap::counted(std::malloc(size > 0 ? size : 1));
}

void* operator new(std::size_t size, std::align_val_t alignment)
{
    const auto step = static_cast<std::size_t>(alignment);
    return hipmap::counted(std::aligned_alloc(step, (size + step) / step * step));
}

void operator delete(void* memory) noexcept
{
    hipmap::release(memory);
}

void operator delete(void* memory, std::size_t) noexcept
{
    hipmap::release(memory);
}

void operator delete(void* memory, std::align_val_t) noexcept
{
    hipmap::release(memory);
}

void operator delete(void* memory, std::size_t, std::align_val_t) noexcept
{
    hipmap::release(memory);
}
