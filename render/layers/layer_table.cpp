#include "render/layers/layer_table.h"

#include "render/film/image_error.h"
#include "render/shading/scatter.h"

namespace hipmap {

namespace {

/// What Blender has for a depth where nothing is.
constexpr float kNoDepth = 1e10f;

/// The mean of a map's number and of that of nothing would be another map's, so nothing is no
/// number of a map.
constexpr float kNoMap = -1;

/// The world of glTF has +y up, Blender's +z.
glm::vec4 to_blender(const glm::dvec3& vector)
{
    return glm::vec4(glm::vec3(glm::dvec3(vector.x, -vector.z, vector.y)), 0.0f);
}

float depth_along_view(const FirstSurface& surface)
{
    const Scene& scene = surface.scene.scene;
    const Camera& camera = scene.cameras[scene.camera];
    const glm::dvec3 away = glm::dvec3(surface.at.point.position) - glm::dvec3(camera.position);
    return static_cast<float>(glm::dot(away, glm::dvec3(camera.forward)) *
                              scene.frame.metres_per_unit);
}

glm::vec4 position_in_world(const FirstSurface& surface)
{
    const SceneFrame& frame = surface.scene.scene.frame;
    return to_blender(frame.centre + frame.metres_per_unit * glm::dvec3(surface.at.point.position));
}

glm::vec4 one(float value)
{
    return glm::vec4(value);
}

/// Numbers of objects and materials start at 1, as 0 is nothing.
glm::vec4 object_number(const FirstSurface& surface)
{
    return one(static_cast<float>(surface.scene.mesh().object_of(surface.at.point.face) + 1));
}

glm::vec4 material_number(const FirstSurface& surface)
{
    return one(static_cast<float>(surface.scene.mesh().material_of(surface.at.point.face) + 1));
}

glm::vec4 map_number(const FirstSurface& surface)
{
    const MapId map = surface.scene.partition.map_of(surface.at.point.face);
    return one(map == kNone ? kNoMap : static_cast<float>(map));
}

/// Without the layers over it, whose mean attenuation the reflectance of the lobe makes up for.
glm::vec4 diffuse_colour(const FirstSurface& surface)
{
    const Bsdf& bsdf = surface.at.bsdf();
    return {(bsdf.diffuse + bsdf.diffuse_transmitted) * bsdf.layers.diffuse_average, 0};
}

/// Returns the share that all lobes together scatter: at most 1, also where a layer adds to the
/// lobes below it.
glm::vec4 scattered_colour(const FirstSurface& surface)
{
    const SpecularLobes specular = specular_lobes(surface.at);
    const Rgb all = scattered_share(surface.at, Lobes::gathered) +
                    scattered_share(surface.at, Lobes::followed) + specular.mirror +
                    specular.transmit;
    return {glm::min(all, Rgb(1)), 0};
}

constexpr LayerRow kRows[] = {
    {"combined", "Combined", "RGBA", "the image; opacity is 1",
     OfFilm{[](const Image& image, const Film&) { return image; }}},
    {"depth", "Depth", "Z",
     "metres from the camera to the surface, along the view direction; 1e10: nothing",
     OfCentre{[](const FirstSurface& surface) { return one(depth_along_view(surface)); },
              kNoDepth}},
    {"position", "Position", "XYZ", "place of the surface, metres, +z up as in Blender",
     OfCentre{position_in_world}},
    {"normal", "Normal", "XYZ",
     "shading normal on the side of the camera, +z up as in Blender, averaged over the pixel",
     OfMean{[](const FirstSurface& surface) { return to_blender(surface.at.shading_normal); }}},
    {"diffuse-color", "DiffCol", "RGB",
     "diffuse colour of the surface, averaged over the pixel; black on metal and glass",
     OfMean{diffuse_colour}},
    {"denoising-albedo", "Denoising Albedo", "RGB",
     "share of light that the surface scatters, for denoisers, averaged over the pixel",
     OfMean{scattered_colour}},
    {"object-index", "IndexOB", "X", "number of the object in the file, from 1; 0: nothing",
     OfCentre{object_number}},
    {"material-index", "IndexMA", "X", "number of the material in the file, from 1; 0: nothing",
     OfCentre{material_number}},
    {"map", "Map ID", "X", "number of the shared map in the partition, from 0; -1: nothing",
     OfCentre{map_number, kNoMap}},
    {"noise", "Noise", "RGB", "standard error of the image, W/(m2 sr); needs two passes",
     OfFilm{[](const Image&, const Film& film) { return error_layers(film).noise; }, true}},
    {"error", "Error", "RGB", "estimated error of the image, W/(m2 sr); needs two passes",
     OfFilm{[](const Image&, const Film& film) { return error_layers(film).error; }, true}},
};

} // namespace

std::span<const LayerRow> layer_rows()
{
    return kRows;
}

} // namespace hipmap
