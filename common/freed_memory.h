#pragma once

#include <cstdlib> // says whether C's library is GNU's

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <vector>

namespace hipmap {

/// Frees the memory of an array; assigning {} to it would keep that for new elements.
template <typename T>
void free_array(std::vector<T>& array)
{
    std::vector<T>().swap(array);
}

/// Returns the memory of freed arrays to the system; C's library otherwise keeps it for new arrays.
/// A stage that allocates many arrays calls it at its end.  Takes milliseconds for gigabytes.
inline void return_freed_memory()
{
#ifdef __GLIBC__
    malloc_trim(0);
#endif
}

} // namespace hipmap
