#include <array>
#include <numeric>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "arrangement/faces/frame.h"
#include "arrangement/points/implicit_predicates.h"

namespace dupin::arrangement {
namespace {

// Points that lie where lines through a place meet planes through it, but for the rounding of what
// spans them: no double tells them apart.
std::vector<PointId> all_but_one_point(double place, std::size_t count, PointTable& points) {
  std::mt19937 random(0);
  std::uniform_real_distribution<double> unit(-1, 1);
  const Vec3 middle = place * Vec3(1, 1.25, -1.5);
  const auto near = [&](double sign, const Vec3& step) {
    return points.add(Vec3(middle + sign * place * step));
  };
  const PointId center = near(0, Vec3::Zero());
  std::vector<std::array<PointId, 5>> spans;
  for (std::size_t i = 0; i < count; ++i) {
    const auto step = [&] { return Vec3(unit(random), unit(random), unit(random)); };
    const Vec3 along = step();
    spans.push_back({near(-1, along), near(1, along), center, near(1, step()), near(1, step())});
  }
  std::vector<PointId> ids;
  for (const auto& [a, b, o, u, v] : spans) {
    ids.push_back(points.add(ImplicitPoint{ImplicitPoint::Kind::line_plane, 0, {a, b, o, u, v}}));
  }
  return ids;
}

// The frame is turned as the projection is, and each point strictly inside of it, exactly.
void expect_inside_of_frame(const PointTable& points, const std::vector<PointId>& ids,
                            const Projection& projection) {
  const auto& [axis, orientation] = projection;
  const auto corners = frame_around(points, ids, projection);
  std::array<mesh::ExactPoint, 3> exact;
  for (std::size_t k = 0; k < 3; ++k) {
    exact.at(k) = {0, 0, 0, 1};
    exact.at(k).at(static_cast<std::size_t>((axis + 1) % 3)) = corners.at(k)[0];
    exact.at(k).at(static_cast<std::size_t>((axis + 2) % 3)) = corners.at(k)[1];
  }
  EXPECT_EQ(exact_turn(exact[0], exact[1], exact[2], axis), orientation);
  for (const PointId id : ids) {
    mesh::ExactPoint scratch;
    const mesh::ExactPoint& p = points.exact(id, scratch);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(exact_turn(exact.at(k), exact.at((k + 1) % 3), p, axis), orientation);
    }
  }
}

TEST(Frame, has_all_points_inside) {
  const UpwardRounding rounding;
  for (const double place : {1., 1e6, 1e-30}) {
    for (const std::size_t count : {2U, 3U, 40U}) {
      PointTable points;
      const std::vector<PointId> ids = all_but_one_point(place, count, points);
      std::vector<PointId> doubles(5 * count);
      std::iota(doubles.begin(), doubles.end(), PointId{1});
      for (int axis = 0; axis < 3; ++axis) {
        for (const int orientation : {1, -1}) {
          SCOPED_TRACE(testing::Message() << place << ", " << count << ", " << axis);
          expect_inside_of_frame(points, ids, {axis, orientation});
          expect_inside_of_frame(points, doubles, {axis, orientation});
        }
      }
    }
  }
}

}  // namespace
}  // namespace dupin::arrangement
