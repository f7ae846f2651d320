// Random junctions of two to eight pipes and cones: there is one, as a solid, or a reason that
// holds.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "blends/junction/junction_meshes_internal.h"
#include "junction/hub_search.h"

namespace dupin {
namespace {

using test::JunctionMesh;

// Closed and embedded, of the sphere's kind.
void expect_solid(const Junction& junction) {
  EXPECT_EQ(unsoundness(junction), "");
  double smallest = junction.hub.radius;
  for (const JunctionArm& arm : junction.arms) {
    smallest = std::min(smallest, arm.end.radius);
  }
  const double tolerance = 0.05;
  const double grid = std::ldexp(1.0, std::ilogb(std::min(smallest, tolerance)) - 11);
  const JunctionMesh mesh = test::mesh_of(junction, tolerance, grid);
  EXPECT_EQ(test::euler_number(mesh.open), 2 - int(junction.arms.size()));
  EXPECT_LE(mesh.error_bound, tolerance);
  EXPECT_NO_THROW((void)Solid::from(mesh.closed));
}

// Ends that are said to be too near are so: moved back as far as was said, they are not.
void expect_room_further_back(std::vector<Ring> ends, const JunctionSearch& search,
                              const Vec3& center) {
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const double cosine = 1 / std::hypot(1, ends[i].slope);
    const double back = search.setbacks[i] * 1.000001 * cosine;
    ends[i].center -= back * ends[i].normal;
    ends[i].radius -= back * ends[i].slope;
  }
  EXPECT_TRUE(search_junction(ends, {.center = center}).junction.has_value());
}

bool may_be_joined(const std::vector<Ring>& ends, const Vec3& center) {
  const JunctionSearch found = search_junction(ends, {.center = center});
  return found.junction.has_value() || !found.setbacks.empty();
}

// Cones that come to an end before they are far enough back, which cylinders would not; or an end
// too many in one direction.
void expect_room_for_others(std::vector<Ring> ends, const JunctionSearch& search,
                            const Vec3& center) {
  ASSERT_TRUE(search.end.has_value());
  if (search.reason.find("further back than its cone reaches") != std::string::npos) {
    EXPECT_GT(ends[*search.end].slope, 0);
    for (Ring& end : ends) {
      end.slope = 0;
    }
  } else {
    EXPECT_NE(search.reason.find("lie in directions only"), std::string::npos) << search.reason;
    ends.erase(ends.begin() + std::ptrdiff_t(*search.end));
  }
  EXPECT_TRUE(may_be_joined(ends, center)) << search.reason;
}

struct Counts {
  int solved = 0, too_near = 0, no_room = 0;
};

void count(std::mt19937& random, Counts& counts) {
  const auto ends = test::random_ends(random, 2 + random() % 7);
  const Vec3 center = junction::nearest_to_axes(junction::approaches_of(ends));
  const JunctionSearch search = search_junction(ends);
  if (search.junction) {
    ++counts.solved;
    expect_solid(*search.junction);
  } else if (!search.setbacks.empty()) {
    ++counts.too_near;
    expect_room_further_back(ends, search, center);
  } else {
    ++counts.no_room;
    expect_room_for_others(ends, search, center);
  }
}

TEST(RandomJunctions, are_solids_or_refused_for_a_reason_that_holds) {
  Counts counts;
  for (unsigned seed = 0; seed < 500; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    count(random, counts);
  }
  EXPECT_GT(counts.solved, 250);
  EXPECT_GT(counts.too_near, 100);
  EXPECT_LT(counts.no_room, 25);
}

}  // namespace
}  // namespace dupin
