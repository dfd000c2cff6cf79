#include "common/image/exr_file.h"

#include "common/file/output_file.h"
#include "common/input_error.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfThreading.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstring>
#include <exception>
#include <stdexcept>
#include <vector>

namespace hipmap {

namespace {

constexpr std::array<const char*, 3> kChannelNames = {"R", "G", "B"};
/// The attribute and the value by which Blender knows files whose channels are named layer, pass
/// and component.
constexpr const char* kBlenderAttribute = "BlenderMultiChannel";
constexpr const char* kBlenderNames = "Blender V2.55.1 and newer";

/// Keeps what is written, so that the file is made in one step.
class MemoryOutput : public Imf::OStream {
  public:
    MemoryOutput() : OStream("") {}

    void write(const char c[], int n) override
    {
        const std::size_t end = at_ + static_cast<std::size_t>(n);
        if (end > bytes_.size())
            bytes_.resize(end);
        std::memcpy(bytes_.data() + at_, c, static_cast<std::size_t>(n));
        at_ = end;
    }
    std::uint64_t tellp() override { return at_; }
    void seekp(std::uint64_t position) override { at_ = position; }

    std::span<const std::byte> bytes() const { return bytes_; }

  private:
    std::vector<std::byte> bytes_;
    std::size_t at_ = 0;
};

class MemoryInput : public Imf::IStream {
  public:
    explicit MemoryInput(std::span<const std::byte> bytes) : IStream(""), bytes_(bytes) {}

    bool read(char c[], int n) override
    {
        const auto count = static_cast<std::size_t>(n);
        if (n < 0 || at_ > bytes_.size() || count > bytes_.size() - at_)
            throw std::runtime_error("the file ends too early");
        std::memcpy(c, bytes_.data() + at_, count);
        at_ += count;
        return at_ < bytes_.size();
    }
    std::uint64_t tellg() override { return at_; }
    void seekg(std::uint64_t position) override { at_ = position; }

  private:
    std::span<const std::byte> bytes_;
    std::size_t at_ = 0;
};

std::string channel_name(std::string_view layer, std::size_t channel)
{
    return (layer.empty() ? "" : std::string(layer) + ".") + kChannelNames[channel];
}

/// Lets the three channels of `layer` be read from or written to `image`, whose first pixel is at
/// (x0, y0) of the file.
void insert_slices(Imf::FrameBuffer& buffer, Image& image, std::string_view layer, int x0, int y0)
{
    const std::size_t column = sizeof(Rgb);
    const std::size_t row = column * static_cast<std::size_t>(image.width);
    for (std::size_t c = 0; c < kChannelNames.size(); ++c) {
        auto* base = reinterpret_cast<char*>(&image.pixels.front()[static_cast<int>(c)]);
        const Imath::V2i origin(x0, y0);
        buffer.insert(
            channel_name(layer, c),
            Imf::Slice::Make(Imf::FLOAT, base, origin, image.width, image.height, column, row));
    }
}

float finite_or_zero(float value)
{
    return std::isfinite(value) ? value : 0.0f;
}

Image finite_copy(const Image& image)
{
    Image copy = image;
    for (Rgb& pixel : copy.pixels)
        for (int c = 0; c < 3; ++c)
            pixel[c] = finite_or_zero(pixel[c]);
    return copy;
}

Imf::Header header_of(const ExrWindow& window)
{
    const ImagePlace& place = window.place;
    const bool whole = place.whole_width == 0;
    Imf::Header header(whole ? window.width : place.whole_width,
                       whole ? window.height : place.whole_height);
    header.dataWindow() = {{place.x, place.y},
                           {place.x + window.width - 1, place.y + window.height - 1}};
    header.compression() = Imf::ZIP_COMPRESSION;
    return header;
}

/// The threads that compress a file: as many as oneTBB may use.  0: this one, as there are no more.
int compressing_threads()
{
    using Control = tbb::global_control;
    const auto wanted = static_cast<int>(Control::active_value(Control::max_allowed_parallelism));
    if (wanted < 2)
        return 0;
    try {
        if (Imf::globalThreadCount() < wanted)
            Imf::setGlobalThreadCount(wanted);
    } catch (const std::exception&) { // the system gives no more threads
        return 0;
    }
    return wanted;
}

/// Writes what the buffer shows, as many rows as the header promises, in one step.
void write_slices(const std::filesystem::path& path, const Imf::Header& header,
                  const Imf::FrameBuffer& buffer)
{
    MemoryOutput stream;
    {
        // Its destructor writes the table of offsets.
        Imf::OutputFile file(stream, header, compressing_threads());
        file.setFrameBuffer(buffer);
        file.writePixels(header.dataWindow().max.y - header.dataWindow().min.y + 1);
    }
    write_file(path, stream.bytes());
}

void check_channels(const Imf::Header& header, std::string_view layer)
{
    for (std::size_t c = 0; c < kChannelNames.size(); ++c) {
        const std::string name = channel_name(layer, c);
        const Imf::Channel* channel = header.channels().findChannel(name);
        if (channel == nullptr)
            throw std::runtime_error("it has no channel " + name);
        if (channel->xSampling != 1 || channel->ySampling != 1)
            throw std::runtime_error("channel " + name + " is subsampled");
    }
}

Image read_exr_bytes(std::span<const std::byte> bytes, std::string_view layer)
{
    MemoryInput stream(bytes);
    Imf::InputFile file(stream, 0);
    check_channels(file.header(), layer);
    const Imath::Box2i window = file.header().dataWindow();
    const std::int64_t width = std::int64_t(window.max.x) - window.min.x + 1;
    const std::int64_t height = std::int64_t(window.max.y) - window.min.y + 1;
    if (!is_plausible_size(width, height))
        throw std::runtime_error("its size is not plausible");

    Image image(static_cast<int>(width), static_cast<int>(height));
    Imf::FrameBuffer buffer;
    insert_slices(buffer, image, layer, window.min.x, window.min.y);
    file.setFrameBuffer(buffer);
    file.readPixels(window.min.y, window.max.y);
    return image;
}

} // namespace

void write_exr(const std::filesystem::path& path, const Image& image, std::span<const Layer> layers,
               const ImagePlace& place)
{
    std::vector<std::string> names = {""};
    std::vector<Image> images = {finite_copy(image)};
    for (const Layer& layer : layers) {
        assert(layer.image->width == image.width && layer.image->height == image.height);
        names.push_back(layer.name);
        images.push_back(finite_copy(*layer.image));
    }

    Imf::Header header = header_of({image.width, image.height, place});
    Imf::FrameBuffer buffer;
    for (std::size_t i = 0; i < images.size(); ++i) {
        for (std::size_t c = 0; c < kChannelNames.size(); ++c)
            header.channels().insert(channel_name(names[i], c), Imf::Channel(Imf::FLOAT));
        insert_slices(buffer, images[i], names[i], place.x, place.y);
    }
    write_slices(path, header, buffer);
}

void write_exr_channels(const std::filesystem::path& path, const ExrWindow& window,
                        std::span<const ExrChannel> channels)
{
    Imf::Header header = header_of(window);
    header.insert(kBlenderAttribute, Imf::StringAttribute(kBlenderNames));
    Imf::FrameBuffer buffer;
    const auto pixels = static_cast<std::size_t>(window.width) * window.height;
    const Imath::V2i origin(window.place.x, window.place.y);
    std::vector<std::vector<float>> copies;
    for (const ExrChannel& channel : channels) {
        std::vector<float>& copy = copies.emplace_back(pixels);
        for (std::size_t i = 0; i < pixels; ++i)
            copy[i] = finite_or_zero(channel.first[i * channel.stride]);
        header.channels().insert(channel.name, Imf::Channel(Imf::FLOAT));
        buffer.insert(channel.name, Imf::Slice::Make(Imf::FLOAT, copy.data(), origin, window.width,
                                                     window.height));
    }
    write_slices(path, header, buffer);
}

Image read_exr(const std::filesystem::path& path, std::string_view layer)
{
    const std::vector<std::byte> bytes = read_file(path);
    try {
        return read_exr_bytes(bytes, layer);
    } catch (const std::exception& error) {
        std::string cause = error.what();
        std::replace(cause.begin(), cause.end(), '\n', ' ');
        throw InputError(path.string() + ": cannot be read as EXR (" + cause +
                         "); export it again as OpenEXR with channels R, G and B");
    }
}

} // namespace hipmap
