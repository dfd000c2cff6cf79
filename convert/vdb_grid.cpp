#include "convert/vdb_grid.h"

#include "common/input_error.h"
#include "common/scene/density_file.h"
#include "common/scene/scene_names.h"

#include <openvdb/openvdb.h>
#include <openvdb/tools/Dense.h>

#include <cmath>

namespace hipmap {

namespace {

using openvdb::FloatGrid;

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& what)
{
    throw InputError(path.string() + ": " + what);
}

std::string choose_name(openvdb::io::File& file, const std::filesystem::path& path,
                        const std::string& asked)
{
    const std::string wanted = asked.empty() ? "density" : asked;
    std::vector<std::string> names;
    for (auto at = file.beginName(); at != file.endName(); ++at)
        names.push_back(at.gridName());
    if (file.hasGrid(wanted))
        return wanted;
    if (asked.empty() && names.size() == 1)
        return names[0];
    fail(path, "has no grid " + quote_name(wanted) +
                   (names.empty() ? ", nor any other"
                                  : "; name one of " + list_names(names) + " with --grid"));
}

FloatGrid::Ptr read_grid(const std::filesystem::path& path, std::string& name)
{
    try {
        openvdb::initialize();
        openvdb::io::File file(path.string());
        file.open(false);
        name = choose_name(file, path, name);
        const openvdb::GridBase::Ptr grid = file.readGrid(name);
        if (grid->isType<FloatGrid>())
            return openvdb::gridPtrCast<FloatGrid>(grid);
        fail(path, "grid " + quote_name(name) + " is of " + grid->valueType() +
                       "; a grid of floats is needed");
    } catch (const openvdb::Exception& error) {
        fail(path, "OpenVDB cannot read it (" + std::string(error.what()) + "); write it again");
    }
}

/// Where voxel 0 is, and how far from one to the next.
struct Placement {
    glm::dvec3 origin, step;
};

Placement placement_of(const FloatGrid& grid, const std::filesystem::path& path)
{
    if (!grid.transform().isLinear())
        fail(path, "its voxels differ in size; resample it without perspective");
    const openvdb::math::Mat4d m = grid.transform().baseMap()->getAffineMap()->getMat4();
    Placement out;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            if (row == column ? !(m(row, column) > 0) : m(row, column) != 0)
                fail(path, "its grid is turned, mirrored or skewed; resample it along the axes");
    for (int axis = 0; axis < 3; ++axis) {
        out.origin[axis] = m(3, axis);
        out.step[axis] = m(axis, axis);
    }
    return out;
}

/// All values of a box, x fastest.
std::vector<float> dense_values(const FloatGrid& grid, const openvdb::CoordBBox& box)
{
    openvdb::tools::Dense<float, openvdb::tools::LayoutXYZ> dense(box);
    openvdb::tools::copyToDense(grid, dense);
    return {dense.data(), dense.data() + dense.valueCount()};
}

/// (x, y, z) becomes (x, z, -y).
void turn_upright(VdbGrid& grid)
{
    const glm::uvec3 n = grid.density.nodes;
    std::vector<float> turned;
    turned.reserve(grid.density.values.size());
    for (std::uint32_t back = n.y; back-- > 0;)
        for (std::uint32_t z = 0; z < n.z; ++z) {
            const auto row =
                grid.density.values.begin() + std::size_t{n.x} * (back + std::size_t{n.y} * z);
            turned.insert(turned.end(), row, row + n.x);
        }
    grid.density = {{n.x, n.z, n.y}, std::move(turned)};
    const glm::dvec3 low = grid.low, high = grid.high;
    grid.low = {low.x, low.z, 0 - high.y};
    grid.high = {high.x, high.z, 0 - low.y}; // no -0
}

} // namespace

VdbGrid read_vdb(const std::filesystem::path& path, const std::string& name, UpAxis up)
{
    VdbGrid out;
    out.name = name;
    const FloatGrid::Ptr grid = read_grid(path, out.name);
    const openvdb::CoordBBox box = grid->evalActiveVoxelBoundingBox();
    if (box.empty())
        fail(path, "grid " + quote_name(out.name) + " has no active voxels, so there is no smoke");
    const Placement placed = placement_of(*grid, path);
    for (int axis = 0; axis < 3; ++axis) {
        const std::int64_t nodes = std::int64_t{box.max()[axis]} - box.min()[axis] + 1;
        if (nodes < 2 || nodes > kMostDensityNodes)
            fail(path, "has " + std::to_string(nodes) +
                           " active voxels along an axis; resample it to 2 to 16,384");
        out.density.nodes[axis] = static_cast<std::uint32_t>(nodes);
        out.low[axis] = placed.origin[axis] + placed.step[axis] * box.min()[axis];
        out.high[axis] = placed.origin[axis] + placed.step[axis] * box.max()[axis];
    }
    if (box.volume() > kMostDensityValues)
        fail(path, "has " + std::to_string(box.volume()) +
                       " voxels in the box of the active ones; resample it to 2^28 at most");
    out.density.values = dense_values(*grid, box);
    for (float& value : out.density.values) {
        if (!std::isfinite(value))
            fail(path, "grid " + quote_name(out.name) + " has a value that is not finite");
        out.negative += value < 0 ? 1 : 0;
        value = std::max(value, 0.0f);
    }
    if (up == UpAxis::z)
        turn_upright(out);
    return out;
}

} // namespace hipmap
