#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "dupin/kernel/check.h"
#include "dupin/kernel/error.h"
#include "tessellation/swept_mesh.h"

namespace dupin::tessellation {
namespace {

using std::numbers::pi;

struct RandomDirections {
  std::mt19937_64 random{1407};
  std::normal_distribution<double> normal;

  Vec3 next() { return Vec3(normal(random), normal(random), normal(random)).normalized(); }
};

// A quarter of a torus about the y axis of bend radius 3, from the x axis to the z axis.
const Ring kFrom{Vec3(3, 0, 0), -Vec3::UnitZ(), 1}, kTo{Vec3(0, 0, 3), -Vec3::UnitX(), 1};

// Its circle after a share of the way, with the y axis for its frame.
Row torus_row(double share) {
  const double angle = pi / 2 * share;
  const Vec3 out(std::cos(angle), 0, std::sin(angle));
  return {3 * out, out, Vec3::UnitY()};
}

// A tube without its discs, its sides out.
void expect_tube(const TriMesh& mesh, std::uint32_t segments) {
  const Report report = check(mesh);
  EXPECT_EQ(report.euler_number, 0);
  EXPECT_EQ(report.components, 1U);
  EXPECT_EQ(report.count(Defect::boundary_edge), 2 * segments);
  EXPECT_EQ(report.count(Defect::non_manifold_edge), 0U);
  EXPECT_EQ(report.count(Defect::inconsistent_orientation), 0U);
  EXPECT_EQ(report.count(Defect::self_intersection), 0U);
}

TEST(Carried, is_the_smallest_rotation_between_the_tangents) {
  RandomDirections directions;
  for (int i = 0; i < 100; ++i) {
    const Vec3 from = directions.next(), to = directions.next(), v = 2 * directions.next();
    const Vec3 turned = Eigen::Quaterniond::FromTwoVectors(from, to) * v;
    EXPECT_LT((carried(from, to, v) - turned).norm(), 1e-11) << from.dot(to);
  }
}

TEST(Arrival, turns_by_whole_segments_and_a_twist_of_at_most_half_of_one) {
  const Ring end{Vec3(1, 2, 3), Vec3(2, -1, 2) / 3, 1.5};
  for (const double phase : {0., 0.3}) {
    const RingSampling sampling{7, phase, 0};
    EXPECT_LT((first_direction(end, sampling) -
               Eigen::AngleAxisd(2 * pi * phase / 7, end.normal) * reference_axis(end))
                  .norm(),
              1e-15);
    const std::vector<Vec3> polygon = sample(end, sampling);
    for (double angle = -3; angle < 3; angle += 0.1) {
      const Vec3 came = Eigen::AngleAxisd(angle, end.normal) * reference_axis(end);
      const Arrival found = arrival(end, sampling, came);
      EXPECT_LE(std::abs(found.twist), pi / 7 + 1e-12);
      const Vec3 twisted = Eigen::AngleAxisd(found.twist, end.normal) * came;
      EXPECT_LT((end.center + end.radius * twisted - found.points.front()).norm(), 1e-14);
      const auto first = std::find(polygon.begin(), polygon.end(), found.points.front());
      std::vector<Vec3> same(first, polygon.end());
      same.insert(same.end(), polygon.begin(), first);
      EXPECT_EQ(found.points, same);
    }
  }
}

TEST(SweptMesh, runs_through_rows_from_polygon_to_polygon) {
  const RingSampling sampling{12, 0.2, 0};
  const Vec3 first = first_direction(flipped(kFrom), sampling);
  const Row start = torus_row(0);
  const double angle = std::atan2(first.dot(start.second), first.dot(start.first));
  std::vector<Row> inner;
  for (const double share : {0.25, 0.5, 0.75}) {
    inner.push_back(torus_row(share));
    inner.back().angle = angle;
  }
  const Arrival last = arrival(kTo, sampling, torus_row(1).direction(angle));
  const TriMesh mesh = swept_mesh(kFrom, inner, last, sampling);
  expect_tube(mesh, 12);
  const std::vector<Vec3> polygon = sample(flipped(kFrom), sampling);
  EXPECT_TRUE(std::equal(polygon.begin(), polygon.end(), mesh.points.begin()));
  EXPECT_TRUE(std::equal(last.points.begin(), last.points.end(), mesh.points.end() - 12));
  // All columns turn by the twist, evenly.
  ASSERT_NE(last.twist, 0);
  for (std::size_t k = 0; k < mesh.points.size(); ++k) {
    const std::size_t row = k / 12;
    const double share = double(row) / 4;
    const double expected = angle + 2 * pi * double(k % 12) / 12 + last.twist * share;
    const Row here = torus_row(share);
    EXPECT_LT((mesh.points[k] - here.center - here.direction(expected)).norm(), 1e-14) << k;
  }
  std::size_t outward = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3 &p = mesh.points[a], &q = mesh.points[b], &r = mesh.points[c];
    const Vec3 middle = (p + q + r) / 3, spine = 3 * Vec3(middle.x(), 0, middle.z()).normalized();
    outward += (q - p).cross(r - p).dot(middle - spine) > 0 ? 1 : 0;
  }
  EXPECT_EQ(outward, mesh.triangles.size());
}

// The rows' own frames begin elsewhere than the rings' polygons, at the end by more than a quarter
// turn.
TEST(SweptMesh, begins_where_frames_of_their_own_meet_the_polygons) {
  const RingSampling sampling{12, 0.2, 0x1p-40};
  std::vector<Row> rows;
  for (int j = 0; j <= 4; ++j) {
    rows.push_back(torus_row(j / 4.));
    const Row plain = rows.back();
    rows.back().first = plain.direction(0.9);
    rows.back().second = plain.direction(0.9 + pi / 2);
  }
  const TriMesh mesh = swept_mesh(kFrom, kTo, rows, sampling);
  expect_tube(mesh, 12);
  const std::vector<Vec3> first = sample(flipped(kFrom), sampling), last = sample(kTo, sampling);
  EXPECT_TRUE(std::equal(first.begin(), first.end(), mesh.points.begin()));
  EXPECT_TRUE(std::is_permutation(last.begin(), last.end(), mesh.points.end() - 12));
  // No column turns by more than half a segment against the frame.
  for (std::size_t i = 0; i < 12; ++i) {
    const auto angle = [&](std::size_t row) {
      const Vec3 d = mesh.points[12 * row + i] - rows[row].center;
      return std::atan2(d.dot(rows[row].second), d.dot(rows[row].first));
    };
    const double twist = std::remainder(angle(4) - angle(0), 2 * pi);
    EXPECT_LE(std::abs(twist), pi / 12 + 1e-9);
    for (std::size_t row = 1; row <= 4; ++row) {
      EXPECT_NEAR(std::remainder(angle(row) - angle(row - 1), 2 * pi), twist / 4, 1e-9);
    }
  }
}

TEST(EvenBands, share_a_twist_and_are_as_long_as_the_bend_permits) {
  constexpr std::uint32_t kSegments = 32;
  constexpr double kAround = 2 * pi / kSegments, kAllowed = 0.05;
  const std::array marches{BandStepper({{{4, 0, 1}, 0}}, kAround),
                           BandStepper({{{64, 0, 1}, 0}}, kAround)};
  const auto bands = even_bands({marches[0], marches[1]}, kAllowed, 1, kSegments);
  ASSERT_EQ(bands.size(), 2U);
  const double count = double(bands[0].knots.size() + bands[1].knots.size() - 2);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(bands[i].knots.back(), 1);
    EXPECT_LE(bands[i].error_bound, kAllowed);
    EXPECT_GE(bands[i].error_bound, kAllowed / 2);
    const double twist = kAround / 2 / count;
    EXPECT_GE(bands[i].error_bound, marches.at(i).error_bound(bands[i].knots, twist));
  }
  // Four times as many where the second derivative is sixteen times as large, to rounding up.
  EXPECT_NEAR(double(bands[1].knots.size() - 1) / double(bands[0].knots.size() - 1), 4, 1);
}

TEST(Sagitta, is_the_distance_of_a_chords_middle_from_the_arc) {
  for (const std::uint32_t n : {3U, 8U, 100U}) {
    const auto polygon = sample({Vec3(1, 0, 0), Vec3::UnitX(), 2}, {n});
    const Vec3 middle = (polygon[0] + polygon[1]) / 2;
    EXPECT_NEAR(sagitta(2, n), 2 - (middle - Vec3(1, 0, 0)).norm(), 1e-14);
  }
}

TEST(AppendBand, halves_quadrilaterals_along_the_shorter_diagonals) {
  for (const double twist : {-0.2, 0.2}) {
    TriMesh mesh;
    for (const double turn : {0., twist}) {
      for (int i = 0; i < 8; ++i) {
        const double u = 2 * pi * i / 8 + turn;
        mesh.points.emplace_back(std::cos(u), std::sin(u), turn == 0 ? 0 : 1);
      }
    }
    append_band(mesh, 8);
    expect_tube(mesh, 8);
    // An edge across belongs to both of its triangles; the longer diagonal is nowhere.
    const double shorter = std::hypot(1, 2 * std::sin((2 * pi / 8 - std::abs(twist)) / 2));
    for (const auto& [a, b, c] : mesh.triangles) {
      const Vec3 &p = mesh.points[a], &q = mesh.points[b], &r = mesh.points[c];
      EXPECT_LE(std::max({(q - p).norm(), (r - q).norm(), (p - r).norm()}), shorter + 1e-14);
    }
  }
}

TEST(FirstRow, refuses_more_triangles_than_a_mesh_may_have) {
  const std::vector<Vec3> row(1000, Vec3::Zero());
  EXPECT_EQ(first_row(row, 10).points, row);
  try {
    (void)first_row(row, 25'001);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::limit_exceeded);
  }
}

}  // namespace
}  // namespace dupin::tessellation
