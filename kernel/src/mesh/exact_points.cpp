#include "mesh/exact_points.h"

#include <cmath>
#include <utility>

#include "exact/exact_numbers.h"
#include "exact/line_plane_meeting.h"

namespace dupin::mesh {

exact::BallPoint ball_point(const ExactPoint& point) {
  const exact::Ball weight = exact::ball(point[3]);
  exact::BallPoint result;
  for (std::size_t k = 0; k < 3; ++k) {
    result[k] = exact::ball(point[k]) / weight;
    if (!std::isfinite(result[k].radius())) {  // homogeneous coordinates may be beyond doubles
      result[k] = exact::ball(mpq_class(exact::rational(point[k]) / exact::rational(point[3])));
    }
  }
  return result;
}

ExactPoint LinePlaneMeeting::point() const {
  return exact::line_plane_meeting(of[0], of[1], of[2], of[3], of[4]);
}

void ExactPoints::push_back(ExactPoint point) {
  places_.push_back(kFirstPoint + static_cast<std::uint32_t>(points_.size()));
  points_.push_back(std::move(point));
}

void ExactPoints::push_back(const ExactPoints& others, std::size_t i) {
  if (const LinePlaneMeeting* const known = others.meeting(i)) {
    places_.push_back(static_cast<std::uint32_t>(meetings_.size()));
    meetings_.push_back(*known);
  } else {
    push_back(others[i]);
  }
}

void ExactPoints::append(const ExactPoints& others) {
  for (const std::uint32_t place : others.places_) {
    const bool is_point = place >= kFirstPoint;
    const std::size_t before = is_point ? points_.size() : meetings_.size();
    places_.push_back(place + static_cast<std::uint32_t>(before));
  }
  meetings_.insert(meetings_.end(), others.meetings_.begin(), others.meetings_.end());
  points_.insert(points_.end(), others.points_.begin(), others.points_.end());
}

}  // namespace dupin::mesh
