#include "mesh/exact_points.h"

#include <utility>

#include "exact/line_plane_meeting.h"

namespace dupin::mesh {

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
