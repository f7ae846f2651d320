#include <algorithm>
#include <random>
#include <string>

#include <tbb/global_control.h>

#include "arrangement/arrange.h"
#include "booleans/union_in_steps.h"
#include "dupin/kernel/error.h"
#include "kernel/booleans/pipe_case_checks_internal.h"
#include "kernel/same_solid.h"
#include "mesh/exact_mesh.h"
#include "support/shapes.h"
#include "support/tiled_boxes.h"

namespace dupin::booleans {
namespace {

using test::operands;

Solid in_steps(const std::vector<Solid>& solids) {
  return Solid(std::make_shared<const mesh::ExactMesh>(unite_in_steps(solids, {})));
}

Solid at_once(const std::vector<Solid>& solids) {
  std::vector<const mesh::ExactMesh*> meshes;
  for (const Solid& solid : solids) {
    meshes.push_back(&solid.exact());
  }
  return Solid(std::make_shared<const mesh::ExactMesh>(
      arrangement::arrange(meshes, arrangement::union_rule(meshes.size()))));
}

void expect_alike(const Solid& a, const Solid& b) {
  test::expect_same_solid(a, b);
  EXPECT_EQ(a.contacts().size(), b.contacts().size());
}

// In general and in special position: many through one point, in planes, coplanar.
TEST(UnionInSteps, is_the_union_at_once) {
  for (const char* name : {"star_5", "star_6_rot", "star_general_5", "coaxial_5", "coaxial_5_rot",
                           "coaxial_flush_3", "rack_eq_small", "same", "tangent_par"}) {
    SCOPED_TRACE(name);
    const std::vector<Solid> solids = operands(name);
    const Solid steps = in_steps(solids), once = at_once(solids);
    expect_alike(steps, once);
    EXPECT_LE(steps.triangle_count(), once.triangle_count()) << "pieces were merged";
    test::expect_valid(steps);
  }
}

// Pieces may be so small that doubles do not tell their points apart.
TEST(UnionInSteps, is_the_union_at_once_of_what_all_but_lies_in_one_plane) {
  std::mt19937 random(0);
  for (int scene = 0; scene < 40; ++scene) {
    SCOPED_TRACE(scene);
    std::vector<Solid> solids;
    for (int i = 0; i < 10; ++i) {
      solids.push_back(Solid::from(test::turned_tiled_box(random, 3)));
    }
    const Solid steps = in_steps(solids);
    test::expect_same_solid(steps, at_once(solids));
    test::expect_valid(steps);
  }
}

TEST(UnionInSteps, says_which_triangle_of_which_operand_each_is_part_of) {
  const std::vector<Solid> solids = operands("star_6_rot");
  const Solid united = in_steps(solids);
  for (std::size_t t = 0; t < united.triangle_count(); ++t) {
    const Source source = united.sources()[t];
    const Solid& from = solids.at(source.operand);
    const auto point = [&from](std::uint32_t i) { return from.exact_point(i); };
    const Triangle& triangle = from.triangles().at(source.triangle);
    const auto a = point(triangle[0]), b = point(triangle[1]), c = point(triangle[2]);
    for (const std::uint32_t corner : united.triangles()[t]) {
      const auto p = united.exact_point(corner);
      mpq_class height = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
        height += (p[k] - a[k]) * ((b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i]));
      }
      ASSERT_EQ(height, 0) << t;
    }
  }
}

// Cubes along a diagonal, in pairs that touch in an edge or a vertex.
TEST(UnionInSteps, lists_contacts_and_names_as_at_once) {
  std::vector<Solid> cubes;
  for (int i = 0; i < 7; ++i) {
    const Vec3 low(i, i, i % 3 == 2 ? i : i - i % 2);
    TriMesh cube = test::box(low, low + Vec3::Ones());
    cubes.push_back(
        Solid::from(i == 3 ? cube : test::labelled(std::move(cube), std::to_string(i % 3))));
  }
  const Solid steps = in_steps(cubes), once = at_once(cubes);
  ASSERT_FALSE(once.contacts().empty());
  expect_alike(steps, once);
  EXPECT_EQ(steps.names(), once.names());
  for (std::size_t t = 0; t < steps.triangle_count(); ++t) {
    const std::string& name = steps.names()[steps.labels()[t]];
    EXPECT_EQ(name, steps.sources()[t].operand == 3
                        ? ""
                        : std::to_string(steps.sources()[t].operand % 3));
  }
}

// More than eight that each pair meets in common: unite() takes this way.
TEST(UnionInSteps, depends_neither_on_order_nor_on_threads) {
  std::vector<Solid> solids = operands("star_12_rot");
  const auto bytes_of = [](const Solid& solid) {
    return std::pair(solid.nearest_points(), solid.triangles());
  };
  const Solid united = unite(solids);
  EXPECT_EQ(united.exact_volume(), at_once(solids).exact_volume());
  EXPECT_NE(bytes_of(united), bytes_of(at_once(solids))) << "was this made in steps?";
  std::rotate(solids.begin(), solids.begin() + 5, solids.end());
  std::swap(solids[1], solids[7]);
  EXPECT_EQ(bytes_of(unite(solids)), bytes_of(united));
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(bytes_of(unite(solids)), bytes_of(united));
}

// All of a fan have their centres in one point: neighbours are told by angles.
TEST(UnionInSteps, goes_around_a_fan_whatever_the_order_of_its_solids) {
  std::vector<Solid> solids = operands("star_13_rot");
  const Solid steps = in_steps(solids);
  std::rotate(solids.begin(), solids.begin() + 5, solids.end());
  std::swap(solids[1], solids[7]);
  const Solid others = in_steps(solids);
  EXPECT_EQ(others.nearest_points(), steps.nearest_points());
  EXPECT_EQ(others.triangles(), steps.triangles());
}

TEST(UnionInSteps, of_a_close_fan_is_told_by_where_its_solids_lie) {
  const std::vector<Solid> fan = operands("star_10_rot");
  const auto united = unite_close_fan(fan, {});
  ASSERT_TRUE(united);
  expect_alike(Solid(std::make_shared<const mesh::ExactMesh>(*united)), at_once(fan));
  EXPECT_FALSE(unite_close_fan(std::span(fan).first(9), {})) << "few";
  EXPECT_FALSE(unite_close_fan(operands("star_general_10"), {})) << "axes in no plane";
  EXPECT_FALSE(unite_close_fan(operands("coaxial_10"), {})) << "one axis";
  EXPECT_FALSE(unite_close_fan(operands("header_10"), {})) << "one point is not in all";
}

TEST(UnionInSteps, of_a_fan_whose_solids_pass_each_other_by_is_not) {
  std::vector<Solid> stairs;
  for (TriMesh mesh : test::pipe_case("star_10")) {
    for (Vec3& point : mesh.points) {
      point[2] = 0.2 * point[2] + 0.05 * static_cast<double>(stairs.size());
    }
    stairs.push_back(Solid::from(std::move(mesh)));
  }
  EXPECT_FALSE(unite_close_fan(stairs, {}));
}

TEST(UnionInSteps, tells_its_progress_in_order_and_can_be_cancelled) {
  const std::vector<Solid> solids = operands("star_12");
  double last = 0;
  BooleanOptions options;
  options.progress = [&last](std::string_view, double fraction) {
    EXPECT_GE(fraction, last);
    EXPECT_LE(fraction, 1);
    last = fraction;
    return true;
  };
  (void)unite(solids, options);
  EXPECT_GT(last, 0.9);
  options.progress = [](std::string_view, double fraction) { return fraction < 0.6; };
  EXPECT_THROW((void)unite(solids, options), Error);
}

}  // namespace
}  // namespace dupin::booleans
