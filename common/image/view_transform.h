#pragma once

#include "common/image/write_image.h"

#include <string>

namespace hipmap {

/// Names of a view transform.
struct ViewChoice {
    std::string config; ///< an OpenColorIO configuration file, or "blender"; empty: plain sRGB
    std::string view;   ///< of the configuration's default display; empty: its default view
};

/// Returns a view transform of an OpenColorIO configuration, from linear Rec. 709 to display
/// values; empty without a configuration.  Any thread may call it.  "blender" is the newest
/// configuration of a Blender that is installed, or whose folder is on the PATH.
/// Throws InputError: no such configuration or view (names those that it has), a configuration
/// without a linear Rec. 709 colour space, a build without OpenColorIO, a view without a
/// configuration.
DisplayView make_view(const ViewChoice& choice);

} // namespace hipmap
