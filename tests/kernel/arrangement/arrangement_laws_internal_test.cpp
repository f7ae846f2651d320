#include <random>

#include <CGAL/box_intersection_d.h>
#include <gtest/gtest.h>

#include "kernel/arrangement/stages_internal.h"
#include "kernel/exact_validity_internal.h"
#include "support/tiled_boxes.h"

namespace dupin::arrangement {
namespace {

using test::arranged;

// A box, a tetrahedron or a prism with small integer coordinates.
Solid random_solid(std::mt19937& random) {
  std::uniform_int_distribution<int> coordinate(0, 4), kind(0, 3);
  const auto place = [&] {
    return Vec3(coordinate(random), coordinate(random), coordinate(random));
  };
  while (true) {
    TriMesh mesh;
    const int k = kind(random);
    if (k == 0) {
      const Vec3 a = place(), b = place();
      if ((a - b).cwiseAbs().minCoeff() == 0) {
        continue;
      }
      mesh = test::box(a.cwiseMin(b), a.cwiseMax(b));
    } else if (k == 1) {
      mesh = test::moved(test::frame(), place());
    } else {
      mesh.points = {place(), place(), place(), place()};
      mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
      const double volume = (mesh.points[1] - mesh.points[0])
                                .cross(mesh.points[2] - mesh.points[0])
                                .dot(mesh.points[3] - mesh.points[0]);
      if (volume == 0) {
        continue;
      }
      mesh = volume > 0 ? mesh : test::reversed(mesh);
    }
    return Solid::from(mesh);
  }
}

void expect_valid(const Solid& solid) {
  EXPECT_TRUE(test::is_closed_manifold(solid.exact()));
  EXPECT_EQ(test::self_intersections(solid.exact()), 0u);
}

TEST(ArrangementLaws, hold_for_random_pairs_on_a_coarse_grid) {
  for (unsigned seed = 0; seed < 400; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const Solid a = random_solid(random), b = random_solid(random);
    const Solid united = arranged({a, b}, union_rule(2));
    const Solid common = arranged({a, b}, intersection_rule(2));
    const Solid difference = arranged({a, b}, difference_rule(2));
    for (const Solid& solid : {united, common, difference}) {
      expect_valid(solid);
    }
    EXPECT_EQ(united.exact_volume() + common.exact_volume(), a.exact_volume() + b.exact_volume());
    EXPECT_EQ(difference.exact_volume() + common.exact_volume(), a.exact_volume());
    // Booleans of booleans: the union again, from disjoint parts that touch all along.
    const Solid again = arranged({difference, b}, union_rule(2));
    expect_valid(again);
    EXPECT_EQ(again.exact_volume(), united.exact_volume());
    EXPECT_EQ(arranged({difference, b}, intersection_rule(2)).exact_volume(), 0);
  }
}

void expect_inclusion_and_exclusion(const std::vector<Solid>& solids) {
  mpq_class signed_sum = 0;
  for (unsigned subset = 1; subset < 1u << solids.size(); ++subset) {
    std::vector<Solid> some;
    for (unsigned i = 0; i < solids.size(); ++i) {
      if ((subset >> i & 1u) != 0) {
        some.push_back(solids[i]);
      }
    }
    const mpq_class volume = arranged(some, intersection_rule(some.size())).exact_volume();
    signed_sum += some.size() % 2 == 1 ? volume : mpq_class(-volume);
  }
  const Solid united = arranged(solids, union_rule(solids.size()));
  expect_valid(united);
  EXPECT_EQ(united.exact_volume(), signed_sum);
}

TEST(ArrangementLaws, inclusion_and_exclusion_of_five_random_solids) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(1000 + seed);
    std::vector<Solid> solids;
    for (int i = 0; i < 5; ++i) {
      solids.push_back(random_solid(random));
    }
    expect_inclusion_and_exclusion(solids);
  }
}

// Sides in one plane, of many triangles: edges inside of them cross each other, and those of the
// sides, run along them, and are crossed by what stands on them; with solids that have no such
// sides.
TEST(ArrangementLaws, inclusion_and_exclusion_of_solids_with_tiled_sides) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(2000 + seed);
    std::vector<Solid> solids;
    for (int i = 0; i < 4; ++i) {
      solids.push_back(seed % 3 == 0 && i == 3 ? random_solid(random)
                                               : Solid::from(test::random_tiled_box(random)));
    }
    expect_inclusion_and_exclusion(solids);
  }
}

TEST(ArrangementLaws, hold_for_pairs_with_tiled_sides) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(3000 + seed);
    const Solid a = Solid::from(test::random_tiled_box(random, 8)),
                b = Solid::from(test::random_tiled_box(random, 8));
    const Solid united = arranged({a, b}, union_rule(2));
    const Solid difference = arranged({a, b}, difference_rule(2));
    expect_valid(united);
    expect_valid(difference);
    const mpq_class common = arranged({a, b}, intersection_rule(2)).exact_volume();
    EXPECT_EQ(united.exact_volume() + common, a.exact_volume() + b.exact_volume());
    EXPECT_EQ(difference.exact_volume() + common, a.exact_volume());
    const Solid again = arranged({difference, b}, union_rule(2));
    expect_valid(again);
    EXPECT_EQ(again.exact_volume(), united.exact_volume());
  }
}

}  // namespace
}  // namespace dupin::arrangement
