#include "common/scene/gltf_meshopt.h"

#include "common/scene/raw_scene.h"

#include <meshoptimizer.h>

namespace hipmap {

namespace {

using nlohmann::json;

/// One compressed bufferView, as its extension describes it.
struct MeshoptView {
    std::string mode, filter;
    std::size_t count = 0, stride = 0;
    std::span<const unsigned char> encoded;
};

class MeshoptDecoder {
  public:
    MeshoptDecoder(const GltfDocument& document, tinygltf::Model& model)
        : document_(document), model_(model)
    {
        for (const tinygltf::Buffer& buffer : model.buffers)
            encoded_left_ += buffer.data.size();
    }

    void decode(std::size_t index)
    {
        tinygltf::BufferView& view = model_.bufferViews[index];
        place_ = "bufferViews[" + std::to_string(index) + "].extensions.EXT_meshopt_compression";
        const MeshoptView packed =
            describe(document_.json["bufferViews"][index]["extensions"]["EXT_meshopt_compression"]);
        check_kind(packed);
        check_size(packed, view.byteLength);
        std::vector<unsigned char> bytes(packed.count * packed.stride);
        if (unpack(packed, bytes.data()) != 0)
            fail("its data is damaged");
        apply_filter(packed, bytes.data());
        view.buffer = static_cast<int>(model_.buffers.size());
        view.byteOffset = 0;
        model_.buffers.emplace_back().data = std::move(bytes);
    }

  private:
    MeshoptView describe(const json& extension)
    {
        MeshoptView packed;
        packed.mode = extension["mode"].get<std::string>();
        packed.filter = extension.value("filter", std::string("NONE"));
        packed.count = extension["count"].get<std::size_t>();
        packed.stride = extension["byteStride"].get<std::size_t>();
        const auto offset = extension.value("byteOffset", std::size_t{0});
        const auto length = extension["byteLength"].get<std::size_t>();
        const std::vector<unsigned char>& data =
            model_.buffers[extension["buffer"].get<std::size_t>()].data;
        if (offset > data.size() || length > data.size() - offset)
            fail("runs past the end of its buffer");
        packed.encoded = std::span(data).subspan(offset, length);
        if (length > encoded_left_)
            fail("overlaps other compressed data");
        encoded_left_ -= length;
        return packed;
    }

    void check_kind(const MeshoptView& packed) const
    {
        const bool vertices = packed.mode == "ATTRIBUTES";
        if (!vertices && packed.mode != "TRIANGLES" && packed.mode != "INDICES")
            fail("has an unknown mode");
        const bool good_stride = vertices ? packed.stride >= 4 && packed.stride % 4 == 0
                                          : packed.stride == 2 || packed.stride == 4;
        if (!good_stride || (packed.mode == "TRIANGLES" && packed.count % 3 != 0))
            fail("has a byteStride or count that its mode does not allow");
        const bool good_filter =
            packed.filter == "NONE" ||
            (packed.filter == "OCTAHEDRAL" && (packed.stride == 4 || packed.stride == 8)) ||
            (packed.filter == "QUATERNION" && packed.stride == 8) || packed.filter == "EXPONENTIAL";
        if (!good_filter || (!vertices && packed.filter != "NONE"))
            fail("has an unknown filter, or one that does not go with its byteStride or mode");
    }

    /// Throws InputError if the view promises more than its bytes can hold.
    void check_size(const MeshoptView& packed, std::size_t view_length) const
    {
        const std::size_t most_elements = packed.mode == "ATTRIBUTES"
                                              ? packed.encoded.size() * 64 / packed.stride
                                          : packed.mode == "TRIANGLES" ? packed.encoded.size() * 3
                                                                       : packed.encoded.size();
        if (packed.count > most_elements)
            fail("promises more than its data can hold");
        if (packed.count * packed.stride != view_length)
            fail("does not decode to the length of its bufferView");
    }

    static int unpack(const MeshoptView& packed, unsigned char* out)
    {
        const auto [first, size] = std::pair(packed.encoded.data(), packed.encoded.size());
        if (packed.mode == "ATTRIBUTES")
            return meshopt_decodeVertexBuffer(out, packed.count, packed.stride, first, size);
        if (packed.mode == "TRIANGLES")
            return meshopt_decodeIndexBuffer(out, packed.count, packed.stride, first, size);
        return meshopt_decodeIndexSequence(out, packed.count, packed.stride, first, size);
    }

    static void apply_filter(const MeshoptView& packed, unsigned char* bytes)
    {
        if (packed.filter == "OCTAHEDRAL")
            meshopt_decodeFilterOct(bytes, packed.count, packed.stride);
        else if (packed.filter == "QUATERNION")
            meshopt_decodeFilterQuat(bytes, packed.count, packed.stride);
        else if (packed.filter == "EXPONENTIAL")
            meshopt_decodeFilterExp(bytes, packed.count, packed.stride);
    }

    [[noreturn]] void fail(const std::string& what) const
    {
        throw scene_error(document_.path, place_, what + "; the file is damaged, export it again");
    }

    const GltfDocument& document_;
    tinygltf::Model& model_;
    std::string place_;
    std::size_t encoded_left_ = 0; ///< bytes of the file that no view before has decoded
};

} // namespace

void decode_meshopt_views(const GltfDocument& document, tinygltf::Model& model)
{
    MeshoptDecoder decoder(document, model);
    for (std::size_t i = 0; i < model.bufferViews.size(); ++i) {
        if (has_extension(document.json["bufferViews"][i], "EXT_meshopt_compression"))
            decoder.decode(i);
    }
}

} // namespace hipmap
