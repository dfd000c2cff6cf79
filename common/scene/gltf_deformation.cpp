#include "common/scene/gltf_deformation.h"

#include "common/scene/raw_scene.h"

namespace hipmap {

namespace {

constexpr int kJointsPerSet = 4;

/// Nothing else bounds what targets that share accessors make us allocate.
std::size_t most_displacements(const tinygltf::Model& model)
{
    std::size_t bytes = 0;
    for (const tinygltf::Buffer& buffer : model.buffers)
        bytes += buffer.data.size();
    return bytes;
}

class DeformationReader {
  public:
    DeformationReader(const PrimitivePlace& at, const UsedVertices& used)
        : at_(at), used_(used), room_(most_displacements(at.model))
    {
    }

    MorphTarget read_target(std::size_t index)
    {
        const std::string place = "targets[" + std::to_string(index) + "].";
        MorphTarget out;
        for (const auto& [name, accessor] : at_.primitive.targets[index]) {
            std::vector<Displacement>* const into = name == "POSITION"  ? &out.positions
                                                    : name == "NORMAL"  ? &out.normals
                                                    : name == "TANGENT" ? &out.tangents
                                                                        : nullptr;
            if (into != nullptr)
                *into = read_displacements({place + name, accessor, {TINYGLTF_TYPE_VEC3}});
        }
        return out;
    }

    /// Reads all sets of joints that come with weights.
    void read_joints(GltfDeformation& out) const
    {
        std::vector<std::vector<glm::dvec4>> joints, weights;
        for (std::size_t set = 0;; ++set) {
            const auto joint = at_.primitive.attributes.find("JOINTS_" + std::to_string(set));
            const auto weight = at_.primitive.attributes.find("WEIGHTS_" + std::to_string(set));
            if (joint == at_.primitive.attributes.end() || weight == at_.primitive.attributes.end())
                break;
            for (const auto& [found, into] : {std::pair{joint, &joints}, {weight, &weights}})
                into->push_back(read_vertex_values(
                    at_, {found->first, found->second, {TINYGLTF_TYPE_VEC4}}, used_));
        }
        out.joints_per_vertex = joints.size() * kJointsPerSet;
        for (std::size_t v = 0; v < used_.vertices.size() && !joints.empty(); ++v)
            add_shares(joints, weights, v, out.shares);
    }

  private:
    std::vector<Displacement> read_displacements(const AttributeSource& from)
    {
        std::vector<Displacement> out;
        const std::vector<glm::dvec4> all = read_vertex_values(at_, from, used_);
        for (std::size_t v = 0; v < all.size(); ++v)
            if (glm::dvec3(all[v]) != glm::dvec3(0.0))
                out.push_back({static_cast<std::uint32_t>(v), glm::vec3(all[v])});
        if (out.size() > room_)
            throw scene_error(at_.path, at_.place + "." + from.name,
                              "moves more vertices than the file has data for; the file is "
                              "damaged, export it again");
        room_ -= out.size();
        return out;
    }

    /// A vertex without a weight follows its first joint.
    void add_shares(const std::vector<std::vector<glm::dvec4>>& joints,
                    const std::vector<std::vector<glm::dvec4>>& weights, std::size_t vertex,
                    std::vector<JointShare>& shares) const
    {
        double sum = 0;
        for (const std::vector<glm::dvec4>& set : weights)
            for (int c = 0; c < kJointsPerSet; ++c)
                sum += std::max(0.0, set[vertex][c]);
        for (std::size_t set = 0; set < joints.size(); ++set)
            for (int c = 0; c < kJointsPerSet; ++c) {
                const double joint = joints[set][vertex][c];
                if (!(joint >= 0))
                    throw scene_error(at_.path, at_.place + ".JOINTS_" + std::to_string(set),
                                      "must not be negative; the file is damaged, export it again");
                const bool first = set == 0 && c == 0;
                const double share =
                    sum > 0 ? std::max(0.0, weights[set][vertex][c]) / sum : (first ? 1.0 : 0.0);
                shares.push_back({static_cast<std::uint32_t>(joint), static_cast<float>(share)});
            }
    }

    const PrimitivePlace& at_;
    const UsedVertices& used_;
    std::size_t room_;
};

} // namespace

GltfDeformation read_deformation(const PrimitivePlace& at, const UsedVertices& used)
{
    GltfDeformation out;
    DeformationReader read(at, used);
    for (std::size_t i = 0; i < at.primitive.targets.size(); ++i)
        out.targets.push_back(read.read_target(i));
    read.read_joints(out);
    return out;
}

} // namespace hipmap
