#include "render/shutter.h"

#include "common/scene/fingerprint.h"
#include "common/scene/named_lights.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace hipmap {

namespace {

constexpr std::size_t kMoments = 5; ///< at which motion is looked for

void add_once(std::vector<std::string>& names, const std::string& name)
{
    if (std::find(names.begin(), names.end(), name) == names.end())
        names.push_back(name);
}

void add_moved_objects(const TriangleMesh& then, const TriangleMesh& now,
                       std::vector<std::string>& names)
{
    std::vector<bool> added(then.object_names.size(), false);
    for (FaceId face = 0; face < then.face_count(); ++face) {
        const ObjectId object = then.object_of(face);
        for (int c = 0; c < 3 && !added[object]; ++c)
            if (then.positions[then.corners[face][c]] != now.positions[now.corners[face][c]]) {
                added[object] = true;
                add_once(names, then.object_names[object]);
            }
    }
}

void add_moved_lights(const Scene& then, const Scene& now, std::vector<std::string>& names)
{
    const std::vector<NamedLight> before = named_lights(then.lights),
                                  after = named_lights(now.lights);
    for (std::size_t i = 0; i < before.size(); ++i)
        if (before[i].placement != after[i].placement)
            add_once(names, before[i].name);
    const Camera &a = then.cameras[then.camera], &b = now.cameras[now.camera];
    if (a.position != b.position || a.right != b.right || a.up != b.up)
        add_once(names, a.name);
}

} // namespace

ShutterTime shutter_time(const RenderArguments& arguments)
{
    const double seconds = arguments.shutter / arguments.frames.fps;
    return {arguments.scene_options.time.value_or(0) - seconds / 2, seconds};
}

ShutterMotion find_motion(const Scene& still, const ShutterTime& shutter,
                          const std::function<Scene(double time)>& at)
{
    ShutterMotion out;
    if (!(shutter.seconds > 0))
        return out;
    std::array<Fingerprint, kMoments> contents;
    for (std::size_t i = 0; i < kMoments; ++i) {
        const Scene now = at(shutter.at(static_cast<double>(i) / (kMoments - 1)));
        add_moved_objects(still.mesh, now.mesh, out.names);
        add_moved_lights(still, now, out.names);
        if (i == 0 || i + 1 == kMoments)
            contents[i] = content_fingerprint(now);
    }
    char text[96];
    std::snprintf(text, sizeof text, "%.17g+%.17g s, %016llx to %016llx", shutter.open,
                  shutter.seconds, static_cast<unsigned long long>(contents.front().words[0]),
                  static_cast<unsigned long long>(contents.back().words[0]));
    out.setting = {"shutter", text};
    return out;
}

} // namespace hipmap
