#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "canal/arc_rows.h"
#include "dupin/blends/nurbs.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "surfaces/nurbs_rows.h"

namespace dupin {
namespace {

using canal::ArcRows;
using numbers::Interval;

constexpr double kTurn = 2 * std::numbers::pi;
constexpr std::size_t kMostCubics = 4096;  // as of parts

using Row = std::array<std::array<double, 4>, 3>;

// Control rows of arcs at a parameter, and their derivatives.
struct RowAt {
  double parameter = 0;
  Row value{}, rate{};
  double width = 0, rate_width = 0;  // of the enclosures they are from
  double size = 0;                   // of the numbers
};

Interval enclosure(const ArcRows& rows, std::size_t row, std::size_t coordinate,
                   std::size_t order) {
  if (coordinate < 3) {
    return rows.points.at(row).at(coordinate).at.at(order);
  }
  return row == 1 ? rows.weight.at.at(order) : Interval(order == 0 ? 1 : 0);
}

RowAt row_at(const CanalFillet& loop, double parameter, const ParameterInterval& stretch) {
  const ArcRows rows = canal::arc_rows(loop, {parameter, parameter}, stretch);
  RowAt result;
  result.parameter = parameter;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 4; ++k) {
      const Interval value = enclosure(rows, i, k, 0), rate = enclosure(rows, i, k, 1);
      result.value.at(i).at(k) = middle(value);
      result.rate.at(i).at(k) = middle(rate);
      result.width = std::max(result.width, value.upper - value.lower);
      result.rate_width = std::max(result.rate_width, rate.upper - rate.lower);
      result.size = std::max(result.size, value.magnitude());
    }
  }
  return result;
}

// Of the cubics with the values and derivatives of both ends: f - cubic is at most
// (b - a)^4 / 384 times the largest fourth derivative. Homogeneous coordinates are taken from a
// point of the arcs, so that the weight's error counts by their size only.
double cubic_error(const CanalFillet& loop, const RowAt& from, const RowAt& to,
                   const ParameterInterval& stretch) {
  const ArcRows over = canal::arc_rows(loop, {from.parameter, to.parameter}, stretch);
  const Interval length = Interval(to.parameter) - from.parameter;
  const Interval share = square(square(length)) / Interval(16);  // of the fourth coefficient
  const double weight_error = (share * over.weight.at[4].magnitude()).upper;
  const double weight = over.weight.at[0].lower - weight_error;
  std::array<double, 3> errors{};
  Interval reach = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    Interval squared = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double origin = from.value[0].at(k);
      const Interval fourth = enclosure(over, i, k, 4) - origin * enclosure(over, i, 3, 4);
      squared = squared + square(Interval(fourth.magnitude()));
    }
    errors.at(i) = (share * sqrt(squared)).upper;
  }
  for (const std::size_t i : {std::size_t{0}, std::size_t{2}}) {
    Interval squared = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      squared =
          squared + square(Interval((enclosure(over, i, k, 0) - from.value[0].at(k)).magnitude()));
    }
    reach = std::max(reach.upper, sqrt(squared).upper);
  }
  // An arc of less than half a turn is within its chord's length of either end.
  const Interval arc = reach * Interval(3);
  const double rounding = (from.width + to.width) +
                          length.upper * (from.rate_width + to.rate_width) +
                          std::ldexp(from.size + to.size, -47);
  const Interval ends = std::max(errors[0], errors[2]);
  const Interval inner = (Interval(errors[1]) + arc * weight_error) / Interval(2);
  const Interval sum =
      (ends + inner) / ((Interval(1) + weight) / Interval(2)) + Interval(8) * rounding;
  return weight > 0 ? sum.upper : std::numeric_limits<double>::infinity();
}

// The loop between corners, by halving.
class Lofted {
 public:
  Lofted(const CanalFillet& loop, double tolerance) : loop_(loop), tolerance_(tolerance) {}

  // A quarter of a turn, which follows the one before.
  void append(const ParameterInterval& quarter) {
    const RowAt last = row_at(loop_, quarter.to, quarter);
    if (rows_.empty()) {
      rows_.push_back(row_at(loop_, quarter.from, quarter));
    }
    divide(rows_.back(), last, quarter);
  }

  [[nodiscard]] double error() const { return error_; }

  // C1: interior knots are double.
  [[nodiscard]] NurbsSurface surface() const {
    NurbsSurface result{3, 2, {0, 0, 0, 0}, {0, 0, 0, 1, 1, 1}, {}};
    const double first = rows_.front().parameter, length = rows_.back().parameter - first;
    const auto append_row = [&](const RowAt& row, double ahead) {
      result.net.emplace_back();
      for (std::size_t i = 0; i < 3; ++i) {
        std::array<double, 4> point{};
        for (std::size_t k = 0; k < 4; ++k) {
          point.at(k) = row.value.at(i).at(k) + ahead * row.rate.at(i).at(k);
        }
        result.net.back().push_back(point);
      }
    };
    append_row(rows_.front(), 0);
    for (std::size_t i = 0; i + 1 < rows_.size(); ++i) {
      const double third = (rows_[i + 1].parameter - rows_[i].parameter) / 3;
      append_row(rows_[i], third);
      append_row(rows_[i + 1], -third);
      const double knot = i + 2 < rows_.size() ? (rows_[i + 1].parameter - first) / length : 1.0;
      result.knots_along.insert(result.knots_along.end(), i + 2 < rows_.size() ? 2 : 4, knot);
    }
    append_row(rows_.back(), 0);
    return result;
  }

 private:
  void divide(const RowAt& from, const RowAt& to, const ParameterInterval& quarter) {
    const double error = cubic_error(loop_, from, to, quarter);
    if (error <= tolerance_) {
      error_ = std::max(error_, error);
      rows_.push_back(to);
      return;
    }
    const double half = std::midpoint(from.parameter, to.parameter);
    if (rows_.size() > kMostCubics || !(from.parameter < half && half < to.parameter)) {
      throw Error(Errc::limit_exceeded, "a tolerance of " + decimal(tolerance_, kMessageDigits) +
                                            " takes more than " + std::to_string(kMostCubics) +
                                            " cubics along the fillet; use a larger one");
    }
    const RowAt middle = row_at(loop_, half, quarter), first = from;
    divide(first, middle, quarter);
    divide(middle, to, quarter);
  }

  const CanalFillet& loop_;
  double tolerance_;
  std::vector<RowAt> rows_;
  double error_ = 0;
};

NurbsForm exact_form(const std::array<CanalNet, 4>& nets) {
  NurbsForm form;
  for (const CanalNet& net : nets) {
    NurbsSurface surface{10, 2, {}, {0, 0, 0, 1, 1, 1}, {}};
    surface.knots_along.assign(22, 0);
    std::fill(surface.knots_along.begin() + 11, surface.knots_along.end(), 1);
    for (std::size_t i = 0; i < 11; ++i) {
      surface.net.push_back({net[0].at(i), net[1].at(i), net[2].at(i)});
    }
    form.surfaces.push_back(std::move(surface));
  }
  return form;
}

}  // namespace

NurbsForm nurbs(const CanalFillet& loop, double tolerance) {
  surfaces::require_nurbs_tolerance(tolerance);
  if (const auto nets = exact_nets(loop)) {
    return exact_form(*nets);
  }
  const std::vector<double> sharp = corners(loop);
  // Quarters from a corner on, if there is one; a surface begins at each.
  const int first = !sharp.empty() && sharp.front() > 0 ? 1 : -1;
  std::vector<Lofted> lofts;
  for (int quarter = 0; quarter < 4; ++quarter) {
    const ParameterInterval at{kTurn / 4 * (quarter + first), kTurn / 4 * (quarter + first + 1)};
    const bool begins = quarter == 0 || std::ranges::any_of(sharp, [&](double corner) {
                          return std::abs(std::remainder(corner - at.from, kTurn)) < 1e-9;
                        });
    if (begins) {
      lofts.emplace_back(loop, tolerance);
    }
    lofts.back().append(at);
  }
  NurbsForm form;
  for (const Lofted& loft : lofts) {
    form.surfaces.push_back(loft.surface());
    form.error_bound = std::max(form.error_bound, loft.error());
  }
  return form;
}

}  // namespace dupin
