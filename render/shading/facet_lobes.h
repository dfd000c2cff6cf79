#pragma once

#include "render/shading/scatter.h"

namespace hipmap {

// Light by the facets of a surface below its clear coat: of what the lobes have, the reflection and
// rough glass.  There must be some.  docs/light_transport.md (16), (17) and (19).

/// With what is folded.  in: as in `scattered`.
Scattered scattered_by_facets(const Interaction& at, const glm::vec3& in, Lobes lobes);

/// Draws a visible facet, and reflects or transmits by it.
ScatterSample sample_own_facets(const Interaction& at, Lobes lobes, RandomSequence& random);

} // namespace hipmap
