#include "common/input_error.h"
#include "common/scene/density_file.h"
#include "convert/vdb_grid.h"
#include "tests/support/temporary_folder.h"

#include <catch2/catch.hpp>
#include <openvdb/openvdb.h>

using namespace hipmap;

namespace {

constexpr glm::ivec3 kFirst(-3, 1, 7), kNodes(5, 4, 3);

float value_at(int x, int y, int z)
{
    return static_cast<float>(x + 10 * y + 100 * z);
}

/// Voxels of 0.5 x 0.25 x 2, of which a box is active.
openvdb::FloatGrid::Ptr smoke()
{
    openvdb::FloatGrid::Ptr out = openvdb::FloatGrid::create(0.0f);
    out->setName("density");
    openvdb::math::Transform::Ptr placed = openvdb::math::Transform::createLinearTransform(1.0);
    placed->postScale({0.5, 0.25, 2});
    placed->postTranslate({1, 2, 3});
    out->setTransform(placed);
    for (int z = 0; z < kNodes.z; ++z)
        for (int y = 0; y < kNodes.y; ++y)
            for (int x = 0; x < kNodes.x; ++x)
                out->tree().setValue({kFirst.x + x, kFirst.y + y, kFirst.z + z}, value_at(x, y, z));
    return out;
}

std::filesystem::path write(const TemporaryFolder& folder, const openvdb::GridPtrVec& grids)
{
    openvdb::initialize();
    const std::filesystem::path path = folder / "smoke.vdb";
    openvdb::io::File(path.string()).write(grids);
    return path;
}

void check_refused(const openvdb::GridPtrVec& grids, const std::string& name, const char* what)
{
    const TemporaryFolder folder;
    const std::filesystem::path path = write(folder, grids);
    CHECK_THROWS_WITH(read_vdb(path, name, UpAxis::y),
                      Catch::Contains("smoke.vdb: ") && Catch::Contains(what));
}

} // namespace

TEST_CASE("vdb: values of the box of active voxels, and where it is", "[vdb]")
{
    const TemporaryFolder folder;
    const VdbGrid grid = read_vdb(write(folder, {smoke()}), "", UpAxis::y);
    CHECK(grid.name == "density");
    CHECK(grid.density.nodes == glm::uvec3(kNodes));
    std::size_t at = 0;
    for (int z = 0; z < kNodes.z; ++z)
        for (int y = 0; y < kNodes.y; ++y)
            for (int x = 0; x < kNodes.x; ++x)
                CHECK(grid.density.values.at(at++) == value_at(x, y, z));
    CHECK(grid.density.values.size() == at);
    CHECK(grid.low == glm::dvec3(1 - 1.5, 2 + 0.25, 3 + 14));
    CHECK(grid.high == glm::dvec3(1 + 0.5, 2 + 1, 3 + 18));
    CHECK(grid.negative == 0);
}

TEST_CASE("vdb: with z up it is turned as Blender's exporter turns what is beside it", "[vdb]")
{
    const TemporaryFolder folder;
    const VdbGrid grid = read_vdb(write(folder, {smoke()}), "density", UpAxis::z);
    CHECK(grid.density.nodes == glm::uvec3(kNodes.x, kNodes.z, kNodes.y));
    std::size_t at = 0;
    for (int back = kNodes.y; back-- > 0;) // -y is along z
        for (int z = 0; z < kNodes.z; ++z)
            for (int x = 0; x < kNodes.x; ++x)
                CHECK(grid.density.values.at(at++) == value_at(x, back, z));
    CHECK(grid.low == glm::dvec3(-0.5, 17, -3));
    CHECK(grid.high == glm::dvec3(1.5, 21, -2.25));
}

TEST_CASE("vdb: what is written is read as a density", "[vdb]")
{
    const TemporaryFolder folder;
    const openvdb::FloatGrid::Ptr cold = smoke();
    cold->tree().setValue({kFirst.x, kFirst.y, kFirst.z}, -1);
    cold->setName("fog");
    const VdbGrid grid = read_vdb(write(folder, {cold}), "", UpAxis::z);
    CHECK(grid.name == "fog");
    CHECK(grid.negative == 1);
    write_density(folder / "smoke.vol", grid.density, grid.low, grid.high);
    const std::shared_ptr<const DensityGrid> read = read_density(folder / "smoke.vol");
    CHECK(read->nodes == grid.density.nodes);
    CHECK(read->values == grid.density.values);
}

TEST_CASE("vdb: what cannot be a density is refused with what to do", "[vdb]")
{
    check_refused({smoke()}, "heat", "'density' with --grid");
    check_refused({openvdb::FloatGrid::create(0.0f)}, "", "no active voxel");
    const openvdb::Vec3SGrid::Ptr wind = openvdb::Vec3SGrid::create();
    wind->setName("wind");
    check_refused({smoke(), wind}, "wind", "of vec3s; a grid of floats is needed");
    const openvdb::FloatGrid::Ptr turned = smoke();
    turned->transform().preRotate(0.5, openvdb::math::Z_AXIS);
    check_refused({turned}, "", "resample it along the axes");
    const openvdb::FloatGrid::Ptr far = smoke();
    far->tree().setValue({20000, 0, 0}, 1);
    check_refused({far}, "", "along an axis");
    const openvdb::FloatGrid::Ptr flat = openvdb::FloatGrid::create(0.0f);
    flat->tree().setValue({0, 0, 0}, 1);
    check_refused({flat}, "", "along an axis");
    const openvdb::FloatGrid::Ptr endless = smoke();
    endless->tree().setValue({kFirst.x, kFirst.y, kFirst.z},
                             std::numeric_limits<float>::infinity());
    check_refused({endless}, "", "not finite");
    const TemporaryFolder folder;
    CHECK_THROWS_WITH(read_vdb(folder / "none.vdb", "", UpAxis::y),
                      Catch::Contains("none.vdb: OpenVDB cannot read it"));
}
