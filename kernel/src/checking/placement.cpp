#include "dupin/kernel/placement.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <utility>

#include "dupin/kernel/coordinates.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"
#include "exact/exact_numbers.h"
#include "mesh/exact_mesh.h"
#include "support/blocks.h"

namespace dupin {
namespace {

using Point = Placement::Point;

[[noreturn]] void refuse(const std::string& message) {
  throw Error(Errc::invalid_argument, message);
}

void require_finite(const Vec3& vector) {
  if (!vector.allFinite()) {
    refuse("a placement needs finite numbers");
  }
}

Point multiplied(const std::array<Point, 3>& rows, const Point& x) {
  Point result;
  for (std::size_t i = 0; i < 3; ++i) {
    result[i] = rows[i][0] * x[0] + rows[i][1] * x[1] + rows[i][2] * x[2];
  }
  return result;
}

Point rational(const Vec3& point) {
  return {mpq_class(point.x()), mpq_class(point.y()), mpq_class(point.z())};
}

/// A turn by a quaternion of any length.
struct Quaternion {
  mpq_class w;
  Point v;
  bool is_exact = true;
};

/// The axis' length if that is a double: the root of its square rounded to nearest is then it.
std::optional<mpq_class> exact_length(const Point& axis) {
  const mpq_class square = axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2];
  const mpq_class length = std::sqrt(exact::nearest_double(square));
  return length * length == square ? std::optional(length) : std::nullopt;
}

Quaternion quaternion(const Vec3& axis, double degrees) {
  const double angle = std::remainder(degrees, 360.0);  // exact
  // Powers of two do not change the axis, and keep its square in range.
  const Vec3 direction = axis / std::exp2(std::ilogb(axis.cwiseAbs().maxCoeff()));
  const Point exact_axis = rational(direction);
  if (angle == 0) {
    return {1, {0, 0, 0}};
  }
  if (std::abs(angle) == 180) {
    return {0, exact_axis};
  }
  if (const auto length = exact_length(exact_axis); length && std::abs(angle) == 90) {
    return {angle > 0 ? *length : mpq_class(-*length), exact_axis};
  }
  const double half = angle * (std::numbers::pi / 360);
  return {std::cos(half), rational(direction.normalized() * std::sin(half)), false};
}

/// w^2 - v.v + 2 v v' + 2 w [v], over w^2 + v.v: orthogonal without rounding.
std::array<Point, 3> matrix(const Quaternion& q) {
  const mpq_class vv = q.v[0] * q.v[0] + q.v[1] * q.v[1] + q.v[2] * q.v[2];
  const mpq_class ww = q.w * q.w, sum = ww + vv;
  const std::array<Point, 3> cross{{{0, mpq_class(-q.v[2]), q.v[1]},
                                    {q.v[2], 0, mpq_class(-q.v[0])},
                                    {mpq_class(-q.v[1]), q.v[0], 0}}};
  std::array<Point, 3> rows;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const mpq_class diagonal = i == j ? mpq_class(ww - vv) : mpq_class(0);
      rows[i][j] = (diagonal + 2 * q.v[i] * q.v[j] + 2 * q.w * cross[i][j]) / sum;
    }
  }
  return rows;
}

/// The map in homogeneous coordinates, over one denominator.
class HomogeneousMap {
 public:
  explicit HomogeneousMap(const Placement& placement) {
    const std::array<Point, 3> linear = placement.linear();
    mpz_class common = 1;
    const auto widen = [&](const mpq_class& number) {
      mpz_lcm(common.get_mpz_t(), common.get_mpz_t(), number.get_den_mpz_t());
    };
    for (std::size_t i = 0; i < 3; ++i) {
      std::for_each(linear[i].begin(), linear[i].end(), widen);
      widen(placement.shift()[i]);
    }
    const auto over = [&](const mpq_class& number) {
      return exact::integer(mpq_class(number * common).get_num());
    };
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        rows_[i][j] = over(linear[i][j]);
      }
      rows_[i][3] = over(placement.shift()[i]);
    }
    denominator_ = exact::integer(common);
  }

  [[nodiscard]] mesh::ExactPoint operator()(const mesh::ExactPoint& x) const {
    const auto row = [&](std::size_t i) {
      const auto& r = rows_[i];
      return r[0] * x[0] + r[1] * x[1] + r[2] * x[2] + r[3] * x[3];
    };
    return {row(0), row(1), row(2), denominator_ * x[3]};
  }

 private:
  std::array<std::array<CGAL::Mpzf, 4>, 3> rows_;
  CGAL::Mpzf denominator_;
};

/// Points, where they are put, with those that doubles hold first again.
struct MovedPoints {
  std::vector<Vec3> nearest;
  std::vector<mesh::ExactPoint> exact;
  std::vector<std::uint8_t> is_double;
};

MovedPoints moved_points(const mesh::ExactMesh& mesh, const Placement& placement) {
  const HomogeneousMap map(placement);
  const std::size_t count = mesh.points.size();
  MovedPoints moved{std::vector<Vec3>(count), std::vector<mesh::ExactPoint>(count),
                    std::vector<std::uint8_t>(count, 1)};
  support::for_each_in_parallel(count, [&](std::size_t i) {
    moved.exact[i] = map(mesh::exact_point(mesh, static_cast<std::uint32_t>(i)));
    const auto& point = moved.exact[i];
    for (std::size_t k = 0; k < 3; ++k) {
      const double value = mesh::nearest_double(point[k], point[3]);
      moved.nearest[i][static_cast<Eigen::Index>(k)] = value;
      const bool is_held = std::isfinite(value) && CGAL::Mpzf(value) * point[3] == point[k];
      moved.is_double[i] &= is_held ? 1 : 0;
    }
  });
  for (const Vec3& point : moved.nearest) {
    if (!is_in_range(point)) {
      refuse("a point is put out of range: " + range_fault(point));
    }
  }
  return moved;
}

}  // namespace

void Placement::translate(const Vec3& by) {
  require_finite(by);
  for (std::size_t i = 0; i < 3; ++i) {
    shift_[i] += by[static_cast<Eigen::Index>(i)];
  }
  steps_.push_back({.shift = by.stableNorm()});
}

void Placement::rotate(const Vec3& axis, double degrees, const Vec3& about) {
  require_finite(axis);
  require_finite(about);
  if (!std::isfinite(degrees) || axis == Vec3::Zero()) {
    refuse("a turn needs an axis and a finite angle");
  }
  const Quaternion q = quaternion(axis, degrees);
  const std::array<Point, 3> rows = matrix(q);
  const Point center = rational(about);
  Point from_center;
  for (std::size_t i = 0; i < 3; ++i) {
    from_center[i] = shift_[i] - center[i];
  }
  shift_ = multiplied(rows, from_center);
  std::array<Point, 3> columns;
  for (std::size_t i = 0; i < 3; ++i) {
    shift_[i] += center[i];
    columns[i] = multiplied(rows, {turn_[0][i], turn_[1][i], turn_[2][i]});
  }
  for (std::size_t i = 0; i < 3; ++i) {
    turn_[i] = {columns[0][i], columns[1][i], columns[2][i]};
  }
  inexact_turns_ += q.is_exact ? 0 : 1;
  steps_.push_back({.shift = 2 * about.stableNorm(), .turn_error = q.is_exact ? 0 : kTurnError});
}

void Placement::scale(double factor) { scale(factor, 1); }

void Placement::scale(double factor, double divisor) {
  const auto is_factor = [](double value) { return std::isfinite(value) && value > 0; };
  if (!is_factor(factor) || !is_factor(divisor)) {
    refuse("a size changes by a positive factor");
  }
  const mpq_class ratio = mpq_class(factor) / mpq_class(divisor);
  size_ *= ratio;
  for (mpq_class& coordinate : shift_) {
    coordinate *= ratio;
  }
  steps_.push_back({.factor = factor / divisor});
}

Placement::Point Placement::place(const Vec3& point) const {
  require_finite(point);
  Point result = multiplied(turn_, rational(point));
  for (std::size_t i = 0; i < 3; ++i) {
    result[i] = result[i] * size_ + shift_[i];
  }
  return result;
}

Placement::Point Placement::turn(const Vec3& direction) const {
  require_finite(direction);
  return multiplied(turn_, rational(direction));
}

mpq_class Placement::scaled(double length) const {
  if (!std::isfinite(length)) {
    refuse("a placement needs finite numbers");
  }
  return size_ * length;
}

std::array<Placement::Point, 3> Placement::linear() const {
  std::array<Point, 3> rows = turn_;
  for (Point& row : rows) {
    for (mpq_class& entry : row) {
      entry *= size_;
    }
  }
  return rows;
}

double Placement::error(double radius) const {
  double error = 0;
  for (const Step& step : steps_) {
    error = (error + step.turn_error * (radius + step.shift)) * step.factor;
    radius = (radius + step.shift) * step.factor;
  }
  return error;
}

Vec3 nearest_point(const Placement::Point& point) {
  return {exact::nearest_double(point[0]), exact::nearest_double(point[1]),
          exact::nearest_double(point[2])};
}

Solid placed(const Solid& solid, const Placement& placement) {
  const UsualArithmetic usual;
  const mesh::ExactMesh& before = solid.exact();
  MovedPoints moved = moved_points(before, placement);
  auto after = std::make_shared<mesh::ExactMesh>();
  std::vector<std::uint32_t> number(moved.nearest.size());
  for (const bool of_doubles : {true, false}) {
    for (std::size_t i = 0; i < number.size(); ++i) {
      if ((moved.is_double[i] != 0) == of_doubles) {
        number[i] = static_cast<std::uint32_t>(after->points.size());
        after->points.emplace_back(moved.nearest[i].array() + 0.0);
        if (!of_doubles) {
          after->implicit.push_back(std::move(moved.exact[i]));
        }
      }
    }
  }
  after->triangles = before.triangles;
  for (Triangle& triangle : after->triangles) {
    triangle = {number[triangle[0]], number[triangle[1]], number[triangle[2]]};
  }
  after->labels = before.labels;
  after->names = before.names;
  after->sources = before.sources;
  after->contacts = before.contacts;
  for (Contact& contact : after->contacts) {
    contact.from = nearest_point(placement.place(contact.from));
    contact.to = nearest_point(placement.place(contact.to));
  }
  return Solid(std::move(after));
}

PlacedMesh placed(const TriMesh& mesh, const Placement& placement) {
  const UsualArithmetic usual;
  PlacedMesh result{mesh};
  for (Vec3& point : result.mesh.points) {
    if (!point.allFinite()) {
      refuse("a point is nowhere: " + range_fault(point));
    }
    const Point exact = placement.place(point);
    const bool was_in_range = is_in_range(point);
    point = nearest_point(exact).array() + 0.0;
    if (was_in_range ? !is_in_range(point) : !point.allFinite()) {
      refuse("a point is put out of range: " + range_fault(point));
    }
    const Point held = rational(point);
    if (held != exact) {
      result.is_exact = false;
      mpq_class square = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        square += (held[k] - exact[k]) * (held[k] - exact[k]);
      }
      result.largest_move = std::max(result.largest_move, std::sqrt(square.get_d()));
    }
  }
  return result;
}

}  // namespace dupin
