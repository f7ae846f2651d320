#include "surfaces/fillet_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include <Eigen/Geometry>

#include "dupin/blends/canal_fillet.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "numbers/point_order.h"
#include "tessellation/tessellation_tolerance.h"

namespace dupin::surfaces {
namespace {

using tessellation::allowed_error;
using tessellation::count_text;
using tessellation::point_error;
using tessellation::segment_count;

constexpr double kTurn = 2 * std::numbers::pi;

// A row of the mesh, and what the proof needs of it.
struct FilletRow {
  double parameter = 0;
  MovingBall ball;
  ContactArc arc;
};

double angle_between(const Vec3& a, const Vec3& b) {
  return 2 * std::asin(std::min(1.0, (a - b).norm() / 2));
}

// The direction from a quadric's axis, about which it turns.
Vec3 arm(const Ring& quadric, const Vec3& foot) {
  const Vec3 from = foot - quadric.center;
  return (from - from.dot(quadric.normal) * quadric.normal).normalized();
}

// Half of what is allowed to chords across; the rest to the way along.
double columns_across(const FilletRow& row, double allowed) {
  const double half = std::acos(std::max(0.0, 1 - allowed / (2 * row.ball.radius)));
  return row.arc.angle / (2 * half);
}

// How many of the largest turns there are between two rows.
double turns_between(const CanalFillet& loop, const FilletSampling& sampling, const FilletRow& a,
                     const FilletRow& b) {
  double most = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    const Ring& quadric = loop.quadrics.at(i);
    most = std::max(most,
                    angle_between(arm(quadric, a.arc.feet.at(i)), arm(quadric, b.arc.feet.at(i))) /
                        sampling.turns.at(i));
  }
  return most;
}

FilletRow row_at(const CanalFillet& loop, double parameter) {
  const MovingBall at = ball(loop, parameter);
  return {parameter, at, contact_arc(loop.quadrics, at)};
}

double displacement_of(const CanalFillet& loop, double grid) {
  const MovingBall start = ball(loop, 0);
  return point_error(start.center.norm() + loop.quadrics[0].center.norm() +
                         loop.quadrics[1].center.norm() + start.radius,
                     grid);
}

// How far triangles between two rows are from the surface, which bounds the union of the balls: a
// point is min (|x - m| - rho) off it, negative inside.
//
// Balls of linear centre and radius differ from these by `bend` at most. Over such ones
// |x - m| - rho is convex and at most 0 in a triangle's corners, with their own balls, hence all
// over. It is at least n (x - m) - rho for any unit vector n, which is the same for all balls where
// n is across them, that is n m' = -rho': then it is least in a corner. The n between a triangle's
// corners is taken.
class Cell {
 public:
  Cell(const FilletRow& from, const FilletRow& to, double bend)
      : from_(from), to_(to), bend_(bend) {
    const Vec3 step = to.ball.center - from.ball.center;
    const double length = step.norm();
    chord_ = step / length;
    slope_ = (to.ball.radius - from.ball.radius) / length;
  }

  [[nodiscard]] double error(std::uint32_t columns) const {
    double deepest = 0;
    for (std::uint32_t j = 0; j < columns; ++j) {
      const Corner a = corner(from_, j, columns), b = corner(from_, j + 1, columns),
                   c = corner(to_, j, columns), d = corner(to_, j + 1, columns);
      // Both diagonals: which is taken is not known yet.
      deepest = std::max(
          {deepest, depth({a, b, c}), depth({b, c, d}), depth({a, b, d}), depth({a, c, d})});
    }
    return deepest + 2 * bend_;
  }

 private:
  struct Corner {
    Vec3 arm;  // from the ball's centre
    double radius = 1;
  };

  [[nodiscard]] static Corner corner(const FilletRow& row, std::uint32_t j, std::uint32_t columns) {
    return {point(row.arc, row.arc.angle * j / columns) - row.ball.center, row.ball.radius};
  }

  [[nodiscard]] double depth(const std::array<Corner, 3>& corners) const {
    // In the middle of those that are furthest apart.
    Vec3 between = Vec3::Zero();
    double widest = 2;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 a = corners.at(i).arm.normalized(), b = corners.at((i + 1) % 3).arm.normalized();
      if (a.dot(b) < widest) {
        widest = a.dot(b);
        between = a + b;
      }
    }
    between -= between.dot(chord_) * chord_;
    const Vec3 across = std::sqrt(1 - slope_ * slope_) * between.normalized() - slope_ * chord_;
    double deepest = 0;
    for (const Corner& corner : corners) {
      deepest = std::max(deepest, corner.radius - across.dot(corner.arm));
    }
    return deepest;
  }

  const FilletRow &from_, &to_;
  double bend_, slope_ = 0;
  Vec3 chord_;
};

class Rows {
 public:
  Rows(const CanalFillet& loop, const FilletSampling& sampling, double allowed)
      : loop_(loop), sampling_(sampling), allowed_(allowed) {
    constexpr int kFirst = 16;
    std::vector<FilletRow> first;
    double columns = 2;
    for (int i = 0; i <= kFirst; ++i) {
      first.push_back(row(kTurn * i / kFirst));
      columns = std::max(columns, columns_across(first.back(), allowed));
    }
    columns_ = columns <= 8 ? std::uint32_t(std::ceil(columns)) : segment_count(columns);
    rows_.push_back(first.front());
    for (int i = 0; i < kFirst; ++i) {
      divide(first[std::size_t(i)], first[std::size_t(i) + 1], 0);
    }
    rows_.pop_back();  // the first again
  }

  [[nodiscard]] const std::vector<FilletRow>& rows() const { return rows_; }
  [[nodiscard]] std::uint32_t columns() const { return columns_; }
  [[nodiscard]] double error() const { return error_; }

 private:
  [[nodiscard]] FilletRow row(double parameter) const { return row_at(loop_, parameter); }

  void divide(const FilletRow& from, const FilletRow& to, int depth) {
    const double step = to.parameter - from.parameter;
    const double bend = acceleration_bound(loop_, {from.parameter, to.parameter}) * step * step / 8;
    const double error = Cell(from, to, bend).error(columns_);
    if (error <= allowed_ && !(turns_between(loop_, sampling_, from, to) > 1)) {
      error_ = std::max(error_, error);
      refuse_too_many();
      rows_.push_back(to);
      return;
    }
    if (depth == kDeepest) {
      throw Error(Errc::infeasible_blend,
                  "the ball turns so sharply where the pipes all but touch that no mesh keeps to "
                  "the tolerance of " +
                      decimal(sampling_.tolerance, kMessageDigits));
    }
    const FilletRow middle = row(from.parameter + step / 2);
    divide(from, middle, depth + 1);
    divide(middle, to, depth + 1);
  }

  void refuse_too_many() const {
    if (2.0 * double(rows_.size()) * columns_ > double(sampling_.most_triangles)) {
      throw Error(Errc::limit_exceeded,
                  "a tolerance of " + decimal(sampling_.tolerance, kMessageDigits) +
                      " asks for more than " + count_text(double(sampling_.most_triangles)) +
                      " triangles for this fillet alone; use a larger one, or a higher limit");
    }
  }

  static constexpr int kDeepest = 24;
  const CanalFillet& loop_;
  const FilletSampling& sampling_;
  double allowed_;
  std::uint32_t columns_ = 0;
  std::vector<FilletRow> rows_;
  double error_ = 0;
};

class Mesher {
 public:
  Mesher(const Rows& rows, double grid)
      : rows_(rows.rows()), columns_(rows.columns()), grid_(grid) {
    for (const FilletRow& row : rows_) {
      for (std::uint32_t j = 0; j <= columns_; ++j) {
        vertices_.push_back(vertex(point(row.arc, row.arc.angle * j / columns_)));
      }
    }
  }

  FilletMesh run() {
    const std::size_t count = rows_.size();
    for (std::size_t i = 0; i < count; ++i) {
      for (std::uint32_t j = 0; j < columns_; ++j) {
        append_cell(i, (i + 1) % count, j);
      }
    }
    for (std::size_t i = 0; i < count; ++i) {
      append_foot(at(i, 0), result_.feet[0]);
      append_foot(at(i, columns_), result_.feet[1]);
    }
    return std::move(result_);
  }

 private:
  // Points of one row may coincide; others do not.
  std::uint32_t vertex(const Vec3& point) {
    TriMesh& mesh = result_.tessellation.mesh;
    const Vec3 place = snapped(point, grid_);
    const auto [entry, is_new] = vertex_at_.try_emplace(place, std::uint32_t(mesh.points.size()));
    if (is_new) {
      mesh.points.push_back(place);
    }
    return entry->second;
  }

  [[nodiscard]] std::uint32_t at(std::size_t row, std::uint32_t column) const {
    return vertices_[row * (columns_ + 1) + column];
  }

  void append_foot(std::uint32_t vertex, std::vector<Vec3>& feet) const {
    const Vec3& place = result_.tessellation.mesh.points[vertex];
    if (feet.empty() || feet.back() != place) {
      feet.push_back(place);
    }
  }

  // Seen from the balls: along the way, then from the first foot to the second, if this is so.
  void append_cell(std::size_t row, std::size_t next, std::uint32_t column) {
    // Where the feet coincide an arc has no sense.
    const bool wider = rows_[row].arc.angle > rows_[next].arc.angle;
    const FilletRow& here = wider ? rows_[row] : rows_[next];
    const Vec3 around = here.arc.to_first.cross(here.arc.across);
    const bool forward = around.dot(here.ball.velocity) > 0;
    std::array<std::uint32_t, 4> corner{at(row, column), at(next, column), at(next, column + 1),
                                        at(row, column + 1)};
    if (!forward) {
      std::swap(corner[1], corner[3]);
    }
    const auto& points = result_.tessellation.mesh.points;
    const auto length = [&](std::size_t i, std::size_t k) {
      return (points[corner.at(i)] - points[corner.at(k)]).squaredNorm();
    };
    if (length(0, 2) <= length(1, 3)) {
      append({corner[0], corner[1], corner[2]});
      append({corner[0], corner[2], corner[3]});
    } else {
      append({corner[0], corner[1], corner[3]});
      append({corner[1], corner[2], corner[3]});
    }
  }

  void append(const Triangle& t) {
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) {
      result_.tessellation.mesh.triangles.push_back(t);
    }
  }

  const std::vector<FilletRow>& rows_;
  std::uint32_t columns_;
  double grid_;
  std::map<Vec3, std::uint32_t, numbers::PointOrder> vertex_at_;
  std::vector<std::uint32_t> vertices_;
  FilletMesh result_;
};

}  // namespace

ExpectedFillet expected_fillet(const CanalFillet& loop, const FilletSampling& sampling) {
  constexpr int kSteps = 16;
  constexpr double kHalved = 1.4;  // rows are placed by halving
  const double allowed = allowed_error(sampling.tolerance, displacement_of(loop, sampling.grid));
  ExpectedFillet result;
  double columns = 2, rows = 0;
  FilletRow last = row_at(loop, 0);
  for (int i = 1; i <= kSteps; ++i) {
    const FilletRow next = row_at(loop, kTurn * i / kSteps);
    columns = std::max(columns, columns_across(next, allowed));
    const double bend = (next.ball.velocity - last.ball.velocity).norm() * (kTurn / kSteps) / 8;
    rows += std::max(turns_between(loop, sampling, last, next), std::sqrt(4 * bend / allowed));
    for (std::size_t side = 0; side < 2; ++side) {
      result.feet.at(side).push_back(next.arc.feet.at(side));
    }
    last = next;
  }
  result.triangles = 2 * kHalved * rows * columns;
  return result;
}

FilletMesh fillet_mesh(const CanalFillet& loop, const FilletSampling& sampling) {
  const double displacement = displacement_of(loop, sampling.grid);
  const Rows rows(loop, sampling, allowed_error(sampling.tolerance, displacement));
  FilletMesh result = Mesher(rows, sampling.grid).run();
  result.columns = rows.columns();
  result.tessellation.bands = std::uint32_t(rows.rows().size());
  result.tessellation.error_bound = rows.error() + displacement;
  for (const FilletRow& row : rows.rows()) {
    result.tessellation.knots.push_back(row.parameter);
  }
  return result;
}

}  // namespace dupin::surfaces
