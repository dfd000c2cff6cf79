#include "common/rays/embree_scene.h"

#include "common/math/random.h"
#include "common/math/rgb.h"
#include "common/rays/closest_on_triangle.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <new>
#include <span>
#include <utility>

namespace hipmap {

namespace {

/// Beyond this Embree 3.13 aborts the process instead of reporting a miss.
constexpr float kLargestCoordinate = 1e18f;

/// What the filter of a query knows of it.
struct Query {
    RTCIntersectContext context; // first, so that the filter can get from it to the rest
    const Ray* ray;
    const Opacity* opacity;
    const FaceId* first_face; ///< of each copy
};

/// The number of a face by its place in Embree.  instance: RTC_INVALID_GEOMETRY_ID: a stored face.
FaceId face_at(const FaceId* first_face, unsigned instance, unsigned primitive)
{
    return instance == RTC_INVALID_GEOMETRY_ID ? primitive : first_face[instance - 1] + primitive;
}

/// The hit that a filter is asked about.  All queries are of one ray.
const RTCHit& hit_of(const RTCFilterFunctionNArguments* args)
{
    assert(args->N == 1);
    return *reinterpret_cast<const RTCHit*>(args->hit);
}

FaceId face_of(const Query& query, const RTCHit& hit)
{
    return face_at(query.first_face, hit.instID[0], hit.primID);
}

/// What the filter of one `nearest` query remembers besides: the best hit so far.
struct NearestQuery : Query {
    float distance;
    FaceId face;
};

std::uint64_t bits_of(float a, float b)
{
    return std::uint64_t{std::bit_cast<std::uint32_t>(a)} << 32 | std::bit_cast<std::uint32_t>(b);
}

/// Uniform in [0, 1), by the bits of ray and face alone.
float uniform_of(const Ray& ray, FaceId face)
{
    const glm::vec3 &o = ray.origin, &d = ray.direction;
    std::uint64_t mixed = mix_bits(bits_of(o.x, o.y) + 1);
    mixed = mix_bits(mixed ^ bits_of(o.z, d.x));
    mixed = mix_bits(mixed ^ bits_of(d.y, d.z));
    return static_cast<float>(mix_bits(mixed ^ (std::uint64_t{face} + 1)) >> 40) * 0x1p-24f;
}

/// Whether a face that may let light pass stops the ray.
bool stops(const RTCFilterFunctionNArguments* args)
{
    const auto* query = reinterpret_cast<const Query*>(args->context);
    const RTCHit& hit = hit_of(args);
    const FaceId face = face_of(*query, hit);
    const float share = (*query->opacity)(face, {hit.u, hit.v});
    return share >= 1 || uniform_of(*query->ray, face) < share;
}

void keep_what_stops(const RTCFilterFunctionNArguments* args)
{
    if (!stops(args))
        args->valid[0] = 0;
}

/// Keeps a hit only if it beats the best one; of equally near ones the lowest face wins, which
/// makes the answer independent of the order in which the tree is walked.
void keep_lowest_face(const RTCFilterFunctionNArguments* args)
{
    auto* query = static_cast<NearestQuery*>(reinterpret_cast<Query*>(args->context));
    const float distance = reinterpret_cast<const RTCRay*>(args->ray)->tfar;
    const FaceId face = face_of(*query, hit_of(args));
    if (distance > query->distance || (distance == query->distance && face > query->face)) {
        args->valid[0] = 0;
        return;
    }
    query->distance = distance;
    query->face = face;
}

/// Keeps the lowest of equally near faces that stop the ray, where faces may let light pass.
void keep_lowest_face_that_stops(const RTCFilterFunctionNArguments* args)
{
    keep_what_stops(args);
    if (args->valid[0] != 0)
        keep_lowest_face(args);
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

/// From so many faces on, Embree's tree refers to vertices instead of copying them: 32 bytes a face
/// less for photons that take 15 % longer.  Hits are the same.
constexpr std::size_t kManyFaces = std::size_t{1} << 23;

/// Copies elements less an offset.
template <typename Element>
void copy_buffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format,
                 std::span<const Element> from, const Element& offset)
{
    void* to = rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(Element),
                                       std::max<std::size_t>(1, from.size()));
    if (to == nullptr)
        throw std::bad_alloc();
    std::transform(from.begin(), from.end(), static_cast<Element*>(to),
                   [&](const Element& element) { return element - offset; });
}

/// The triangles of some vertices and corners that count from the first of them.
RTCGeometry make_triangles(RTCDevice device, std::span<const glm::vec3> positions,
                           std::span<const glm::uvec3> corners, std::uint32_t first_vertex)
{
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    copy_buffer(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, positions, glm::vec3(0));
    copy_buffer(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, corners,
                glm::uvec3(first_vertex));
    rtcCommitGeometry(geometry);
    return geometry;
}

RTCScene new_scene(RTCDevice device, std::size_t faces)
{
    RTCScene scene = rtcNewScene(device);
    const bool is_large = faces >= kManyFaces;
    rtcSetSceneFlags(scene, static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_ROBUST |
                                                       RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION |
                                                       (is_large ? RTC_SCENE_FLAG_COMPACT : 0)));
    return scene;
}

/// A placed scene of shared faces.
RTCGeometry make_instance(RTCDevice device, RTCScene shared, const Similarity& place)
{
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_INSTANCE);
    rtcSetGeometryInstancedScene(geometry, shared);
    float columns[12];
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 3; ++row)
            columns[3 * column + row] = static_cast<float>(
                column < 3 ? place.scale * place.turn[column][row] : place.move[row]);
    rtcSetGeometryTransform(geometry, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, columns);
    rtcCommitGeometry(geometry);
    return geometry;
}

} // namespace

struct EmbreeScene::Handles {
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    RTCGeometry geometry = nullptr;   ///< stored faces, borrowed from the scene; null: no faces
    std::vector<RTCScene> shared;     ///< faces that copies have
    std::vector<FaceId> first_face;   ///< [copies]
    std::vector<FaceId> shared_first; ///< [copies] the first of the faces that are copied
    std::vector<Similarity> places;   ///< [copies]
    float widening = 1;               ///< of radii: Embree 3.13 looks in an instance within the
                                      ///<   radius of the scene, however small the instance is
    Opacity opacity;

    const glm::vec3* positions() const
    {
        return static_cast<const glm::vec3*>(
            rtcGetGeometryBufferData(geometry, RTC_BUFFER_TYPE_VERTEX, 0));
    }
    const glm::uvec3* corners() const
    {
        return static_cast<const glm::uvec3*>(
            rtcGetGeometryBufferData(geometry, RTC_BUFFER_TYPE_INDEX, 0));
    }

    ~Handles()
    {
        if (scene != nullptr)
            rtcReleaseScene(scene);
        for (RTCScene of_copies : shared)
            rtcReleaseScene(of_copies);
        if (device != nullptr)
            rtcReleaseDevice(device);
    }

    void attach(RTCScene to, RTCGeometry made) const
    {
        rtcAttachGeometry(to, made);
        rtcReleaseGeometry(made);
    }

    void add_copies(const TriangleMesh& mesh)
    {
        for (const SharedFaces& faces : mesh.shared) {
            shared.push_back(new_scene(device, faces.count));
            attach(shared.back(),
                   make_triangles(
                       device,
                       std::span(mesh.positions).subspan(faces.first_vertex, faces.vertex_count),
                       std::span(mesh.corners).subspan(faces.first, faces.count),
                       faces.first_vertex));
            rtcCommitScene(shared.back());
        }
        for (std::uint32_t i = 0; i < mesh.copies.size(); ++i) {
            const FaceCopy& copy = mesh.copies[i];
            attach(scene, make_instance(device, shared[copy.shared], copy.place));
            first_face.push_back(mesh.finder.first_face(i));
            shared_first.push_back(mesh.shared[copy.shared].first);
            places.push_back(copy.place);
            widening = std::max(widening, static_cast<float>(1.0001 / copy.place.scale));
        }
    }
};

namespace {

/// What a search for the closest point knows, and the best one so far.
struct ClosestQuery {
    glm::vec3 point;
    const EmbreeScene::Handles& scene;
    float distance2;
    FaceId face = kNone;
    glm::vec3 closest{0.0f};
};

/// What visit_near knows.
struct NearQuery {
    const EmbreeScene::Handles& scene;
    const std::function<void(FaceId)>& visit;
};

unsigned instance_of(const RTCPointQueryFunctionArguments* args)
{
    const RTCPointQueryContext& context = *args->context;
    return context.instStackSize == 0 ? RTC_INVALID_GEOMETRY_ID
                                      : context.instID[context.instStackSize - 1];
}

bool pass_on(RTCPointQueryFunctionArguments* args)
{
    const auto& query = *static_cast<const NearQuery*>(args->userPtr);
    query.visit(face_at(query.scene.first_face.data(), instance_of(args), args->primID));
    return false;
}

/// The corners of a face in the scene.
std::array<glm::vec3, 3> corners_at(const EmbreeScene::Handles& scene, unsigned instance,
                                    unsigned primitive)
{
    const bool is_stored = instance == RTC_INVALID_GEOMETRY_ID;
    const glm::uvec3 c =
        scene.corners()[is_stored ? primitive : scene.shared_first[instance - 1] + primitive];
    std::array<glm::vec3, 3> out;
    for (int i = 0; i < 3; ++i) {
        const glm::vec3& stored = scene.positions()[c[i]];
        out[static_cast<std::size_t>(i)] =
            is_stored ? stored : glm::vec3(scene.places[instance - 1].point(glm::dvec3(stored)));
    }
    return out;
}

/// Looks at one face; true: the radius has shrunk.
bool look_at_face(RTCPointQueryFunctionArguments* args)
{
    auto& query = *static_cast<ClosestQuery*>(args->userPtr);
    const unsigned instance = instance_of(args);
    const FaceId face = face_at(query.scene.first_face.data(), instance, args->primID);
    const auto [a, b, c] = corners_at(query.scene, instance, args->primID);
    const glm::vec3 closest = closest_on_triangle(query.point, a, b, c);
    const glm::vec3 way = closest - query.point;
    const float distance2 = glm::dot(way, way);
    const bool beats =
        distance2 < query.distance2 || (distance2 == query.distance2 && face < query.face);
    if (!beats)
        return false;
    query.distance2 = distance2;
    query.face = face;
    query.closest = closest;
    // With room for rounding: a face as near as this one must still be looked at.
    args->query->radius =
        std::min(args->query->radius, std::sqrt(distance2) * 1.0001f * query.scene.widening);
    return true;
}

} // namespace

EmbreeScene::EmbreeScene(const TriangleMesh& mesh, Opacity opacity)
    : handles_(std::make_unique<Handles>())
{
    handles_->opacity = std::move(opacity);
    handles_->device = rtcNewDevice(nullptr);
    if (handles_->device == nullptr)
        throw std::bad_alloc();
    handles_->scene = new_scene(handles_->device, mesh.face_count());
    if (mesh.face_count() != 0) {
        handles_->geometry = make_triangles(handles_->device, mesh.positions, mesh.corners, 0);
        handles_->attach(handles_->scene, handles_->geometry); // so that copies begin at 1
    }
    handles_->add_copies(mesh);
    rtcCommitScene(handles_->scene);
    if (rtcGetDeviceError(handles_->device) != RTC_ERROR_NONE)
        throw std::bad_alloc();
}

EmbreeScene::~EmbreeScene() = default;
EmbreeScene::EmbreeScene(EmbreeScene&&) noexcept = default;
EmbreeScene& EmbreeScene::operator=(EmbreeScene&&) noexcept = default;

std::optional<RayHit> EmbreeScene::nearest(const Ray& ray) const
{
    return find_nearest(ray, static_cast<bool>(handles_->opacity));
}

std::optional<RayHit> EmbreeScene::nearest_face(const Ray& ray) const
{
    return find_nearest(ray, false);
}

/// that_stops: there is an opacity, which must be asked.
std::optional<RayHit> EmbreeScene::find_nearest(const Ray& ray, bool that_stops) const
{
    if (!can_cast(ray))
        return std::nullopt;
    NearestQuery query;
    rtcInitIntersectContext(&query.context);
    query.context.filter = that_stops ? keep_lowest_face_that_stops : keep_lowest_face;
    query.ray = &ray;
    query.opacity = &handles_->opacity;
    query.first_face = handles_->first_face.data();
    query.distance = std::numeric_limits<float>::infinity();
    query.face = kNone;

    RTCRayHit ray_hit{};
    ray_hit.ray = embree_ray(ray);
    ray_hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    ray_hit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(handles_->scene, &query.context, &ray_hit);
    if (ray_hit.hit.geomID == RTC_INVALID_GEOMETRY_ID)
        return std::nullopt;
    return RayHit{ray_hit.ray.tfar,
                  face_at(query.first_face, ray_hit.hit.instID[0], ray_hit.hit.primID),
                  {ray_hit.hit.u, ray_hit.hit.v}};
}

bool EmbreeScene::occluded(const Ray& ray) const
{
    if (!can_cast(ray))
        return false;
    Query query;
    rtcInitIntersectContext(&query.context);
    if (handles_->opacity) {
        query.context.filter = keep_what_stops;
        query.ray = &ray;
        query.opacity = &handles_->opacity;
        query.first_face = handles_->first_face.data();
    }
    RTCRay shadow = embree_ray(ray);
    rtcOccluded1(handles_->scene, &query.context, &shadow);
    return shadow.tfar < 0;
}

std::optional<glm::vec3> EmbreeScene::closest_point(const glm::vec3& point, float radius) const
{
    const glm::vec3 a = glm::abs(point);
    const bool in_range = a.x < kLargestCoordinate && a.y < kLargestCoordinate &&
                          a.z < kLargestCoordinate && radius < kLargestCoordinate;
    if (handles_->geometry == nullptr || !in_range)
        return std::nullopt;
    ClosestQuery found{point, *handles_, radius * radius};
    RTCPointQuery query{point.x, point.y, point.z, 0, radius * handles_->widening};
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    rtcPointQuery(handles_->scene, &query, &context, look_at_face, &found);
    return found.face == kNone ? std::nullopt : std::optional(found.closest);
}

void EmbreeScene::visit_near(const glm::vec3& point, float radius,
                             const std::function<void(FaceId)>& visit) const
{
    if (handles_->geometry == nullptr || !can_cast({point, {0, 0, 1}, 0.0f, radius}))
        return;
    RTCPointQuery query{point.x, point.y, point.z, 0, radius * handles_->widening};
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    NearQuery called{*handles_, visit};
    rtcPointQuery(handles_->scene, &query, &context, pass_on, &called);
}

} // namespace hipmap
