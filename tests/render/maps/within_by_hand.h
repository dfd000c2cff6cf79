#pragma once

#include "common/math/random.h"
#include "common/math/sampling.h"
#include "common/rays/surface_point.h"
#include "render/maps/fixed_radius.h"
#include "tests/support/hard_surfaces.h"
#include "tests/support/tiny_scenes.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <functional>
#include <numbers>

namespace hipmap::within {

using Radii = std::array<float, 3>;

/// Flat, curved, slit, folded and cornered surfaces.
inline const std::vector<std::function<TriangleMesh(std::uint64_t)>> kSurfaces{
    [](std::uint64_t) { return tiny::quad(); },
    [](std::uint64_t) { return tiny::cube(); },
    [](std::uint64_t seed) { return tiny::slit_floor(3, 0.01f * float(1 + seed % 7)); },
    [](std::uint64_t seed) { return tiny::hairpin(3, 0.02f * float(1 + seed % 5)); },
    [](std::uint64_t) { return tiny::uv_sphere(12, 8); },
};

inline std::vector<Photon> make_photons(const TriangleMesh& mesh, std::size_t count,
                                        std::uint64_t seed)
{
    std::vector<Photon> photons;
    for (std::size_t i = 0; i < count; ++i) {
        RandomSequence random(seed, RandomStream::photons, 0, i);
        const auto face =
            static_cast<FaceId>(random.next() * static_cast<float>(mesh.face_count()));
        const SurfacePoint at = surface_point(mesh, face, sample_triangle(random.next2()));
        const bool front = random.next() < 0.7f;
        const glm::vec3 direction =
            glm::normalize(at.geometric_normal + 0.9f * sample_sphere(random.next2()));
        photons.push_back({at.position, Rgb(random.next(), random.next(), 1),
                           front ? direction : -direction, face,
                           static_cast<std::uint8_t>(front ? 0 : 1)});
    }
    return photons;
}

inline float distance_to_segment(const glm::vec3& point, const BoundarySegment& s)
{
    const glm::vec3 d = s.b - s.a;
    const float t = glm::dot(point - s.a, d) / glm::dot(d, d);
    return glm::distance(point, s.a + glm::clamp(t, 0.0f, 1.0f) * d);
}

/// As docs/photon_maps.md says, over all photons.
struct ByHand {
    const MapSurfaces& surfaces;
    const std::vector<Photon>& photons;
    bool one_map = false; ///< without boundaries

    MapId map(FaceId face) const { return surfaces.partition.map_of_face[face]; }

    bool counts(const Photon& photon, const PhotonQuery& query) const
    {
        if (one_map)
            return glm::dot(photon.direction, query.normal) > 0;
        return map(photon.face) == map(query.face) && photon.side == query.side &&
               (photon.face == query.face ||
                glm::dot(surfaces.normals[photon.face], surfaces.normals[query.face]) > 0);
    }

    Radii areas_of(const PhotonQuery& query, const Radii& radii, bool open,
                   const VisibleDisc& disc) const
    {
        FoldAreas facing{};
        if (!one_map && surfaces.may_fold(query.face))
            facing = surfaces.facing_areas(query.face, query.position, radii,
                                           open ? AreaOf::surface : AreaOf::projection);
        Radii out{};
        for (std::size_t r = 0; r < radii.size(); ++r) {
            const double seen = radii[r] > 0 ? disc.area(radii[r]) : 0;
            out[r] = static_cast<float>(!(facing[r] > 0) ? seen
                                        : open           ? facing[r]
                                                         : std::min(seen, facing[r]));
        }
        return out;
    }

    RadiusEstimates estimate(const PhotonQuery& query, const Radii& radii) const
    {
        std::vector<BoundarySegment> near;
        if (!one_map)
            for (const BoundarySegment& s : surfaces.boundaries.of(map(query.face)))
                if (distance_to_segment(query.position, s) <= radii[0])
                    near.push_back(s);
        VisibleDisc disc;
        const glm::uvec3 c = surfaces.mesh.corners[query.face];
        const auto& p = surfaces.mesh.positions;
        disc.look({{p[c.x], p[c.y], p[c.z]}, query.position, radii[0]}, near);
        const Radii areas = areas_of(query, radii, near.empty(), disc);
        RadiusEstimates out{};
        for (const Photon& photon : photons) {
            const float distance = glm::distance(photon.position, query.position);
            if (!counts(photon, query) || distance > radii[0] || !disc.sees(photon.position))
                continue;
            ++out.photons;
            float cosine = 1;
            if (!near.empty())
                cosine = std::max(
                    0.0f, glm::dot(surfaces.normals[photon.face], surfaces.normals[query.face]));
            for (std::size_t r = 0; r < radii.size(); ++r)
                if (distance <= radii[r])
                    out.irradiance[r] += photon.power * cosine / areas[r];
        }
        return out;
    }
};

inline bool close(const Rgb& a, const Rgb& b)
{
    return glm::all(glm::lessThanEqual(glm::abs(a - b), Rgb(1e-4f * (1 + max_channel(b)))));
}

/// A query and three radii, descending.
struct RadiusQuery {
    PhotonQuery query;
    Radii radii;
};

inline RadiusQuery random_query(const TriangleMesh& mesh, std::uint64_t seed, std::uint64_t i)
{
    RandomSequence random(seed, RandomStream::eye_paths, 0, i);
    const auto face = static_cast<FaceId>(random.next() * static_cast<float>(mesh.face_count()));
    const SurfacePoint at = surface_point(mesh, face, sample_triangle(random.next2()));
    const float r = 0.5f * random.next();
    const float r1 = r * random.next();
    return {{at.position, at.geometric_normal, face, 0},
            {r, r1, i % 5 == 0 ? 0 : r1 * random.next()}};
}

inline void check_same(const RadiusEstimates& found, const RadiusEstimates& truth)
{
    CHECK(found.photons == truth.photons);
    for (std::size_t j = 0; j < found.irradiance.size(); ++j)
        CHECK(close(found.irradiance[j], truth.irradiance[j]));
}

} // namespace hipmap::within
