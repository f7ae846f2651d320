#include "dupin/blends/frame.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <Eigen/Geometry>

#include "curves/exact_spine.h"
#include "dupin/kernel/error.h"

namespace dupin {
namespace {

Vec3 unit_tangent(const SpinePoint& point, double t) {
  const double speed = point.first.norm();
  if (!(speed > 0) || !std::isfinite(speed)) {
    throw Error(Errc::irregular_surface,
                "the spine has no direction at t = " + std::to_string(t) +
                    " because its velocity vanishes there; shorten its end velocities",
                {}, "t = " + std::to_string(t));
  }
  return point.first / speed;
}

Frame completed(const Vec3& first, const Vec3& tangent) {
  const Vec3 orthogonal = (first - first.dot(tangent) * tangent).normalized();
  return {orthogonal, tangent.cross(orthogonal), tangent};
}

Vec3 reflected(const Vec3& v, const Vec3& mirror_normal, double squared_length) {
  return v - 2 / squared_length * mirror_normal.dot(v) * mirror_normal;
}

// The image of a vector orthogonal to `from` under the smallest rotation from `from` to `to`.
Vec3 least_rotated(const Vec3& v, const Vec3& from, const Vec3& to) {
  return v - v.dot(to) / (1 + from.dot(to)) * (from + to);
}

}  // namespace

FrameField::FrameField(const Spine& spine, const Vec3& start_axis, const FrameOptions& options)
    : spine_(spine), plane_normal_(curves::plane_normal(spine)) {
  const SpinePoint start = evaluate(spine, 0);
  const Vec3 tangent = unit_tangent(start, 0);
  const Vec3 across = start_axis - start_axis.dot(tangent) * tangent;
  if (!across.allFinite() || across.isZero(0) || start_axis.cross(tangent).isZero(0)) {
    throw Error(Errc::invalid_argument,
                "a frame's start axis must be finite and not parallel to the spine's tangent");
  }
  if (options.knots == 0) {
    throw Error(Errc::invalid_argument, "a frame field needs at least 1 knot interval, not 0");
  }
  const Frame first = completed(across.normalized(), tangent);
  if (plane_normal_) {
    along_normal_ = first.first.dot(*plane_normal_);
    in_plane_ = first.first.dot(plane_normal_->cross(tangent));
    return;
  }
  knots_.reserve(options.knots + 1);
  knots_.push_back({start.position, first});
  for (std::size_t i = 1; i <= options.knots; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(options.knots);
    knots_.push_back(stepped(knots_.back(), t));
  }
}

FrameField::Knot FrameField::stepped(const Knot& from, double t) const {
  const SpinePoint point = evaluate(spine_, t);
  const Vec3 tangent = unit_tangent(point, t);
  const Vec3 chord = point.position - from.position;
  const double chord2 = chord.squaredNorm();
  if (chord2 == 0) {
    return {point.position,
            completed(least_rotated(from.frame.first, from.frame.tangent, tangent), tangent)};
  }
  const Vec3 first = reflected(from.frame.first, chord, chord2);
  const Vec3 second_mirror = tangent - reflected(from.frame.tangent, chord, chord2);
  const double mirror2 = second_mirror.squaredNorm();
  return {point.position,
          completed(mirror2 == 0 ? first : reflected(first, second_mirror, mirror2), tangent)};
}

Frame FrameField::at(double t) const {
  if (plane_normal_) {
    const Vec3 tangent = unit_tangent(evaluate(spine_, t), t);
    const Vec3& n = *plane_normal_;
    return completed(along_normal_ * n + in_plane_ * n.cross(tangent), tangent);
  }
  const auto intervals = static_cast<double>(knots_.size() - 1);
  const double knot = std::clamp(std::floor(t * intervals), 0.0, intervals);
  const Knot& before = knots_[static_cast<std::size_t>(knot)];
  return knot / intervals == t ? before.frame : stepped(before, t).frame;
}

}  // namespace dupin
