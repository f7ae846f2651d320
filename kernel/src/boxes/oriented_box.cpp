#include "boxes/oriented_box.h"

#include <array>
#include <cmath>

#include <Eigen/Geometry>

#include "boxes/box_tree.h"

namespace dupin::boxes {
namespace {

/// Added to all half lengths. With u = 2^-24: points are within u/2 of their places per coordinate,
/// axes, rounded from doubles, within 1.8 u of orthonormal ones, and half lengths below 2. To take
/// a box apart along axes that are not quite orthogonal, and to round its middle, costs less than
/// 24 u; the nine products of three terms that a test sums up, less than 36 u. The axis across two
/// boxes may be any vector: its test errs by less than 60 u times its length, where the margins of
/// both boxes make at least 128 u.
constexpr double kMargin = 0x1p-18;  // 64 u

struct Range {
  Eigen::Vector3d low = Eigen::Vector3d::Constant(8), high = Eigen::Vector3d::Constant(-8);

  void include(const Eigen::Vector3d& point) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
};

/// The products of single precision numbers are exact in double, and so nearly is the normal,
/// however thin the triangle.
Eigen::Matrix3d frame(const Eigen::Vector3d& along, const Eigen::Vector3d& in_plane) {
  Eigen::Matrix3d axes;
  const Eigen::Vector3d normal = along.cross(in_plane);
  axes.col(0) = along.normalized();
  axes.col(1) = normal.squaredNorm() > 0 ? normal.normalized() : axes.col(0).unitOrthogonal();
  axes.col(2) = axes.col(0).cross(axes.col(1));
  return axes;
}

Eigen::Matrix3d frame_of(std::span<const FramedTriangle> triangles) {
  float longest = 0;
  Eigen::Vector3f along = Eigen::Vector3f::UnitX(), in_plane = Eigen::Vector3f::UnitY();
  for (const FramedTriangle& t : triangles) {
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3f edge = t[(i + 1) % 3] - t[i];
      if (edge.squaredNorm() > longest) {
        longest = edge.squaredNorm();
        along = edge;
        in_plane = t[(i + 2) % 3] - t[i];
      }
    }
  }
  return frame(along.cast<double>(), in_plane.cast<double>());
}

}  // namespace

OrientedBox::OrientedBox(const Eigen::Matrix3d& axes, const Eigen::Vector3d& low,
                         const Eigen::Vector3d& high)
    : axes_(axes.cast<float>()),
      middle_((axes * (low + high) / 2).cast<float>()),
      half_(((high - low) / 2 + Eigen::Vector3d::Constant(kMargin)).cast<float>()) {}

OrientedBox::OrientedBox(const Box& box)
    : OrientedBox(Eigen::Matrix3d::Identity(), Eigen::Vector3f(box.low.data()).cast<double>(),
                  Eigen::Vector3f(box.high.data()).cast<double>()) {}

OrientedBox::OrientedBox(std::span<const FramedTriangle> triangles) {
  const Eigen::Matrix3d axes = frame_of(triangles);
  Range range;
  for (const FramedTriangle& triangle : triangles) {
    for (const Eigen::Vector3f& corner : triangle) {
      range.include(axes.transpose() * corner.cast<double>());
    }
  }
  *this = OrientedBox(axes, range.low, range.high);
}

OrientedBox::OrientedBox(const OrientedBox& a, const OrientedBox& b) {
  const Eigen::Matrix3d axes =
      (a.half_.maxCoeff() < b.half_.maxCoeff() ? b : a).axes_.cast<double>();
  Range range;
  for (const OrientedBox* box : {&a, &b}) {
    const Eigen::Vector3d middle = axes.transpose() * box->middle_.cast<double>();
    const Eigen::Vector3d reach =
        (axes.transpose() * box->axes_.cast<double>()).cwiseAbs() * box->half_.cast<double>();
    range.include(middle - reach);
    range.include(middle + reach);
  }
  *this = OrientedBox(axes, range.low, range.high);
}

bool OrientedBox::apart(const OrientedBox& other) const {
  const Eigen::Vector3f between = other.middle_ - middle_;
  std::array<float, 3> reach = {other.half_[0], other.half_[1], other.half_[2]};  // on its axes
  for (int i = 0; i < 3; ++i) {
    float sum = half_[i];
    for (int j = 0; j < 3; ++j) {
      const float turn = std::abs(axes_.col(i).dot(other.axes_.col(j)));
      sum += turn * other.half_[j];
      reach[j] += turn * half_[i];
    }
    if (std::abs(axes_.col(i).dot(between)) > sum) {
      return true;
    }
  }
  for (int j = 0; j < 3; ++j) {
    if (std::abs(other.axes_.col(j).dot(between)) > reach[j]) {
      return true;
    }
  }
  // Needles that pass each other are apart along what is across both; so might they be along
  // others of the nine such axes, less often.
  const Eigen::Vector3f across = axes_.col(0).cross(other.axes_.col(0));
  const float sum = (axes_.transpose() * across).cwiseAbs().dot(half_) +
                    (other.axes_.transpose() * across).cwiseAbs().dot(other.half_);
  return std::abs(across.dot(between)) > sum;
}

void OrientedBox::include(const FramedTriangle& triangle) {
  const Eigen::Matrix3d axes = axes_.cast<double>();
  const Eigen::Vector3d middle = axes.transpose() * middle_.cast<double>();
  const Eigen::Vector3d half = half_.cast<double>();
  Range range{middle - half, middle + half};
  for (const Eigen::Vector3f& corner : triangle) {
    range.include(axes.transpose() * corner.cast<double>());
  }
  *this = OrientedBox(axes, range.low, range.high);
}

}  // namespace dupin::boxes
