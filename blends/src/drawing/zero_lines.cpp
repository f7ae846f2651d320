#include "drawing/zero_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include <Eigen/Dense>

#include "drawing/polyline.h"

namespace dupin::drawing {
namespace {

using Place = Eigen::Vector2d;  // (t, v) in cells

// Where the sign changes along an edge of the grid: from node (row, column), along t or v.
struct GridEdge {
  std::uint32_t row, column;
  bool along_t;
  friend auto operator<=>(const GridEdge&, const GridEdge&) = default;
};

class Tracer {
 public:
  Tracer(const Sheet& sheet, const Vec3& direction, double tolerance)
      : sheet_(sheet), direction_(direction), tolerance_(tolerance) {
    values_.resize(std::size_t(sheet.rows + 1) * (sheet.columns + 1));
    for (std::uint32_t i = 0; i <= sheet.rows; ++i) {
      for (std::uint32_t j = 0; j <= sheet.columns; ++j) {
        value(i, j) = slope({double(i), double(j)});
      }
      if (sheet.closed) {
        value(i, sheet.columns) = value(i, 0);
      }
    }
    take_rims();
  }

  std::vector<ZeroLine> run() {
    for (std::uint32_t i = 0; i < sheet_.rows; ++i) {
      for (std::uint32_t j = 0; j < sheet_.columns; ++j) {
        link_cell(i, j);
      }
    }
    std::vector<ZeroLine> result;
    for (const Rim& rim : rims_) {
      result.push_back(traced(rim));
    }
    for (const bool ends_only : {true, false}) {  // what is left when open ones are gone is closed
      for (const auto& [edge, neighbours] : links_) {
        if (!(ends_only && neighbours.size() > 1)) {
          while (const auto line = next_line(edge)) {
            result.push_back(refined(*line));
          }
        }
      }
    }
    return result;
  }

 private:
  double& value(std::uint32_t i, std::uint32_t j) {
    return values_[std::size_t(i) * (sheet_.columns + 1) + j];
  }

  static constexpr double kNearly = 1e-9;  // at right angles: of the normals of rounded rings

  // A whole side of the sheet, as where a blend ends in a pipe that is seen along its axis.
  struct Rim {
    Place from, to;
  };

  // Of a sheet that is more than that. The nodes then count as what is beside them does: no other
  // line is found along the rim.
  void take_rims() {
    if (std::ranges::all_of(values_, [](double v) { return std::abs(v) < kNearly; })) {
      return;
    }
    const auto rows = sheet_.rows, columns = sheet_.columns;
    for (const std::uint32_t i : {0U, rows}) {
      take_rim({Place(i, 0), Place(i, columns)}, columns + 1, [&](std::uint32_t j) {
        return std::pair(&value(i, j), &value(i == 0 ? 1 : i - 1, j));
      });
    }
    if (!sheet_.closed) {
      for (const std::uint32_t j : {0U, columns}) {
        take_rim({Place(0, j), Place(rows, j)}, rows + 1, [&](std::uint32_t i) {
          return std::pair(&value(i, j), &value(i, j == 0 ? 1 : j - 1));
        });
      }
    }
  }

  // `node` gives the value at a node and that beside it.
  template <class Node>
  void take_rim(const Rim& rim, std::uint32_t count, const Node& node) {
    for (std::uint32_t k = 0; k < count; ++k) {
      if (!(std::abs(*node(k).first) < kNearly)) {
        return;
      }
    }
    rims_.push_back(rim);
    for (std::uint32_t k = 0; k < count; ++k) {
      *node(k).first = *node(k).second;
    }
  }

  [[nodiscard]] ZeroLine traced(const Rim& rim) const {
    constexpr int kParts = 32;
    ZeroLine result{zero_point(rim.from)};
    Place last = rim.from;
    for (int k = 1; k <= kParts; ++k) {
      const Place next = rim.from + double(k) / kParts * (rim.to - rim.from);
      append_rim(last, next, 0, result);
      last = next;
    }
    return result;
  }

  void append_rim(const Place& from, const Place& to, int depth, ZeroLine& result) const {
    constexpr int kMostHalvings = 12;
    const Place middle = (from + to) / 2;
    if (depth < kMostHalvings && distance_from_segment(at(middle).position, at(from).position,
                                                       at(to).position) > tolerance_) {
      append_rim(from, middle, depth + 1, result);
      append_rim(middle, to, depth + 1, result);
    } else {
      result.push_back(zero_point(to));
    }
  }

  [[nodiscard]] SheetPoint at(const Place& place) const {
    return sheet_.at(place[0] / sheet_.rows, place[1] / sheet_.columns);
  }

  // The curvature is how fast the normal turns along the direction, by central differences.
  [[nodiscard]] ZeroPoint zero_point(const Place& place) const {
    constexpr double kStep = 1e-3;  // of a cell
    const SheetPoint own = at(place);
    Eigen::Matrix<double, 3, 2> moves;
    Eigen::Vector2d turns;
    for (int i = 0; i < 2; ++i) {
      const Place step = kStep * Place::Unit(i);
      const SheetPoint before = at(clamped(place - step)), after = at(clamped(place + step));
      moves.col(i) = after.position - before.position;
      turns[i] = (after.normal - before.normal).dot(direction_);
    }
    const Eigen::Vector2d along = moves.colPivHouseholderQr().solve(direction_);
    return {own.position, own.normal, turns.dot(along)};
  }

  // What rounding leaves of zero counts as zero, and zero as positive: else a cylinder seen along
  // its axis would have contours all over.
  [[nodiscard]] double slope(const Place& place) const {
    constexpr double kRounding = 1e-12;
    const double result = at(place).normal.dot(direction_);
    return std::abs(result) < kRounding ? 0 : result;
  }

  // The four edges in order around the cell, and the values at their first nodes.
  void link_cell(std::uint32_t i, std::uint32_t j) {
    const std::uint32_t right = j + 1 == sheet_.columns && sheet_.closed ? 0 : j + 1;
    const std::array<GridEdge, 4> edges{
        {{i, j, true}, {i + 1, j, false}, {i, right, true}, {i, j, false}}};
    const std::array<double, 5> corners{value(i, j), value(i + 1, j), value(i + 1, j + 1),
                                        value(i, j + 1), value(i, j)};
    std::vector<GridEdge> crossed;
    for (std::size_t k = 0; k < 4; ++k) {
      if ((corners[k] < 0) != (corners[k + 1] < 0)) {
        crossed.push_back(edges[k]);
      }
    }
    if (crossed.size() == 4 && (slope({i + 0.5, j + 0.5}) < 0) != (corners[0] < 0)) {
      std::rotate(crossed.begin(), crossed.begin() + 1, crossed.end());
    }
    for (std::size_t k = 0; k + 1 < crossed.size(); k += 2) {
      links_[crossed[k]].push_back(crossed[k + 1]);
      links_[crossed[k + 1]].push_back(crossed[k]);
    }
  }

  // Takes links away as it goes along them.
  std::optional<std::vector<GridEdge>> next_line(const GridEdge& start) {
    if (links_[start].empty()) {
      return std::nullopt;
    }
    std::vector<GridEdge> line{start};
    while (!links_[line.back()].empty()) {
      const GridEdge from = line.back(), to = links_[from].back();
      links_[from].pop_back();
      std::vector<GridEdge>& back = links_[to];
      back.erase(std::ranges::find(back, from));
      line.push_back(to);
    }
    return line;
  }

  // Between two places on whose sides the signs differ, by bisection.
  [[nodiscard]] Place root(Place low, Place high) const {
    constexpr int kHalvings = 50;
    const bool is_negative = slope(low) < 0;
    for (int i = 0; i < kHalvings; ++i) {
      const Place middle = (low + high) / 2;
      ((slope(middle) < 0) == is_negative ? low : high) = middle;
    }
    return (low + high) / 2;
  }

  [[nodiscard]] Place root(const GridEdge& edge) const {
    const Place from(edge.row, edge.column);
    return root(from, from + (edge.along_t ? Place(1, 0) : Place(0, 1)));
  }

  [[nodiscard]] ZeroLine refined(const std::vector<GridEdge>& line) const {
    ZeroLine result;
    Place last = root(line.front());
    result.push_back(zero_point(last));
    for (std::size_t i = 1; i < line.size(); ++i) {
      Place next = root(line[i]);
      if (sheet_.closed) {  // across the seam
        next[1] += sheet_.columns * std::round((last[1] - next[1]) / sheet_.columns);
      }
      append(last, next, 0, result);
      last = next;
    }
    return result;
  }

  // The curve from one place to the next one, without its start.
  void append(const Place& from, const Place& to, int depth, ZeroLine& result) const {
    constexpr int kMostHalvings = 12;
    const auto middle = depth < kMostHalvings ? between(from, to) : std::nullopt;
    if (middle && distance_from_segment(at(*middle).position, at(from).position, at(to).position) >
                      tolerance_) {
      append(from, *middle, depth + 1, result);
      append(*middle, to, depth + 1, result);
    } else {
      result.push_back(zero_point(to));
    }
  }

  // The place of the curve on the line across the middle; none where it is farther than they are
  // from each other.
  [[nodiscard]] std::optional<Place> between(const Place& from, const Place& to) const {
    const Place middle = (from + to) / 2, along = (to - from) / 2;
    for (double reach = 0.125; reach <= 1; reach *= 2) {
      const Place across = reach * Place(-along[1], along[0]);
      const Place low = clamped(middle - across), high = clamped(middle + across);
      if ((slope(low) < 0) != (slope(high) < 0)) {
        return root(low, high);
      }
    }
    return std::nullopt;
  }

  [[nodiscard]] Place clamped(const Place& place) const {
    const double columns = sheet_.columns;
    return {std::clamp(place[0], 0.0, double(sheet_.rows)),
            sheet_.closed ? place[1] : std::clamp(place[1], 0.0, columns)};
  }

  const Sheet& sheet_;
  const Vec3& direction_;
  double tolerance_;
  std::vector<double> values_;
  std::vector<Rim> rims_;
  std::map<GridEdge, std::vector<GridEdge>> links_;
};

}  // namespace

std::vector<ZeroLine> zero_lines(const Sheet& sheet, const Vec3& direction, double tolerance) {
  return Tracer(sheet, direction, tolerance).run();
}

}  // namespace dupin::drawing
