#pragma once

namespace hipmap {

/// The light that is traced in addition to light straight from a source to the first surface that
/// gathers: the classes of photon of docs/effects.md.
struct LightClasses {
    bool caustic = true;  ///< that specular surfaces bring to it, and all that comes of it later
    bool indirect = true; ///< that such surfaces send to each other

    bool operator==(const LightClasses&) const = default;
};

} // namespace hipmap
