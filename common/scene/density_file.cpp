#include "common/scene/density_file.h"

#include "common/file/output_file.h"
#include "common/input_error.h"

#include <bit>
#include <cmath>
#include <cstring>
#include <string>

namespace hipmap {

namespace {

static_assert(std::endian::native == std::endian::little);

/// "VOL", version, encoding, three sizes, channels, and the six numbers of a box.
constexpr std::size_t kHeader = 48;
constexpr std::uint32_t kFloats = 1; ///< the encoding
constexpr char kStart[] = {'V', 'O', 'L', 3};

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& what)
{
    throw InputError(path.string() + ": " + what);
}

std::uint32_t number_at(const std::vector<std::byte>& bytes, std::size_t at)
{
    std::uint32_t out = 0;
    std::memcpy(&out, bytes.data() + at, sizeof out);
    return out;
}

void check_header(const std::filesystem::path& path, const std::vector<std::byte>& bytes)
{
    if (bytes.size() < kHeader || std::memcmp(bytes.data(), kStart, sizeof kStart) != 0)
        fail(path, "not a density grid; write a .vol file of Mitsuba 0.6, version 3");
    if (number_at(bytes, 4) != kFloats || number_at(bytes, 20) != 1)
        fail(path, "bytes 4 to 23: not 32-bit floats of one channel; write encoding 1, 1 channel");
}

template <typename T>
void append(std::string& bytes, const T& value)
{
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

} // namespace

std::shared_ptr<const DensityGrid> read_density(const std::filesystem::path& path)
{
    const std::vector<std::byte> bytes = read_file(path);
    check_header(path, bytes);
    auto grid = std::make_shared<DensityGrid>();
    grid->nodes = {number_at(bytes, 8), number_at(bytes, 12), number_at(bytes, 16)};
    std::uint64_t count = 1;
    for (int axis = 0; axis < 3; ++axis) {
        if (grid->nodes[axis] < 2 || grid->nodes[axis] > kMostDensityNodes)
            fail(path, "bytes 8 to 19: from 2 to 16,384 values are needed along each axis");
        count *= grid->nodes[axis];
    }
    if (bytes.size() - kHeader != count * sizeof(float))
        fail(path, "has " + std::to_string(bytes.size() - kHeader) + " bytes of values, but " +
                       std::to_string(count * sizeof(float)) + " by its sizes; write it again");
    grid->values.resize(count);
    std::memcpy(grid->values.data(), bytes.data() + kHeader, count * sizeof(float));
    for (std::size_t i = 0; i < count; ++i)
        if (!(grid->values[i] >= 0) || !std::isfinite(grid->values[i]))
            fail(path, "value " + std::to_string(i) +
                           " is negative or not finite; densities must be 0 or more");
    return grid;
}

void write_density(const std::filesystem::path& path, const DensityGrid& grid, const glm::vec3& low,
                   const glm::vec3& high)
{
    std::string bytes(kStart, sizeof kStart);
    append(bytes, kFloats);
    append(bytes, grid.nodes);
    append(bytes, std::uint32_t{1}); // channels
    append(bytes, low);
    append(bytes, high);
    bytes.append(reinterpret_cast<const char*>(grid.values.data()),
                 grid.values.size() * sizeof(float));
    write_file(path, bytes);
}

} // namespace hipmap
