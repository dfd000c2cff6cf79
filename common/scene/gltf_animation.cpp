#include "common/scene/gltf_animation.h"

#include "common/scene/gltf_accessor.h"
#include "common/scene/scene_names.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

namespace hipmap {

namespace {

using nlohmann::json;

std::string name_of(const json& thing, const char* kind, std::size_t index)
{
    const std::string name = clean_name(thing.value("name", std::string()));
    return name.empty() ? std::string(kind) + " " + std::to_string(index) : name;
}

/// Reads the channels of one animation.
class ChannelReader {
  public:
    ChannelReader(const GltfDocument& document, const tinygltf::Model& model, std::size_t index)
        : document_(document), model_(model), animation_(document.json["animations"][index]),
          place_("animations[" + std::to_string(index) + "]")
    {
    }

    /// part: none if the channel drives something else.
    static std::optional<NodePart> part_of(const json& channel)
    {
        const std::string path = channel["target"]["path"];
        if (!channel["target"].contains("node"))
            return std::nullopt;
        if (path == "translation")
            return NodePart::translation;
        if (path == "rotation")
            return NodePart::rotation;
        if (path == "weights")
            return NodePart::weight;
        return path == "scale" ? std::optional(NodePart::scale) : std::nullopt;
    }

    /// The channels of all morph targets for weights, else one.
    std::vector<AnimationChannel> read(const json& channel, NodePart part) const
    {
        if (part != NodePart::weight)
            return {read_transform(channel, part)};
        const auto [first, place, output] = read_keys(channel);
        const std::size_t each = values_of_key(first), targets = target_count(first.node);
        const GltfAccessor values(model_, output, document_.path);
        if (values.type() != TINYGLTF_TYPE_SCALAR)
            fail(place, "has values of the wrong type for its target");
        if (first.times.empty() || values.size() != each * first.times.size() * targets)
            fail(place, "has a different number of values, times and morph targets");
        std::vector<AnimationChannel> out(targets, first);
        for (std::size_t i = 0; i < values.size(); ++i) {
            AnimationChannel& of = out[i % targets];
            of.part = part;
            of.target = i % targets;
            of.values.emplace_back(values.scalar(i), 0, 0, 0);
            if (!std::isfinite(of.values.back().x))
                fail(place, "has a value that is not finite");
        }
        return out;
    }

  private:
    static std::size_t values_of_key(const AnimationChannel& channel)
    {
        return channel.interpolation == Interpolation::cubic ? 3 : 1;
    }

    std::size_t target_count(std::size_t node) const
    {
        const int mesh = model_.nodes[node].mesh;
        if (mesh < 0)
            return 0;
        const auto& primitives = model_.meshes[static_cast<std::size_t>(mesh)].primitives;
        return primitives.empty() ? 0 : primitives[0].targets.size();
    }

    /// A channel without its values.
    struct Keys {
        AnimationChannel channel;
        std::string place; ///< of its sampler
        int output = 0;    ///< accessor of the values
    };

    Keys read_keys(const json& channel) const
    {
        AnimationChannel out;
        out.node = channel["target"]["node"];
        const std::size_t index = channel["sampler"];
        const std::string place = place_ + ".samplers[" + std::to_string(index) + "]";
        if (!animation_.contains("samplers") || index >= animation_["samplers"].size())
            fail(place, "is not in the file");
        const json& sampler = animation_["samplers"][index];
        out.interpolation = interpolation_of(sampler, place);
        out.times = read_times(sampler["input"], place);
        return {std::move(out), place, sampler["output"]};
    }

    AnimationChannel read_transform(const json& channel, NodePart part) const
    {
        auto [out, place, output] = read_keys(channel);
        out.part = part;
        if (model_.nodes[out.node].matrix.size() == 16)
            fail("nodes[" + std::to_string(out.node) + "]", "is animated and has a matrix");
        out.values = read_values(output, part, place);
        if (out.times.empty() || out.values.size() != values_of_key(out) * out.times.size())
            fail(place, "has a different number of values and times");
        return out;
    }

    Interpolation interpolation_of(const json& sampler, const std::string& place) const
    {
        const std::string name = sampler.value("interpolation", std::string("LINEAR"));
        if (name == "LINEAR")
            return Interpolation::linear;
        if (name == "STEP")
            return Interpolation::step;
        if (name != "CUBICSPLINE")
            fail(place, "has an unknown interpolation");
        return Interpolation::cubic;
    }

    std::vector<double> read_times(int index, const std::string& place) const
    {
        const GltfAccessor accessor(model_, index, document_.path);
        if (accessor.type() != TINYGLTF_TYPE_SCALAR)
            fail(place, "has times that are not numbers");
        std::vector<double> times;
        for (std::size_t i = 0; i < accessor.size(); ++i) {
            times.push_back(accessor.scalar(i));
            if (!std::isfinite(times.back()) || (i > 0 && times[i] < times[i - 1]))
                fail(place, "has times that decrease or are not finite");
        }
        return times;
    }

    std::vector<glm::dvec4> read_values(int index, NodePart part, const std::string& place) const
    {
        const GltfAccessor accessor(model_, index, document_.path);
        const bool turns = part == NodePart::rotation;
        if (accessor.type() != (turns ? TINYGLTF_TYPE_VEC4 : TINYGLTF_TYPE_VEC3))
            fail(place, "has values of the wrong type for its target");
        std::vector<glm::dvec4> values;
        for (std::size_t i = 0; i < accessor.size(); ++i) {
            values.push_back(turns ? accessor.vec4(i) : glm::dvec4(accessor.vec3(i), 0.0));
            for (int c = 0; c < 4; ++c)
                if (!std::isfinite(values.back()[c]))
                    fail(place, "has a value that is not finite");
        }
        return values;
    }

    [[noreturn]] void fail(const std::string& place, const std::string& what) const
    {
        throw scene_error(document_.path, place, what + "; the file is damaged, export it again");
    }

    const GltfDocument& document_;
    const tinygltf::Model& model_;
    const json& animation_;
    std::string place_;
};

/// Spherical interpolation along the shorter arc, of quaternions of any length.
glm::dvec4 slerp(glm::dvec4 a, glm::dvec4 b, double part)
{
    const double length = glm::length(a) * glm::length(b);
    if (!(length > 0))
        return part < 1 ? a : b;
    a = glm::normalize(a);
    b = glm::normalize(b);
    if (glm::dot(a, b) < 0)
        b = -b;
    // Of half the sum and half the difference the angle is found without loss at both its ends.
    const double angle = 2 * std::atan2(glm::length(a - b), glm::length(a + b));
    if (std::sin(angle) == 0.0)
        return a;
    return (std::sin((1 - part) * angle) * a + std::sin(part * angle) * b) / std::sin(angle);
}

/// Hermite's cubic between keys `k` and k + 1, which are `span` s apart.
glm::dvec4 hermite(const std::vector<glm::dvec4>& values, std::size_t k, double s, double span)
{
    const glm::dvec4 &from = values[3 * k + 1], &leave = values[3 * k + 2];
    const glm::dvec4 &arrive = values[3 * k + 3], &to = values[3 * k + 4];
    const double s2 = s * s, s3 = s2 * s;
    return (2 * s3 - 3 * s2 + 1) * from + span * (s3 - 2 * s2 + s) * leave +
           (3 * s2 - 2 * s3) * to + span * (s3 - s2) * arrive;
}

void note(GltfAnimation& animation, SceneAudit& audit, const std::vector<std::string>& second,
          const std::set<std::string>& unread)
{
    if (!second.empty())
        audit.assumed.push_back("animation " + list_names(second) +
                                " moves the same nodes as an earlier one and is ignored for them");
    for (const std::string& path : unread)
        audit.warnings.push_back("not read yet: animation of " + quote_name(clean_name(path)));
    for (const AnimationChannel& channel : animation.channels) {
        const bool is_first = &channel == &animation.channels.front();
        animation.first =
            is_first ? channel.times.front() : std::min(animation.first, channel.times.front());
        animation.last =
            is_first ? channel.times.back() : std::max(animation.last, channel.times.back());
    }
}

} // namespace

GltfAnimation read_gltf_animation(const GltfDocument& document, const tinygltf::Model& model,
                                  SceneAudit& audit)
{
    GltfAnimation out;
    const auto animations = document.json.find("animations");
    if (animations == document.json.end())
        return out;
    std::set<std::pair<std::size_t, NodePart>> driven;
    std::vector<std::string> second;
    std::set<std::string> unread;
    for (std::size_t i = 0; i < animations->size(); ++i) {
        const json& animation = (*animations)[i];
        const ChannelReader reader(document, model, i);
        out.names.push_back(name_of(animation, "animation", i));
        for (const json& channel : animation["channels"]) {
            const std::optional<NodePart> part = ChannelReader::part_of(channel);
            if (!part) {
                unread.insert(channel["target"]["path"]);
                continue;
            }
            std::vector<AnimationChannel> read = reader.read(channel, *part);
            if (read.empty())
                continue;
            const std::size_t node = read.front().node;
            if (!driven.insert({node, *part}).second) {
                second.push_back(out.names.back());
                continue;
            }
            out.moved.push_back(name_of(document.json["nodes"][node], "node", node));
            std::move(read.begin(), read.end(), std::back_inserter(out.channels));
        }
    }
    note(out, audit, second, unread);
    return out;
}

glm::dvec4 value_at(const AnimationChannel& channel, double time)
{
    const std::vector<double>& times = channel.times;
    const auto value = [&](std::size_t key) {
        return channel.values[channel.interpolation == Interpolation::cubic ? 3 * key + 1 : key];
    };
    if (!(time >= times.front()))
        return value(0);
    if (time >= times.back())
        return value(times.size() - 1);
    const auto after = std::upper_bound(times.begin(), times.end(), time);
    const auto k = static_cast<std::size_t>(after - times.begin()) - 1;
    const double span = times[k + 1] - times[k];
    const double part = (time - times[k]) / span;
    switch (channel.interpolation) {
    case Interpolation::step:
        return value(k);
    case Interpolation::cubic:
        return hermite(channel.values, k, part, span);
    case Interpolation::linear:
        break;
    }
    return channel.part == NodePart::rotation ? slerp(value(k), value(k + 1), part)
                                              : value(k) + part * (value(k + 1) - value(k));
}

void pose_nodes(const GltfAnimation& animation, double time, tinygltf::Model& model)
{
    for (const AnimationChannel& channel : animation.channels) {
        tinygltf::Node& node = model.nodes[channel.node];
        const glm::dvec4 v = value_at(channel, time);
        switch (channel.part) {
        case NodePart::rotation:
            node.rotation = {v.x, v.y, v.z, v.w};
            break;
        case NodePart::weight:
            node.weights.resize(std::max(node.weights.size(), channel.target + 1), 0.0);
            node.weights[channel.target] = v.x;
            break;
        case NodePart::translation:
            node.translation = {v.x, v.y, v.z};
            break;
        case NodePart::scale:
            node.scale = {v.x, v.y, v.z};
            break;
        }
    }
}

} // namespace hipmap
