#include "drawings/annotations.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <limits>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "dupin/kernel/decimal.h"

namespace dupin::drawings {
namespace {

using Eigen::Vector2d;
using Box = Eigen::AlignedBox2d;

constexpr double kLineHeight = 1.5 * kTextHeight;

// Letters of most fonts are no wider on average.
double width_of(const std::string& text) {
  const auto letters =
      std::ranges::count_if(text, [](char c) { return (std::uint8_t(c) & 0xC0) != 0x80; });
  return 0.62 * kFontSize * double(letters);
}

bool crosses(const Box& box, const Vector2d& a, const Vector2d& b) {
  // By the slab method.
  double from = 0, to = 1;
  for (int axis = 0; axis < 2; ++axis) {
    const double step = b[axis] - a[axis];
    const double low = box.min()[axis] - a[axis], high = box.max()[axis] - a[axis];
    if (step == 0) {
      if (low > 0 || high < 0) {
        return false;
      }
      continue;
    }
    from = std::max(from, std::min(low / step, high / step));
    to = std::min(to, std::max(low / step, high / step));
  }
  return from <= to;
}

std::vector<std::string> note_of(const Drawing& drawing, const DrawnPart& part,
                                 const SheetOptions& options) {
  std::vector<std::string> lines;
  if (options.names) {
    lines.push_back(part.name);
  }
  if (options.dimensions && !part.diameters.empty()) {
    const std::string first = length_text(drawing, part.diameters.front());
    const std::string last = length_text(drawing, part.diameters.back());
    lines.push_back("\u2300" + first + (last == first ? "" : " / \u2300" + last));
  }
  return lines;
}

bool is_outline(Pen pen) { return pen == Pen::contour || pen == Pen::edge || pen == Pen::hidden; }

// Of the solid alone, or with all that is drawn beside it.
Box bounds_of(const PaperSheet& sheet, bool with_others) {
  Box box;
  for (const PaperLine& line : sheet.lines) {
    if (with_others || is_outline(line.pen)) {
      for (const Vector2d& point : line.points) {
        box.extend(point);
      }
    }
  }
  return box;
}

Box around(const Vector2d& a, const Vector2d& b) { return {a.cwiseMin(b), a.cwiseMax(b)}; }

// In millimetres, of which a line has not too many.
double square_for(const PaperSheet& sheet) {
  constexpr double kSquare = 10, kMostOfLine = 256;
  const Box box = bounds_of(sheet, true);
  return box.isEmpty() ? kSquare : std::max(kSquare, box.sizes().maxCoeff() / kMostOfLine);
}

// Things on paper by the squares that they reach into.
template <class What>
class PaperGrid {
 public:
  explicit PaperGrid(double square) : square_(square) {}

  void insert(const Box& box, const What& what) {
    for_each_square(box, [&](const Square& square) { squares_[square].push_back(what); });
  }

  // What has a square in common with the box, in order.
  [[nodiscard]] std::vector<What> near(const Box& box) const {
    std::vector<What> found;
    for_each_square(box, [&](const Square& square) {
      if (const auto own = squares_.find(square); own != squares_.end()) {
        found.insert(found.end(), own->second.begin(), own->second.end());
      }
    });
    std::ranges::sort(found);
    const auto repeated = std::ranges::unique(found);
    found.erase(repeated.begin(), repeated.end());
    return found;
  }

 private:
  using Square = std::array<double, 2>;  // whole numbers

  template <class Visit>
  void for_each_square(const Box& box, const Visit& visit) const {
    const Eigen::Array2d low = (box.min() / square_).array().floor(),
                         high = (box.max() / square_).array().floor();
    for (double x = low[0]; x <= high[0]; ++x) {
      for (double y = low[1]; y <= high[1]; ++y) {
        visit({x, y});
      }
    }
  }

  double square_;
  std::map<Square, std::vector<What>> squares_;
};

class NotePlacer {
 public:
  explicit NotePlacer(PaperSheet& sheet)
      : sheet_(sheet), square_(square_for(sheet)), placed_boxes_(square_), lines_(square_) {
    for (std::size_t i = 0; i < sheet_.lines.size(); ++i) {
      add_line(i);
    }
  }

  void place(const std::vector<std::string>& note, const Vector2d& anchor) {
    double width = 0;
    for (const std::string& line : note) {
      width = std::max(width, width_of(line));
    }
    const Vector2d size(width, kLineHeight * double(note.size()));
    Box best;
    double least = std::numeric_limits<double>::infinity();
    for (const double radius : {7.0, 12.0, 18.0, 26.0, 36.0, 50.0}) {
      for (const int eighth : {7, 5, 1, 3, 0, 4, 6, 2}) {  // above and to the right first
        const double angle = eighth * std::numbers::pi / 4;
        const Vector2d away(std::cos(angle), std::sin(angle));
        const Vector2d near = anchor + radius * away;
        // The corner, or side's middle, that is nearest to the anchor.
        const Vector2d middle = near + Vector2d(away[0] * size[0] / 2, away[1] * size[1] / 2);
        const Box box(middle - size / 2, middle + size / 2);
        if (const double cost = cost_of(box, anchor) + radius; cost < least) {
          least = cost;
          best = box;
        }
      }
    }
    write(note, best, anchor);
  }

 private:
  // A line of the sheet from one of its points to the next.
  struct Stretch {
    std::size_t line, point;
    auto operator<=>(const Stretch&) const = default;
  };

  // Piece by piece, for long ones at an angle.
  void add_line(std::size_t line) {
    const auto& points = sheet_.lines[line].points;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const Vector2d way = points[i + 1] - points[i];
      const double pieces = std::max(1.0, std::ceil(way.cwiseAbs().minCoeff() / square_));
      for (double k = 0; k < pieces; ++k) {
        lines_.insert(around(points[i] + k / pieces * way, points[i] + (k + 1) / pieces * way),
                      {line, i});
      }
    }
  }

  [[nodiscard]] double cost_of(const Box& box, const Vector2d& anchor) const {
    const Box roomy(box.min() - Vector2d::Constant(1), box.max() + Vector2d::Constant(1));
    double cost = 0;
    for (const std::size_t i : placed_boxes_.near(roomy.merged(around(anchor, box.center())))) {
      const Box& other = placed_[i];
      const Box common = roomy.intersection(other);
      cost += common.isEmpty() ? 0 : 1000 + 100 * common.volume();
      cost += crosses(other, anchor, box.center()) ? 200 : 0;
    }
    for (const Stretch& stretch : lines_.near(roomy)) {
      const PaperLine& line = sheet_.lines[stretch.line];
      // Leaders are as bad as lines; axes are not.
      const double weight = line.pen == Pen::center ? 2 : 15;
      cost +=
          crosses(roomy, line.points[stretch.point], line.points[stretch.point + 1]) ? weight : 0;
    }
    return cost;
  }

  void write(const std::vector<std::string>& note, const Box& box, const Vector2d& anchor) {
    placed_boxes_.insert(box, placed_.size());
    placed_.push_back(box);
    for (std::size_t i = 0; i < note.size(); ++i) {
      sheet_.texts.push_back(
          {note[i], box.min() + Vector2d(0, kLineHeight * double(i) + kTextHeight + 0.6)});
    }
    // To the underlined text's nearer end.
    const bool to_left = anchor[0] < box.center()[0];
    const Vector2d left(box.min()[0], box.max()[1]);
    const Vector2d& right = box.max();
    const Vector2d near = to_left ? left : right, far = to_left ? right : left;
    sheet_.lines.push_back({Pen::thin, {}, {anchor, near, far}});
    constexpr double kDot = 0.4;
    PaperLine dot{Pen::arrow, {}, {}, true};
    for (int i = 0; i < 12; ++i) {
      const double angle = i * std::numbers::pi / 6;
      dot.points.emplace_back(anchor + kDot * Vector2d(std::cos(angle), std::sin(angle)));
    }
    sheet_.lines.push_back(std::move(dot));
    add_line(sheet_.lines.size() - 2);
    add_line(sheet_.lines.size() - 1);
  }

  PaperSheet& sheet_;
  double square_;
  std::vector<Box> placed_;
  PaperGrid<std::size_t> placed_boxes_;
  PaperGrid<Stretch> lines_;
};

// Between two places, with arrows pointing outwards at both.
void add_dimension(PaperSheet& sheet, const Vector2d& from, const Vector2d& to,
                   const std::string& text, bool is_upright) {
  const Vector2d along = (to - from).normalized(), across(-along[1], along[0]);
  constexpr double kLength = 2.5, kHalfWidth = 0.4, kAbove = 0.8;
  sheet.lines.push_back({Pen::thin, {}, {from, to}});
  for (const auto& [tip, inwards] : {std::pair(from, along), std::pair(to, Vector2d(-along))}) {
    const Vector2d foot = tip + kLength * inwards;
    sheet.lines.push_back(
        {Pen::arrow, {}, {tip, foot + kHalfWidth * across, foot - kHalfWidth * across}, true});
  }
  const Vector2d up = is_upright ? Vector2d(-1, 0) : Vector2d(0, -1);
  sheet.texts.push_back({text, (from + to) / 2 + kAbove * up, true, is_upright});
}

bool is_along_axis(const Vec3& direction) { return direction.cwiseAbs().maxCoeff() > 1 - 1e-12; }

}  // namespace

std::string length_text(const Drawing& drawing, double length) {
  // To the power of ten above the error, but never to more than seven digits.
  const double least = std::max(drawing.error, 1e-7 * std::abs(length));
  const double step = least > 0 ? std::pow(10.0, std::ceil(std::log10(least))) : 1e-6;
  const double digits = std::max(0.0, -std::log10(step));
  const double power = std::pow(10.0, std::round(digits));
  const double rounded =
      step >= 1 ? step * std::round(length / step) : std::round(length * power) / power;
  const std::string unit =
      drawing.unit == Unit::millimetre ? "" : " " + std::string(symbol(drawing.unit));
  return decimal(rounded) + unit;
}

void add_notes(const Drawing& drawing, const SheetOptions& options, PaperSheet& sheet) {
  NotePlacer placer(sheet);
  for (const DrawnPart& part : drawing.parts) {
    const std::vector<std::string> note = note_of(drawing, part, options);
    if (!note.empty()) {
      placer.place(note, sheet.origin + sheet.factor * Vector2d(part.at[0], -part.at[1]));
    }
  }
}

void add_extents(const Drawing& drawing, PaperSheet& sheet) {
  if (!is_along_axis(drawing.view.right) || !is_along_axis(drawing.view.up)) {
    return;
  }
  const Box solid = bounds_of(sheet, false), all = bounds_of(sheet, true);
  if (solid.isEmpty()) {
    return;
  }
  constexpr double kAway = 10, kGap = 1, kBeyond = 2;
  const double below = all.max()[1] + kAway, beside = all.max()[0] + kAway;
  const Vector2d size = solid.sizes() / sheet.factor;
  for (const double x : {solid.min()[0], solid.max()[0]}) {
    sheet.lines.push_back({Pen::thin, {}, {{x, solid.max()[1] + kGap}, {x, below + kBeyond}}});
  }
  for (const double y : {solid.min()[1], solid.max()[1]}) {
    sheet.lines.push_back({Pen::thin, {}, {{solid.max()[0] + kGap, y}, {beside + kBeyond, y}}});
  }
  add_dimension(sheet, {solid.min()[0], below}, {solid.max()[0], below},
                length_text(drawing, size[0]), false);
  add_dimension(sheet, {beside, solid.max()[1]}, {beside, solid.min()[1]},
                length_text(drawing, size[1]), true);
}

}  // namespace dupin::drawings
