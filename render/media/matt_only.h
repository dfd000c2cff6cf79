#pragma once

namespace hipmap {

/// Builds with HIPMAP_MATT_ONLY have diffuse surfaces that emit, in clear air, and nothing else:
/// bench/cost_of_absence.py measures what all other effects cost against them.
#ifdef HIPMAP_MATT_ONLY
inline constexpr bool kMattOnly = true;
#else
inline constexpr bool kMattOnly = false;
#endif

} // namespace hipmap
