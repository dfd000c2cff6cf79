#pragma once

#include <cstdlib> // says whether C's library is GNU's

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace hipmap {

/// Returns the memory of freed arrays to the system, which C's library otherwise keeps for arrays
/// of the same size: for the end of a stage that allocated many.  Milliseconds for gigabytes.
inline void return_freed_memory()
{
#ifdef __GLIBC__
    malloc_trim(0);
#endif
}

} // namespace hipmap
