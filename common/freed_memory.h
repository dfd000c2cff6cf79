#pragma once

#include <cstdlib> // says whether C's library is GNU's

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace hipmap {

/// Returns the memory of freed arrays to the system; C's library otherwise keeps it for new arrays.
/// A stage that allocates many arrays calls it at its end.  Takes milliseconds for gigabytes.
inline void return_freed_memory()
{
#ifdef __GLIBC__
    malloc_trim(0);
#endif
}

} // namespace hipmap
