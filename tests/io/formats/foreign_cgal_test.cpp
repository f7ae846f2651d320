#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>
#include <gtest/gtest.h>

#include "dupin/io/mesh_file.h"
#include "dupin/io/obj.h"
#include "dupin/io/off.h"
#include "dupin/io/ply.h"
#include "dupin/io/stl.h"
#include "support/sample_meshes.h"
#include "support/scratch_directory.h"

namespace dupin {
namespace {

using ForeignCgal = test::ScratchDirectory;
using Point = CGAL::Simple_cartesian<double>::Point_3;

TEST_F(ForeignCgal, finds_the_same_triangles_bit_for_bit) {
  const std::array<std::pair<MeshFormat, std::string>, 6> files = {{
      {kOff, "x.off"},
      {kStlAscii, "x.stl"},
      {kStlBinary, "y.stl"},
      {kPlyAscii, "x.ply"},
      {kPlyBinary, "y.ply"},
      {kObj, "x.obj"},
  }};
  for (const auto& [format, file] : files) {
    const TriMesh mesh = test::scattered_mesh(7, 200, format.coordinates == Coordinates::binary32);
    write_mesh(path(file), mesh, format, {"mm", "a note"});
    std::vector<Point> points;
    std::vector<std::vector<std::size_t>> polygons;
    ASSERT_TRUE(CGAL::IO::read_polygon_soup(path(file).string(), points, polygons)) << format.name;
    ASSERT_EQ(polygons.size(), mesh.triangles.size()) << format.name;
    for (std::size_t i = 0; i < polygons.size(); ++i) {
      ASSERT_EQ(polygons[i].size(), 3U);
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const Point& point = points[polygons[i][corner]];
        ASSERT_EQ(Vec3(point.x(), point.y(), point.z()), mesh.points[mesh.triangles[i][corner]])
            << format.name;
      }
    }
  }
}

}  // namespace
}  // namespace dupin
