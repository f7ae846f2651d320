#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <CGAL/Mpzf.h>

#include "dupin/kernel/vec.h"
#include "exact/ball.h"
#include "support/blocks.h"
#include "support/bulk_vector.h"

namespace dupin::mesh {

/// Homogeneous coordinates (X, Y, Z, W), W > 0, of the point (X/W, Y/W, Z/W): no division, no gcd.
using ExactPoint = std::array<CGAL::Mpzf, 4>;

/// The point to about 100 bits; needs rounding upward in the calling thread.
[[nodiscard]] exact::BallPoint ball_point(const ExactPoint& point);

/// The point where the line through of[0] and of[1] meets the plane through of[2], of[3] and of[4].
struct LinePlaneMeeting {
  std::array<Vec3, 5> of;

  [[nodiscard]] ExactPoint point() const;
};

/// A list of exact points. Those known as meetings stay that: they take a third of the room of
/// coordinates, which are computed whenever they are asked for.
class ExactPoints {
 public:
  ExactPoints() = default;
  /// Of `count` points, in parallel: meeting(i) where is_meeting(i), point(i) elsewhere.
  template <class IsMeeting, class Meeting, class Point>
  ExactPoints(std::size_t count, const IsMeeting& is_meeting, const Meeting& meeting,
              const Point& point);

  [[nodiscard]] std::size_t size() const { return places_.size(); }
  [[nodiscard]] bool empty() const { return places_.empty(); }
  [[nodiscard]] ExactPoint operator[](std::size_t i) const {
    const LinePlaneMeeting* const known = meeting(i);
    return known != nullptr ? known->point() : points_[places_[i] - kFirstPoint];
  }
  /// Null if point i is not known as one.
  [[nodiscard]] const LinePlaneMeeting* meeting(std::size_t i) const {
    return places_[i] < kFirstPoint ? &meetings_[places_[i]] : nullptr;
  }
  void push_back(ExactPoint point);
  /// Point i of the others, as it is known.
  void push_back(const ExactPoints& others, std::size_t i);
  void append(const ExactPoints& others);

 private:
  static constexpr std::uint32_t kFirstPoint = std::uint32_t{1} << 31;

  std::vector<std::uint32_t> places_;  ///< in `meetings_`, or kFirstPoint + those in `points_`
  std::vector<LinePlaneMeeting> meetings_;
  std::vector<ExactPoint> points_;
};

template <class IsMeeting, class Meeting, class Point>
ExactPoints::ExactPoints(std::size_t count, const IsMeeting& is_meeting, const Meeting& meeting,
                         const Point& point) {
  support::resize_bulk(places_, count);
  support::for_each_block(count, [&](const support::Block& block) {
    for (std::size_t i = block.begin; i < block.end; ++i) {
      places_[i] = is_meeting(i) ? 0 : kFirstPoint;
    }
  });
  const support::Ranking meetings(count, [&](std::size_t i) { return places_[i] < kFirstPoint; });
  const support::Ranking points(count, [&](std::size_t i) { return places_[i] >= kFirstPoint; });
  support::resize_bulk(meetings_, meetings.size());
  points_.resize(points.size());
  meetings.for_each([&](std::size_t i, std::size_t number) {
    places_[i] = static_cast<std::uint32_t>(number);
    meetings_[number] = meeting(i);
  });
  points.for_each([&](std::size_t i, std::size_t number) {
    places_[i] = static_cast<std::uint32_t>(kFirstPoint + number);
    points_[number] = point(i);
  });
}

}  // namespace dupin::mesh
