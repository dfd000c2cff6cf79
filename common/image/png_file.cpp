#include "common/image/png_file.h"

#include <png.h>
#include <zlib.h>

#include <cassert>
#include <csetjmp>
#include <new>

namespace hipmap {

namespace {

using Bytes = std::vector<std::byte>;

/// libpng is C: an exception must not pass through it, so png_error takes its jump.
void append(png_structp png, png_bytep data, std::size_t size)
{
    auto& bytes = *static_cast<Bytes*>(png_get_io_ptr(png));
    const auto* const first = reinterpret_cast<const std::byte*>(data);
    bool fits = true;
    try {
        bytes.insert(bytes.end(), first, first + size);
    } catch (const std::bad_alloc&) {
        fits = false;
    }
    if (!fits)
        png_error(png, "out of memory");
}

void jump(png_structp png, png_const_charp)
{
    png_longjmp(png, 1);
}

void ignore(png_structp, png_const_charp) {}

/// Returns whether all was written.  Nothing in here has a destructor, which a jump would leave
/// out.
bool write(png_structp png, png_infop info, int width, int height, const std::uint8_t* levels)
{
    if (setjmp(png_jmpbuf(png)) != 0)
        return false;
    png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
    png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), 8,
                 PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    png_write_info(png, info);
    for (int y = 0; y < height; ++y)
        png_write_row(png, levels + static_cast<std::size_t>(y) * width * 3);
    png_write_end(png, info);
    return true;
}

} // namespace

Bytes encode_png(int width, int height, std::span<const std::uint8_t> levels, PictureKind kind)
{
    assert(levels.size() == static_cast<std::size_t>(width) * height * 3);
    Bytes bytes;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, jump, ignore);
    png_infop info = png == nullptr ? nullptr : png_create_info_struct(png);
    bool written = false;
    if (info != nullptr) {
        png_set_write_fn(png, &bytes, append, nullptr);
        if (kind == PictureKind::render)
            png_set_compression_strategy(png, Z_RLE);
        written = write(png, info, width, height, levels.data());
    }
    png_destroy_write_struct(&png, &info);
    if (!written)
        throw std::bad_alloc();
    return bytes;
}

} // namespace hipmap
