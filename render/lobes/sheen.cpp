#include "render/lobes/sheen.h"

#include "common/math/frame.h"
#include "render/lobes/sheen_albedo.h"

namespace hipmap {

Rgb Sheen::eval(const LobeView& view, const glm::vec3& in) const
{
    const float cos_in = glm::dot(view.normal, in);
    const glm::vec3 both = in + view.out;
    const float along = cos_in + view.cosine;
    const float sin2_half = 1 - along * along / glm::dot(both, both);
    return color * sheen_lobe(cos_in, view.cosine, sin2_half, alpha);
}

LobeSample Sheen::sample(const LobeView& view, RandomSequence& random) const
{
    const glm::vec2 u = random.next2();
    LobeSample out;
    out.direction = Frame(view.normal).to_world(direction_from_cosine(u.x, u.y));
    out.weight = eval(view, out.direction) * (u.x / pdf(view, out.direction));
    return out;
}

Rgb Sheen::albedo(const LobeView& view) const
{
    return color * sheen_albedo(view.cosine, alpha);
}

} // namespace hipmap
