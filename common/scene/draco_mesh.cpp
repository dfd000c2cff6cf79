#include "common/scene/draco_mesh.h"

#include <draco/compression/config/decoder_options.h>
#include <draco/compression/mesh/mesh_edgebreaker_decoder.h>
#include <draco/compression/mesh/mesh_sequential_decoder.h>
#include <draco/core/varint_decoding.h>

namespace hipmap {

namespace {

/// What a stream says of its connectivity, read ahead of decoding it.
bool is_credible(draco::DecoderBuffer ahead, int method, std::size_t size)
{
    const std::uint64_t most = size * kDracoElementsPerByte + kDracoSpare;
    std::uint32_t first = 0, second = 0;
    if (!draco::DecodeVarint(&first, &ahead) || !draco::DecodeVarint(&second, &ahead) ||
        first > most || second > most)
        return false;
    if (method == draco::MESH_SEQUENTIAL_ENCODING)
        return true;                    // faces and points
    std::uint8_t seamed_attributes = 0; // vertices and faces went before
    return ahead.Decode(&seamed_attributes) &&
           std::uint64_t{second} * (1 + seamed_attributes) <= most;
}

/// Draco's decoder of one method, which looks before it takes memory.
template <typename Decoder, int kMethod>
class BoundedDecoder final : public Decoder {
  public:
    explicit BoundedDecoder(std::size_t size) : size_(size) {}

  private:
    bool DecodeConnectivity() override
    {
        return is_credible(*this->buffer(), kMethod, size_) && Decoder::DecodeConnectivity();
    }

    bool DecodeAllAttributes() override
    {
        const draco::PointCloud& cloud = *this->point_cloud();
        std::uint64_t bytes_per_point = 0;
        for (int i = 0; i < cloud.num_attributes(); ++i)
            bytes_per_point += static_cast<std::uint64_t>(cloud.attribute(i)->byte_stride());
        return bytes_per_point * cloud.num_points() <= size_ * kDracoBytesPerByte + kDracoSpare &&
               Decoder::DecodeAllAttributes();
    }

    std::size_t size_;
};

using EdgebreakerDecoder =
    BoundedDecoder<draco::MeshEdgebreakerDecoder, draco::MESH_EDGEBREAKER_ENCODING>;
using SequentialDecoder =
    BoundedDecoder<draco::MeshSequentialDecoder, draco::MESH_SEQUENTIAL_ENCODING>;

bool has_good_indices(const draco::Mesh& mesh)
{
    for (draco::FaceIndex face(0); face < mesh.num_faces(); ++face)
        for (const draco::PointIndex& corner : mesh.face(face))
            if (corner.value() >= mesh.num_points())
                return false;
    return true;
}

} // namespace

std::unique_ptr<draco::Mesh> decode_draco(std::span<const unsigned char> data)
{
    draco::DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char*>(data.data()), data.size());
    draco::DecoderBuffer ahead = buffer;
    draco::DracoHeader header;
    if (!draco::PointCloudDecoder::DecodeHeader(&ahead, &header).ok() ||
        header.encoder_type != draco::TRIANGULAR_MESH ||
        header.version_major != draco::kDracoMeshBitstreamVersionMajor ||
        header.version_minor != draco::kDracoMeshBitstreamVersionMinor)
        return nullptr;
    std::unique_ptr<draco::MeshDecoder> decoder;
    if (header.encoder_method == draco::MESH_EDGEBREAKER_ENCODING)
        decoder = std::make_unique<EdgebreakerDecoder>(data.size());
    else
        decoder = std::make_unique<SequentialDecoder>(data.size());
    auto mesh = std::make_unique<draco::Mesh>();
    const bool good = decoder->Decode(draco::DecoderOptions(), &buffer, mesh.get()).ok();
    if (!good || !has_good_indices(*mesh))
        return nullptr;
    return mesh;
}

} // namespace hipmap
