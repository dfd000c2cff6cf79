#include "render/film/state_bytes.h"

#include "common/file/output_file.h"
#include "common/input_error.h"
#include "render/film/byte_planes.h"
#include "render/film/zstd_result.h"

#include <xxhash.h>
#include <zstd.h>

#include <algorithm>
#include <stdexcept>

namespace hipmap {

namespace {

constexpr std::uint64_t kMark = 0x5354'5350'4d50'4948; // "HIPMPSTS"
/// Bytes before the compressed values, and after them.
constexpr std::size_t kHead = sizeof kMark + sizeof(std::uint32_t), kTail = sizeof(std::uint64_t);
/// What zstd's higher levels gain on noise is not worth their time.
constexpr int kLevel = 1;
/// Bounds the memory that a file can make the decompressor take: 8 MiB.
constexpr int kWindowLog = 23;
/// Sums whose bytes are reordered together.
constexpr std::uint64_t kSumsInBlock = std::uint64_t{3} << 15;

void require_no_error(std::size_t code)
{
    if (!zstd_succeeded(code))
        throw std::runtime_error(std::string("zstd: ") + ZSTD_getErrorName(code));
}

struct Free {
    void operator()(ZSTD_CCtx* context) const { ZSTD_freeCCtx(context); }
    void operator()(ZSTD_DCtx* context) const { ZSTD_freeDCtx(context); }
    void operator()(XXH3_state_t* state) const { XXH3_freeState(state); }
};

} // namespace

struct StateWriter::Output {
    WholeFile file;
    std::unique_ptr<ZSTD_CCtx, Free> context{require_made(ZSTD_createCCtx())};
    std::unique_ptr<XXH3_state_t, Free> checksum{require_made(XXH3_createState())};
    std::vector<std::byte> compressed = std::vector<std::byte>(ZSTD_CStreamOutSize());

    explicit Output(const std::filesystem::path& path) : file(path)
    {
        require_no_error(ZSTD_CCtx_setParameter(context.get(), ZSTD_c_compressionLevel, kLevel));
        XXH3_64bits_reset(checksum.get());
    }

    void write(std::span<const std::byte> bytes)
    {
        XXH3_64bits_update(checksum.get(), bytes.data(), bytes.size());
        file.write(bytes);
    }

    /// mode: ZSTD_e_end after the last bytes.
    void compress(std::span<const std::byte> bytes, ZSTD_EndDirective mode)
    {
        ZSTD_inBuffer in = {bytes.data(), bytes.size(), 0};
        std::size_t left = 0;
        do {
            ZSTD_outBuffer out = {compressed.data(), compressed.size(), 0};
            left = ZSTD_compressStream2(context.get(), &out, &in, mode);
            require_no_error(left);
            write({compressed.data(), out.pos});
        } while (mode == ZSTD_e_end ? left > 0 : in.pos < in.size);
    }
};

StateWriter::StateWriter(const std::filesystem::path& path, std::uint32_t version)
    : output_(std::make_unique<Output>(path))
{
    output_->write(std::as_bytes(std::span(&kMark, 1)));
    output_->write(std::as_bytes(std::span(&version, 1)));
}

StateWriter::~StateWriter() = default;

void StateWriter::append(std::span<const std::byte> bytes)
{
    output_->compress(bytes, ZSTD_e_continue);
}

void StateWriter::put_sums(const std::vector<std::int64_t>& sums)
{
    put(static_cast<std::uint64_t>(sums.size()));
    for (std::size_t at = 0; at < sums.size(); at += kSumsInBlock) {
        const std::size_t number = std::min<std::size_t>(kSumsInBlock, sums.size() - at);
        append(split_into_planes(std::span(sums).subspan(at, number)));
    }
}

void StateWriter::finish()
{
    output_->compress({}, ZSTD_e_end);
    const std::uint64_t checksum = XXH3_64bits_digest(output_->checksum.get());
    output_->file.write(std::as_bytes(std::span(&checksum, 1)));
    output_->file.commit();
}

struct StateReader::Input {
    InputFile file;
    std::uint32_t version = 0;
    std::uint64_t left = 0; ///< compressed bytes that are not in the buffer yet
    std::vector<std::byte> buffer = std::vector<std::byte>(kPart);
    ZSTD_inBuffer compressed = {}; ///< of the buffer
    std::unique_ptr<ZSTD_DCtx, Free> context{require_made(ZSTD_createDCtx())};
    bool ended = false; ///< the compressed values

    explicit Input(const std::filesystem::path& path) : file(path) {}

    /// Returns the next bytes, up to `most`; fewer than a buffer only if the file was cut short.
    std::span<const std::byte> next(std::uint64_t most)
    {
        return std::span(buffer).first(
            file.read(std::span(buffer).first(std::min<std::uint64_t>(most, buffer.size()))));
    }

    /// Fills the buffer once it is used up.
    void fill()
    {
        if (compressed.pos < compressed.size || left == 0)
            return;
        const std::span<const std::byte> bytes = next(left);
        compressed = {bytes.data(), bytes.size(), 0};
        left = bytes.empty() ? 0 : left - bytes.size();
    }

    /// Bytes that no value was read from yet.
    std::uint64_t rest() const { return left + compressed.size - compressed.pos; }
};

StateReader::StateReader(const std::filesystem::path& path)
    : input_(std::make_unique<Input>(path)), path_(path.string())
{
    const std::span<const std::byte> head = input_->next(kHead);
    std::uint64_t mark = 0;
    if (head.size() >= sizeof mark)
        std::memcpy(&mark, head.data(), sizeof mark);
    if (mark != kMark)
        throw InputError(path_ + ": not a state file; give a file written by --state");
    require(head.size() == kHead && input_->file.size() >= kHead + kTail, "length");
    std::memcpy(&input_->version, &head[sizeof kMark], sizeof input_->version);
}

std::uint32_t StateReader::version() const
{
    return input_->version;
}

void StateReader::begin()
{
    const std::uint64_t checked = input_->file.size() - kTail;
    const std::unique_ptr<XXH3_state_t, Free> sum(require_made(XXH3_createState()));
    XXH3_64bits_reset(sum.get());
    input_->file.seek(0);
    for (std::uint64_t left = checked; left > 0;) {
        const std::span<const std::byte> bytes = input_->next(left);
        require(!bytes.empty(), "length");
        XXH3_64bits_update(sum.get(), bytes.data(), bytes.size());
        left -= bytes.size();
    }
    std::uint64_t checksum = 0;
    const std::span<const std::byte> tail = input_->next(sizeof checksum);
    require(tail.size() == sizeof checksum, "length");
    std::memcpy(&checksum, tail.data(), sizeof checksum);
    require(checksum == XXH3_64bits_digest(sum.get()), "checksum");
    input_->file.seek(kHead);
    input_->left = checked - kHead;
    require_no_error(
        ZSTD_DCtx_setParameter(input_->context.get(), ZSTD_d_windowLogMax, kWindowLog));
}

StateReader::~StateReader() = default;

void StateReader::require(bool right, const char* what) const
{
    if (!right)
        throw InputError(path_ + ": damaged state file (" + what +
                         " is wrong); use a copy, or another file name");
}

void StateReader::take(std::span<std::byte> into)
{
    ZSTD_outBuffer out = {into.data(), into.size(), 0};
    while (out.pos < out.size) {
        require(!input_->ended, "length");
        input_->fill();
        const std::size_t before = input_->compressed.pos + out.pos;
        const std::size_t left =
            ZSTD_decompressStream(input_->context.get(), &out, &input_->compressed);
        require(zstd_succeeded(left), "compression");
        input_->ended = left == 0;
        require(input_->ended || input_->compressed.pos + out.pos > before, "length");
    }
}

bool StateReader::at_end()
{
    std::byte none{};
    ZSTD_outBuffer out = {&none, 1, 0};
    while (!input_->ended && input_->rest() > 0) {
        input_->fill();
        const std::size_t left =
            ZSTD_decompressStream(input_->context.get(), &out, &input_->compressed);
        require(zstd_succeeded(left), "compression");
        if (out.pos > 0)
            return false;
        input_->ended = left == 0;
    }
    return input_->ended && input_->rest() == 0;
}

/// Returns how many sums to make room for where there are to be `least` and maybe more: as many as
/// the rest of the file can hold if it is compressed as states are, so that none is copied; or
/// twice the least, so that a damaged number takes no memory.
std::uint64_t StateReader::room_for(std::uint64_t least) const
{
    constexpr std::uint64_t kMostCompressed = 16;
    return std::max(2 * least, kMostCompressed * input_->rest() / sizeof(std::int64_t));
}

std::vector<std::int64_t> StateReader::get_sums(std::uint64_t number)
{
    require(get<std::uint64_t>() == number, "number of sums");
    std::vector<std::int64_t> sums;
    std::vector<std::byte> planes;
    for (std::uint64_t left = number; left > 0;) {
        const std::uint64_t part = std::min(left, kSumsInBlock);
        planes.resize(part * sizeof(std::int64_t));
        take(planes);
        if (sums.capacity() < sums.size() + part)
            sums.reserve(std::min(number, room_for(sums.size() + part)));
        sums.resize(sums.size() + part);
        join_planes(planes, std::span(sums).last(part));
        left -= part;
    }
    return sums;
}

} // namespace hipmap
