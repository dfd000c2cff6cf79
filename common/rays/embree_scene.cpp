#include "common/rays/embree_scene.h"

#include "common/math/rgb.h"

#include <embree3/rtcore.h>

#include <cmath>
#include <new>

namespace hipmap {

namespace {

/// Beyond this Embree 3.13 aborts the process instead of reporting a miss.
constexpr float kLargestCoordinate = 1e18f;

/// What the filter of one `nearest` query remembers: the best hit so far.
struct NearestQuery {
    RTCIntersectContext context; // first, so that the filter can get from it to the rest
    float distance;
    FaceId face;
};

/// Keeps a hit only if it beats the best one; of equally near ones the lowest face wins, which
/// makes the answer independent of the order in which the tree is walked.
void keep_lowest_face(const RTCFilterFunctionNArguments* args)
{
    auto* query = reinterpret_cast<NearestQuery*>(args->context);
    const float distance = RTCRayN_tfar(args->ray, args->N, 0);
    const FaceId face = RTCHitN_primID(args->hit, args->N, 0);
    if (distance > query->distance || (distance == query->distance && face > query->face)) {
        args->valid[0] = 0;
        return;
    }
    query->distance = distance;
    query->face = face;
}

bool can_cast(const Ray& ray)
{
    const glm::vec3 a = glm::abs(ray.origin);
    const glm::vec3 d = glm::abs(ray.direction);
    const bool in_range = a.x < kLargestCoordinate && a.y < kLargestCoordinate &&
                          a.z < kLargestCoordinate && d.x < kLargestCoordinate &&
                          d.y < kLargestCoordinate && d.z < kLargestCoordinate;
    return in_range && ray.near >= 0 && ray.far >= ray.near;
}

RTCRay embree_ray(const Ray& ray)
{
    RTCRay out{};
    out.org_x = ray.origin.x;
    out.org_y = ray.origin.y;
    out.org_z = ray.origin.z;
    out.dir_x = ray.direction.x;
    out.dir_y = ray.direction.y;
    out.dir_z = ray.direction.z;
    out.tnear = ray.near;
    out.tfar = ray.far;
    out.mask = 0xffffffffu;
    return out;
}

template <typename Element>
void copy_buffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format,
                 const std::vector<Element>& from)
{
    void* to = rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(Element),
                                       std::max<std::size_t>(1, from.size()));
    if (to == nullptr)
        throw std::bad_alloc();
    std::copy(from.begin(), from.end(), static_cast<Element*>(to));
}

} // namespace

struct EmbreeScene::Handles {
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;

    ~Handles()
    {
        if (scene != nullptr)
            rtcReleaseScene(scene);
        if (device != nullptr)
            rtcReleaseDevice(device);
    }
};

EmbreeScene::EmbreeScene(const TriangleMesh& mesh) : handles_(std::make_unique<Handles>())
{
    handles_->device = rtcNewDevice(nullptr);
    if (handles_->device == nullptr)
        throw std::bad_alloc();
    handles_->scene = rtcNewScene(handles_->device);
    rtcSetSceneFlags(
        handles_->scene,
        static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION));
    if (mesh.face_count() != 0) {
        RTCGeometry geometry = rtcNewGeometry(handles_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
        copy_buffer(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, mesh.positions);
        copy_buffer(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, mesh.corners);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(handles_->scene, geometry);
        rtcReleaseGeometry(geometry);
    }
    rtcCommitScene(handles_->scene);
    if (rtcGetDeviceError(handles_->device) != RTC_ERROR_NONE)
        throw std::bad_alloc();
}

EmbreeScene::~EmbreeScene() = default;
EmbreeScene::EmbreeScene(EmbreeScene&&) noexcept = default;
EmbreeScene& EmbreeScene::operator=(EmbreeScene&&) noexcept = default;

std::optional<RayHit> EmbreeScene::nearest(const Ray& ray) const
{
    if (!can_cast(ray))
        return std::nullopt;
    NearestQuery query;
    rtcInitIntersectContext(&query.context);
    query.context.filter = keep_lowest_face;
    query.distance = std::numeric_limits<float>::infinity();
    query.face = kNone;

    RTCRayHit ray_hit{};
    ray_hit.ray = embree_ray(ray);
    ray_hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(handles_->scene, &query.context, &ray_hit);
    if (ray_hit.hit.geomID == RTC_INVALID_GEOMETRY_ID)
        return std::nullopt;
    return RayHit{ray_hit.ray.tfar, ray_hit.hit.primID, {ray_hit.hit.u, ray_hit.hit.v}};
}

bool EmbreeScene::occluded(const Ray& ray) const
{
    if (!can_cast(ray))
        return false;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRay query = embree_ray(ray);
    rtcOccluded1(handles_->scene, &context, &query);
    return query.tfar < 0;
}

} // namespace hipmap
