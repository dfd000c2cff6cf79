#include "render/lights/collect_lights.h"

#include "common/math/bounds.h"
#include "common/math/sampling.h"
#include "common/scene/store_copies.h"

#include <map>
#include <utility>

namespace hipmap {

namespace {

SceneSphere sphere_around(const TriangleMesh& mesh)
{
    const Bounds<glm::vec3> box = bounds_of(mesh);
    return box.empty() ? SceneSphere{}
                       : SceneSphere{box.centre(), 0.5f * glm::length(box.extent())};
}

SpotCone cone_of(const SceneSpotLight& light)
{
    return {glm::vec3(light.direction), light.cos_inner, light.cos_outer, light.falloff};
}

Light light_from(const ScenePointLight& light, const SceneSphere&)
{
    const glm::vec3 position(light.position);
    if (light.radius > 0)
        return SphereLight{position, static_cast<float>(light.radius), Rgb(light.intensity), {}};
    return PointLight{position, Rgb(light.intensity)};
}

Light light_from(const SceneSpotLight& light, const SceneSphere&)
{
    const glm::vec3 position(light.position);
    if (light.radius > 0)
        return SphereLight{position, static_cast<float>(light.radius), Rgb(light.intensity),
                           cone_of(light)};
    return SpotLight{position, Rgb(light.intensity), cone_of(light)};
}

Light light_from(const SceneSunLight& light, const SceneSphere& sphere)
{
    return SunLight{glm::vec3(light.direction), Rgb(light.irradiance),
                    static_cast<float>(light.half_angle), sphere};
}

Light light_from(const SceneAreaLight& light, const SceneSphere&)
{
    const FlatShape shape{
        light.is_disc ? FlatShape::Outline::ellipse : FlatShape::Outline::rectangle,
        glm::vec3(light.centre), glm::vec3(light.half_right), glm::vec3(light.half_up)};
    return PlanarLight{shape, glm::vec3(light.direction), Rgb(light.radiance),
                       make_spread(light.half_spread)};
}

std::vector<FacePower> powers_of_faces(const SurfaceEmission& surfaces)
{
    const TriangleMesh& mesh = *surfaces.mesh;
    std::vector<FacePower> out;
    for (FaceId face = 0; face < mesh.face_count(); ++face) {
        const SurfaceEmission::OfMaterial& material = surfaces.of_face(face);
        if (is_black(material.radiance))
            continue;
        const double sides = material.both_sides ? 2 : 1;
        const glm::dvec3 power =
            sides * kPi * glm::dvec3(surfaces.mean(face)) * face_area(mesh, face);
        if (power.x > 0 || power.y > 0 || power.z > 0)
            out.push_back({face, power});
    }
    return out;
}

/// A light for each object, in the order of their numbers.
void add_emissive_meshes(const SurfaceEmission& surfaces, const std::vector<FacePower>& faces,
                         std::vector<Light>& lights)
{
    std::map<ObjectId, std::vector<FacePower>> objects;
    for (const FacePower& face : faces)
        objects[surfaces.mesh->object_of(face.face)].push_back(face);
    for (const auto& [object, its_faces] : objects)
        lights.push_back(make_emissive_mesh(surfaces, its_faces));
}

} // namespace

LightSet collect_lights(const Scene& scene, const LightSources& sources)
{
    const SceneSphere sphere = sphere_around(scene.mesh);
    std::vector<Light> lights;
    for (const SceneLight& light : scene.lights)
        lights.push_back(std::visit(
            [&](const auto& of_kind) -> Light { return light_from(of_kind, sphere); }, light));
    const std::vector<FacePower> powers = powers_of_faces(sources.surfaces);
    add_emissive_meshes(sources.surfaces, powers, lights);
    if (sources.environment_map != nullptr && !sources.environment_map->empty())
        lights.push_back(ImageEnvironment{sources.environment_map, sphere});
    else if (!is_black(scene.environment))
        lights.push_back(ConstantEnvironment{scene.environment, sphere});
    if (sources.media != nullptr && sources.media->emits)
        lights.push_back(EmissiveMedia{sources.media});
    EmissiveMesh faces = make_emissive_mesh(sources.surfaces, powers);
    grow_tree(faces);
    return make_light_set(std::move(lights), std::move(faces));
}

} // namespace hipmap
