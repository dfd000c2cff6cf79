#include "common/scene/gltf_sharing.h"

#include <algorithm>

namespace hipmap {

namespace {

/// Shapes of one mesh, each stored: instances that are scaled unevenly or mirrored in more ways
/// than this are stored one by one.
constexpr std::size_t kMostShapes = 16;

/// The size of a copy over that of the stored faces, at most, and at least one over it.
constexpr double kMostScale = 2.0;

bool is_plain(const Material& material)
{
    return is_black(material.emission) && material.transmission == 0 && !material.holds_medium() &&
           material.inside().is_clear();
}

} // namespace

GltfSharing::GltfSharing(const tinygltf::Model& model, const RawScene& scene)
    : model_(model), may_share_(model.meshes.size(), 1), allowed_(model.meshes.size(), 0),
      stored_(model.meshes.size())
{
    for (std::size_t mesh = 0; mesh < model.meshes.size(); ++mesh)
        for (const tinygltf::Primitive& primitive : model.meshes[mesh].primitives)
            if (!primitive.targets.empty() ||
                (primitive.material >= 0 &&
                 !is_plain(scene.materials[static_cast<std::size_t>(primitive.material)])))
                may_share_[mesh] = 0;
}

bool GltfSharing::may_share(const tinygltf::Node& node) const
{
    return node.mesh >= 0 && node.skin < 0 && may_share_[static_cast<std::size_t>(node.mesh)] != 0;
}

bool GltfSharing::add_copy(int mesh, const glm::dmat4& to_world, RawScene& scene)
{
    for (const Stored& stored : stored_[static_cast<std::size_t>(mesh)]) {
        const std::optional<Similarity> place = to_similarity(to_world * stored.from_world);
        if (!place || place->scale > kMostScale || place->scale < 1 / kMostScale)
            continue;
        scene.copies.push_back(
            {stored.shared, static_cast<ObjectId>(scene.objects.size() - 1), *place});
        return true;
    }
    return false;
}

void GltfSharing::add_stored(int mesh, const glm::dmat4& to_world, const SharedFaces& faces,
                             RawScene& scene)
{
    std::vector<Stored>& shapes = stored_[static_cast<std::size_t>(mesh)];
    if (shapes.size() == kMostShapes || faces.count == 0)
        return;
    shapes.push_back({glm::inverse(to_world), static_cast<std::uint32_t>(scene.shared.size())});
    scene.shared.push_back(faces);
}

} // namespace hipmap
