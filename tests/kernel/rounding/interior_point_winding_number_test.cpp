#include <cmath>

#include <gtest/gtest.h>

#include "dupin/kernel/interior_point.h"
#include "support/message_of.h"
#include "support/shapes.h"

namespace dupin {
namespace {

TEST(WindingNumber, is_of_points_inside) {
  const TriMesh mesh = test::box({0, 0, 0}, {2, 3, 4});
  EXPECT_EQ(winding_number(mesh, {1, 1, 1}), 1);
  EXPECT_EQ(winding_number(mesh, {1, 1, -0.1}), 0);
  EXPECT_EQ(winding_number(test::reversed(mesh), {1, 1, 1}), -1);
  EXPECT_EQ(winding_number(test::joined({mesh, mesh}), {1, 1, 1}), 2);
  EXPECT_EQ(winding_number({}, {1, 1, 1}), 0);
}

TEST(WindingNumber, tells_neighbouring_doubles_apart) {
  const TriMesh mesh = test::box({0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(winding_number(mesh, {std::nextafter(1.0, 0.0), 0.5, 0.5}), 1);
  EXPECT_EQ(winding_number(mesh, {std::nextafter(1.0, 2.0), 0.5, 0.5}), 0);
}

TEST(WindingNumber, is_of_places_and_of_meshes_that_have_one) {
  const TriMesh mesh = test::box({0, 0, 0}, {2, 3, 4});
  for (const double number : {std::nan(""), double(INFINITY), -double(INFINITY)}) {
    for (int k = 0; k < 3; ++k) {
      Vec3 place(1, 1, 1);
      place[k] = number;
      EXPECT_NE(test::message_of([&] { (void)winding_number(mesh, place); }, Errc::invalid_argument)
                    .find("finite coordinates only"),
                std::string::npos);
    }
    TriMesh bad = mesh;
    bad.points[2].z() = number;
    EXPECT_EQ(test::message_of([&] {
                (void)winding_number(bad, {1, 1, 1});
              }),
              "point 2 has a coordinate that is not finite");
  }
  TriMesh bad = mesh;
  bad.triangles[1][0] = 8;
  EXPECT_EQ(test::message_of([&] {
              (void)winding_number(bad, {1, 1, 1});
            }),
            "face 1 has the corner 8, but there are 8 points");
  EXPECT_EQ(winding_number(mesh, Vec3::Constant(1e300)), 0);
}

}  // namespace
}  // namespace dupin
