// Arrays of millions of faces lie in huge pages: Debian gives a program 4 KiB pages unless it asks,
// and preprocess spends a quarter of its time on getting them.  A program that links this object
// library has its operator new replaced, also in libraries.  Both tools do; not with sanitizers,
// which replace it themselves.

#include <sys/mman.h>

#include <cstdlib>
#include <new>

namespace {

/// Of the processors that Debian calls amd64 and arm64.  Where pages differ the request does
/// nothing.
constexpr std::size_t kHugePage = std::size_t{1} << 21;

/// Smaller arrays, such as the photons of most passes, are often filled in part only: a huge page
/// that is cleared for nothing costs more than it saves.
constexpr std::size_t kLeastSize = 16 * kHugePage;

/// Returns memory, or null.
void* allocate(std::size_t size)
{
    if (size < kLeastSize)
        return std::malloc(size > 0 ? size : 1);
    void* const memory = std::aligned_alloc(kHugePage, size);
    if (memory != nullptr)
        ::madvise(memory, size / kHugePage * kHugePage, MADV_HUGEPAGE); // may be refused: no harm
    return memory;
}

} // namespace

void* operator new(std::size_t size)
{
    for (;;) {
        if (void* const memory = allocate(size))
            return memory;
        const std::new_handler answer = std::get_new_handler();
        if (answer == nullptr)
            throw std::bad_alloc();
        answer();
    }
}

void operator delete(void* memory) noexcept
{
    std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept
{
    std::free(memory);
}
