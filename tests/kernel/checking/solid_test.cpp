#include "dupin/kernel/solid.h"

#include <cmath>
#include <type_traits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "dupin/kernel/boolean.h"
#include "dupin/kernel/error.h"
#include "support/shapes.h"

namespace dupin {
namespace {

using test::box;
using test::joined;
using test::reversed;

TriMesh unit_box(double at) { return box(Vec3::Constant(at), Vec3::Constant(at + 1)); }

struct Expected {
  const char* description;
  TriMesh mesh;
  mpq_class volume;
  double area;
  std::size_t shells, components;
  std::int64_t euler_number, genus;
  std::size_t contacts;
};

TEST(Solid, knows_its_measures) {
  const mpq_class millionth(1e-6);  // the double
  const Expected table[] = {
      {"box", box(Vec3(0, 0, 0), Vec3(2, 3, 5)), 30, 62, 1, 1, 2, 0, 0},
      {"tiny box", box(Vec3::Zero(), Vec3::Constant(1e-6)), millionth * millionth * millionth,
       6e-12, 1, 1, 2, 0, 0},
      {"tetrahedron", test::tetrahedron(), mpq_class(1, 6), 1.5 + std::sqrt(3) / 2, 1, 1, 2, 0, 0},
      {"frame", test::frame(), 64, 64 + 48 + 16, 1, 1, 0, 1, 0},
      {"two boxes apart", joined({unit_box(0), unit_box(2)}), 2, 12, 2, 2, 4, 0, 0},
      {"box with a void", joined({box(Vec3::Zero(), Vec3::Constant(5)), reversed(unit_box(2))}),
       124, 156, 2, 1, 4, 0, 0},
      {"box in the void of a box",
       joined({box(Vec3::Zero(), Vec3::Constant(5)),
               reversed(box(Vec3::Constant(1), Vec3::Constant(4))), unit_box(2)}),
       99, 150 + 54 + 6, 3, 2, 6, 0, 0},
      {"two frames", joined({test::frame(), test::moved(test::frame(), Vec3(0, 0, 5))}), 128, 256,
       2, 2, 0, 2, 0},
      {"boxes that touch in a corner", joined({unit_box(0), unit_box(1)}), 2, 12, 2, 2, 4, 0, 1},
      {"boxes that touch along an edge", joined({unit_box(0), box(Vec3(1, 1, 0), Vec3(2, 2, 1))}),
       2, 12, 2, 2, 4, 0, 1},
      {"nothing", TriMesh{}, 0, 0, 0, 0, 0, 0, 0},
  };
  for (const Expected& row : table) {
    SCOPED_TRACE(row.description);
    const Solid solid = Solid::from(row.mesh);
    EXPECT_EQ(solid.exact_volume(), row.volume);
    EXPECT_DOUBLE_EQ(solid.volume(), row.volume.get_d());
    EXPECT_NEAR(solid.area(), row.area, 1e-12 * row.area);
    EXPECT_EQ(solid.shells(), row.shells);
    EXPECT_EQ(solid.components(), row.components);
    EXPECT_EQ(solid.euler_number(), row.euler_number);
    EXPECT_EQ(solid.genus(), row.genus);
    EXPECT_EQ(solid.contacts().size(), row.contacts);
    EXPECT_EQ(solid.empty(), row.mesh.triangles.empty());
  }
}

TEST(Solid, volume_is_exact_far_from_the_origin) {
  const double far = 0x1p50;
  const Solid solid = Solid::from(box(Vec3::Constant(far), Vec3::Constant(far + 1)));
  EXPECT_EQ(solid.exact_volume(), 1);
  EXPECT_EQ(solid.volume(), 1);
}

TEST(Solid, area_keeps_its_digits_far_from_the_origin) {
  const double far = 0x1p50;
  TriMesh needle = test::tetrahedron(Vec3::Zero(), 0x1p-40);
  needle.points[0] = Vec3(far, 0, 0);
  const Solid solid = Solid::from(reversed(needle));
  // Three faces with the far corner, of the heights of that corner over their near edges.
  const double size = 0x1p-40, near = std::sqrt(3.0) / 2 * size * size;
  EXPECT_NEAR(solid.area(), (size * far + size * far + std::sqrt(2.0) * size * far) / 2 + near,
              1e-12 * size * far);
}

TEST(Solid, from_makes_labels_of_one_name_one) {
  TriMesh mesh = joined({test::labelled(unit_box(0), "a"), test::labelled(unit_box(3), "b")});
  mesh.names.push_back("a");
  mesh.labels.front() = 2;
  const Solid solid = Solid::from(mesh);
  EXPECT_EQ(solid.names(), (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(solid.labels().front(), 0);
}

TEST(Solid, from_keeps_labels_and_drops_isolated_points) {
  TriMesh mesh = joined({test::labelled(unit_box(0), "low"), test::labelled(unit_box(3), "high")});
  mesh.points.insert(mesh.points.begin(), Vec3(9, 9, 9));
  for (Triangle& corners : mesh.triangles) {
    for (std::uint32_t& corner : corners) {
      ++corner;
    }
  }
  const Solid solid = Solid::from(mesh);
  EXPECT_EQ(solid.point_count(), 16U);
  EXPECT_EQ(solid.names(), (std::vector<std::string>{"low", "high"}));
  for (std::uint32_t i = 0; i < solid.triangle_count(); ++i) {
    EXPECT_EQ(solid.sources()[i], (Source{0, i}));
  }
}

TEST(Solid, contacts_name_the_parts_that_touch) {
  const Solid solid = Solid::from(joined(
      {test::labelled(unit_box(0), "b"), test::labelled(box(Vec3(1, 1, 0), Vec3(2, 2, 1)), "a")}));
  ASSERT_EQ(solid.contacts().size(), 1U);
  const Contact& contact = solid.contacts()[0];
  EXPECT_EQ(contact.kind, Contact::Kind::edge);
  EXPECT_EQ(contact.from, Vec3(1, 1, 0));
  EXPECT_EQ(contact.to, Vec3(1, 1, 1));
  EXPECT_EQ(contact.names, (std::vector<std::string>{"a", "b"}));
}

TEST(Solid, that_was_moved_from_is_as_it_was) {
  Solid first = Solid::from(unit_box(0));
  Solid second = std::move(first);
  EXPECT_EQ(first.volume(), 1);  // NOLINT(bugprone-use-after-move)
  EXPECT_EQ(second.volume(), 1);
  Solid third;
  third = std::move(second);
  EXPECT_EQ(second.triangle_count(), 12U);  // NOLINT(bugprone-use-after-move)
  std::vector<Solid> many;
  many.push_back(std::move(third));
  EXPECT_EQ(unite(std::vector{many.front(), third}).volume(),
            1);  // NOLINT(bugprone-use-after-move)
  static_assert(std::is_nothrow_move_constructible_v<Solid>);
  static_assert(std::is_nothrow_move_assignable_v<Solid>);
}

}  // namespace
}  // namespace dupin
