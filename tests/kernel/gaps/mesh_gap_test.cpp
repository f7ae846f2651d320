#include "dupin/kernel/mesh_gap.h"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "dupin/kernel/boolean.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/gap.h"
#include "support/shapes.h"

namespace dupin {
namespace {

using test::box;
using test::joined;
using test::reversed;
using testing::ElementsAre;
using testing::HasSubstr;

double next(double x) { return std::nextafter(x, std::numeric_limits<double>::infinity()); }
mpq_class squared(const mpq_class& x) { return x * x; }

// Faces 8 and 9 of a box look along -x, 10 and 11 along x.
TriMesh cube(double low, double high) { return box(Vec3::Constant(low), Vec3::Constant(high)); }

/// The prism over two rings that look away from each other, each end a fan.
TriMesh prism(const Ring& start, const Ring& end) {
  TriMesh mesh;
  mesh.points = sample(flipped(start), {24});
  const auto n = static_cast<std::uint32_t>(mesh.points.size());
  const auto far = sample(end, {24});
  mesh.points.insert(mesh.points.end(), far.begin(), far.end());
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    mesh.triangles.push_back({i, j, j + n});
    mesh.triangles.push_back({i, j + n, i + n});
    if (i > 0 && j > 0) {
      mesh.triangles.push_back({0, j, i});
      mesh.triangles.push_back({n, i + n, j + n});
    }
  }
  return mesh;
}

struct Case {
  const char* name;
  TriMesh a, b;
  std::size_t components;
  bool touching, slit;
  std::size_t welded_faces;
};

TEST(MeshGap, tells_pieces_and_slits) {
  const TriMesh left = box({0, 0, 0}, {1, 1, 1});
  const TriMesh shell = joined({cube(0, 9), reversed(cube(1, 8))});
  TriMesh tilted = box({1, 0, 0}, {2, 1, 1});  // touches `left` in an edge, opens upwards
  tilted.points[4].x() = tilted.points[6].x() = 1.0625;
  TriMesh crossing = tilted;  // cuts into `left` at the bottom
  crossing.points[0].x() = crossing.points[2].x() = 0.9375;
  const std::vector<Case> cases = {
      {"sharing a face", left, box({1, 0, 0}, {2, 1, 1}), 1, true, false, 2},
      {"one ulp apart", left, box({next(1), 0, 0}, {2, 1, 1}), 2, false, true, 0},
      {"one ulp into each other", left, box({std::nextafter(1, 0), 0, 0}, {2, 1, 1}), 1, true,
       false, 0},
      {"at arm's length", left, box({1.0625, 0, 0}, {2, 1, 1}), 2, false, true, 0},
      {"far", left, box({3, 0, 0}, {4, 1, 1}), 2, false, false, 0},
      {"deep in each other", left, box({0.5, 0.25, 0.25}, {2, 0.75, 0.75}), 1, true, false, 0},
      {"flush, not congruent", left, box({1, 0.25, 0.25}, {2, 0.75, 0.75}), 1, true, false, 0},
      {"touching in an edge, a wedge between", left, tilted, 1, true, true, 0},
      {"crossing, a wedge left open", left, crossing, 1, true, true, 0},
      {"touching in a corner", left, box({1, 1, 1}, {2, 2, 2}), 1, true, false, 0},
      {"beside each other, ends in line", left, box({0, 1.5, 0}, {1, 2.5, 1}), 2, false, false, 0},
      {"inside the other's material", cube(0, 9), cube(4, 5), 1, false, false, 0},
      {"around the other", cube(4, 5), cube(0, 9), 1, false, false, 0},
      {"inside a void", shell, cube(4, 5), 2, false, false, 0},
      {"filling a void but for a slit", shell, cube(1.0625, 7.9375), 2, false, true, 0},
      {"filling a void", shell, cube(1, 8), 1, true, false, 12},
      {"inside the wall of a hollow", shell, cube(0.25, 0.75), 1, false, false, 0},
      {"around a hollow", shell, cube(-1, 10), 1, false, false, 0},
      {"an island in the void, and a piece in it", joined({shell, cube(3, 6)}), cube(4, 5), 2,
       false, false, 0},
      {"nothing", {}, left, 1, false, false, 0},
  };
  for (const Case& c : cases) {
    SCOPED_TRACE(c.name);
    for (const bool swapped : {false, true}) {
      const MeshGapReport report = swapped ? measure_gaps(c.b, c.a, {.connect = 0.125})
                                           : measure_gaps(c.a, c.b, {.connect = 0.125});
      EXPECT_EQ(report.components, c.components);
      EXPECT_EQ(report.one_component(), c.components == 1);
      EXPECT_EQ(report.touching, c.touching);
      EXPECT_EQ(report.slit(), c.slit);
      EXPECT_EQ(report.welded_faces, c.welded_faces);
    }
  }
}

TEST(MeshGap, region_knows_its_faces_and_exact_distance) {
  const double from = 1.1;  // 1.1 - 1 is no double with few bits
  const MeshGapReport report =
      measure_gaps(box({0, 0, 0}, {1, 1, 1}), box({from, 0, 0}, {2, 1, 1}), {.connect = 0.125});
  ASSERT_EQ(report.facing.size(), 1U);
  const GapRegion& region = report.facing[0];
  EXPECT_THAT(region.faces_a, ElementsAre(10, 11));
  EXPECT_THAT(region.faces_b, ElementsAre(8, 9));
  EXPECT_EQ(region.pairs, 2U);
  EXPECT_EQ(region.least_squared, squared(mpq_class(from) - 1));
  EXPECT_EQ(region.greatest_squared, region.least_squared);
  EXPECT_EQ(region.least, (Enclosure{from - 1, from - 1}));  // the difference is exact
  EXPECT_GT(region.place.x(), 1);
  EXPECT_LT(region.place.x(), from);
}

TEST(MeshGap, limit_of_the_distance_is_exact) {
  const TriMesh a = box({0, 0, 0}, {1, 1, 1}), b = box({1.1, 0, 0}, {2, 1, 1});
  EXPECT_TRUE(measure_gaps(a, b, {.connect = 1.1 - 1}).slit());
  EXPECT_FALSE(measure_gaps(a, b, {.connect = std::nextafter(1.1 - 1, 0)}).slit());
}

TEST(MeshGap, wedge_is_measured_at_both_ends) {
  const TriMesh a = box({0, 0, 0}, {1, 1, 1});
  TriMesh b = box({1, 0, 0}, {2, 1, 1});
  b.points[4].x() = b.points[6].x() = 1.0625;
  const MeshGapReport report = measure_gaps(a, b, {.connect = 0.125});
  ASSERT_EQ(report.facing.size(), 1U);
  EXPECT_EQ(report.facing[0].least_squared, 0);
  EXPECT_TRUE(measure_gaps(a, b, {.connect = 0.125, .cosine = 1}).facing.empty());
}

TEST(MeshGap, regions_that_do_not_hang_together_are_apart) {
  const TriMesh a = joined({box({0, 0, 0}, {1, 1, 1}), box({0, 4, 0}, {1, 5, 1})});
  const TriMesh b = joined({box({1.0625, 0, 0}, {2, 1, 1}), box({1.125, 4, 0}, {2, 5, 1})});
  const MeshGapReport report = measure_gaps(a, b, {.connect = 0.125});
  ASSERT_EQ(report.facing.size(), 2U);
  EXPECT_THAT(report.facing[0].faces_a, ElementsAre(10, 11));
  EXPECT_EQ(report.facing[0].least, (Enclosure{0.0625, 0.0625}));
  EXPECT_THAT(report.facing[1].faces_a, ElementsAre(22, 23));
  EXPECT_EQ(report.facing[1].least, (Enclosure{0.125, 0.125}));
  // One plate across both makes one region of them.
  const TriMesh plate = box({1.0625, -1, -1}, {2, 6, 2});
  EXPECT_EQ(measure_gaps(a, plate, {.connect = 0.125}).facing.size(), 1U);
  EXPECT_EQ(measure_gaps(a, plate).components, 3U);
}

TEST(MeshGap, a_retyped_ring_parts_two_prisms_by_the_gap_of_the_rings) {
  const Vec3 axis = Vec3(1, 2, 10) / std::sqrt(105.0);
  const Ring seam{{10, 4, 0}, axis, 2};
  const TriMesh before = prism({Vec3(10, 4, 0) - 5 * axis, -axis, 2}, seam);
  const TriMesh after = prism(flipped(seam), {Vec3(10, 4, 0) + 5 * axis, axis, 2});
  const MeshGapReport welded = measure_gaps(before, after, {.connect = 0.01});
  EXPECT_EQ(welded.components, 1U);
  EXPECT_FALSE(welded.slit());
  EXPECT_EQ(welded.welded_faces, 22U);
  const std::vector<Solid> as_stored = {Solid::from(before), Solid::from(after)};
  EXPECT_EQ(unite(as_stored).components(), 1U);

  Ring retyped = flipped(seam);
  retyped.center = Vec3(10.0001, 4.0002, 0.001);  // moved along the axis, as far as typed
  const TriMesh apart = prism(retyped, {Vec3(10, 4, 0) + 5 * axis, axis, 2});
  const MeshGapReport parted = measure_gaps(before, apart, {.connect = 0.01});
  const GapReport ends = measure_gap(seam, retyped);
  EXPECT_EQ(ends.verdict, GapVerdict::gap);
  EXPECT_EQ(parted.components, 2U);
  const std::vector<Solid> typed_over = {Solid::from(before), Solid::from(apart)};
  EXPECT_EQ(unite(typed_over).components(), 2U);
  ASSERT_EQ(parted.facing.size(), 1U);
  // Points of the samples are off their planes by a few ulps of 10.
  EXPECT_NEAR(parted.facing[0].least.lower, ends.axial.lower, 1e-14);
  EXPECT_NEAR(parted.facing[0].greatest.upper, ends.axial.upper, 1e-14);
}

TEST(MeshGap, boundary_loops_are_named_by_index_length_and_place) {
  TriMesh open = box({0, 0, 0}, {3, 1, 2});
  open.triangles.resize(8);  // a square tube
  const MeshGapReport report = measure_gaps(cube(10, 11), open);
  EXPECT_TRUE(report.boundary_a.empty());
  ASSERT_EQ(report.boundary_b.size(), 2U);
  EXPECT_THAT(report.boundary_b[0].points, ElementsAre(0, 2, 6, 4));
  EXPECT_THAT(report.boundary_b[1].points, ElementsAre(1, 5, 7, 3));
  for (const BoundaryLoop& loop : report.boundary_b) {
    EXPECT_TRUE(loop.closed);
    EXPECT_EQ(loop.length, (Enclosure{6, 6}));
  }
  EXPECT_EQ(report.boundary_b[1].place, Vec3(3, 0.5, 1));
}

TEST(MeshGap, identical_points_make_no_boundary) {
  TriMesh soup;  // every face with points of its own, as in STL
  for (const Triangle& t : cube(0, 1).triangles) {
    for (const std::uint32_t corner : t) {
      soup.points.push_back(cube(0, 1).points[corner]);
    }
    const auto end = static_cast<std::uint32_t>(soup.points.size());
    soup.triangles.push_back({end - 3, end - 2, end - 1});
  }
  EXPECT_TRUE(measure_gaps(soup, cube(3, 4)).boundary_a.empty());
  soup.triangles.pop_back();
  EXPECT_EQ(measure_gaps(soup, cube(3, 4)).boundary_a.at(0).points.size(), 3U);
}

TEST(MeshGap, faces_without_area_are_counted_and_left_out) {
  TriMesh a = cube(0, 1);
  a.triangles.push_back({0, 0, 1});
  a.points.push_back({0.5, 0, 0});
  a.triangles.push_back({0, 8, 1});
  EXPECT_EQ(measure_gaps(a, cube(3, 4), {.connect = 5}).flat_faces, 2U);
}

TEST(MeshGap, bad_input_is_refused_by_name) {
  const auto message = [](const TriMesh& a, const TriMesh& b, const MeshGapOptions& options) {
    try {
      (void)measure_gaps(a, b, options);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  TriMesh bad = cube(0, 1);
  bad.triangles[3][1] = 99;
  EXPECT_EQ(message(cube(0, 1), bad, {}),
            "face 3 of the second mesh names point 99, but it has only 8");
  bad = cube(0, 1);
  bad.points[5].y() = std::nan("");
  EXPECT_EQ(message(bad, cube(0, 1), {}), "point 5 of the first mesh is not finite");
  EXPECT_THAT(message({}, {}, {.connect = -0.5}), HasSubstr("length of at least 0, not -0.5"));
  EXPECT_THAT(message({}, {}, {.cosine = 1.5}), HasSubstr("at most 1, not 1.5"));
}

}  // namespace
}  // namespace dupin
