#include "render/integrator/occlusion.h"

#include "common/math/bounds.h"
#include "common/math/frame.h"
#include "common/math/sampling.h"
#include "common/rays/surface_point.h"
#include "common/scene/store_copies.h"
#include "render/integrator/sampled_source.h"

namespace hipmap {

namespace {

float reach_in(const TriangleMesh& mesh)
{
    const Bounds<glm::vec3> bounds = bounds_of(mesh);
    return bounds.empty() ? 0 : kOcclusionReach * glm::length(bounds.extent());
}

struct OcclusionMethod : SampledEvenly {
    static constexpr bool kShowsLights = false;
    static constexpr BiasKnowledge kBias = BiasKnowledge::unbiased;

    const RenderScene& scene;
    float reach; ///< scene units, unless the options say another

    explicit OcclusionMethod(const RenderScene& of) : scene(of), reach(reach_in(of.mesh())) {}
    static OcclusionMethod at(const RenderScene& now) { return OcclusionMethod(now); }

    struct Pass {
        const RenderScene& scene;
        const float reach;

        Pass(const OcclusionMethod& of, const PictureJob& job, RenderStatistics& /*statistics*/)
            : scene(of.scene), reach(asked(job).value_or(of.reach))
        {
        }

        static std::optional<float> asked(const PictureJob& job)
        {
            const double metres = job.options.occlusion_distance;
            if (!(metres > 0))
                return std::nullopt;
            return static_cast<float>(metres / job.scene.scene.frame.metres_per_unit);
        }

        Rgb trace(const Ray& ray, SeenLights /*seen*/, RandomSequence& random,
                  Scratch& /*scratch*/) const
        {
            const auto hit = scene.rays.nearest(ray);
            if (!hit)
                return Rgb(0);
            const SurfacePoint point = surface_point(scene.mesh(), hit->face, hit->barycentric);
            const float side = glm::dot(point.geometric_normal, ray.direction) < 0 ? 1.0f : -1.0f;
            Ray out;
            out.direction = Frame(side * point.shading_normal)
                                .to_world(sample_cosine_hemisphere(random.next2()));
            if (!(side * glm::dot(out.direction, point.geometric_normal) > 0))
                return Rgb(0); // it would start inside
            out.origin = offset_origin(point, out.direction);
            out.far = reach;
            return Rgb(scene.rays.occluded(out) ? 0.0f : 1.0f);
        }
    };
};

} // namespace

PassSource make_occlusion_source(const RenderScene& scene, const RenderOptions& options,
                                 RenderStatistics& statistics, const PilotControl& pilots)
{
    return make_sampled_source(OcclusionMethod(scene), options, statistics, pilots);
}

} // namespace hipmap
