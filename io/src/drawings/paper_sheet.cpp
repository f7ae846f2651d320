#include "drawings/paper_sheet.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "drawings/annotations.h"

namespace dupin::drawings {
namespace {

using Eigen::Vector2d;

constexpr double kAround = 5;  // millimetres of paper
constexpr double kBeyond = 3;  // of axes, beyond what they are of

Pen pen_of(const DrawnLine& line) {
  return line.kind == LineKind::center    ? Pen::center
         : line.hidden                    ? Pen::hidden
         : line.kind == LineKind::contour ? Pen::contour
                                          : Pen::edge;
}

// Axes reach out of the part, but not into the next one's.
void extend_axes(std::vector<PaperLine>& lines) {
  std::vector<Vector2d> ends;
  for (const PaperLine& line : lines) {
    if (line.pen == Pen::center) {
      ends.push_back(line.points.front());
      ends.push_back(line.points.back());
    }
  }
  const auto is_shared = [&](const Vector2d& end) {
    return std::ranges::count_if(
               ends, [&](const Vector2d& other) { return (other - end).norm() < 1e-3; }) > 1;
  };
  for (PaperLine& line : lines) {
    if (line.pen != Pen::center) {
      continue;
    }
    auto& points = line.points;
    const Vector2d first = points.front(), last = points.back();
    if (!is_shared(first)) {
      points.front() += kBeyond * (first - points[1]).normalized();
    }
    if (!is_shared(last)) {
      points.back() += kBeyond * (last - points[points.size() - 2]).normalized();
    }
  }
}

std::vector<PaperLine> lines_of(const Drawing& drawing, double factor) {
  std::vector<PaperLine> result;
  for (const DrawnLine& line : drawing.lines) {
    PaperLine own{pen_of(line), line.part, {}};
    own.is_closed = line.points.size() > 2 && line.points.front() == line.points.back();
    for (std::size_t i = 0; i + (own.is_closed ? 1 : 0) < line.points.size(); ++i) {
      own.points.emplace_back(factor * line.points[i][0], -factor * line.points[i][1]);
    }
    result.push_back(std::move(own));
  }
  extend_axes(result);
  return result;
}

// What lies over what.
int layer(Pen pen) {
  switch (pen) {
    case Pen::hidden:
      return 0;
    case Pen::center:
      return 1;
    case Pen::contour:
    case Pen::edge:
      return 2;
    case Pen::thin:
    case Pen::arrow:
      return 3;
  }
  return 3;
}

// So that all is on the paper.
void place_on_paper(PaperSheet& sheet) {
  Eigen::AlignedBox2d box;
  for (const PaperLine& line : sheet.lines) {
    for (const Vector2d& point : line.points) {
      box.extend(point);
    }
  }
  for (const PaperText& text : sheet.texts) {
    const double width = 0.62 * kFontSize * double(text.text.size());
    const double left = text.is_centered ? width / 2 : 0;
    box.extend(text.is_upright ? Vector2d(text.at[0] - kTextHeight, text.at[1] - left)
                               : Vector2d(text.at[0] - left, text.at[1] - kTextHeight));
    box.extend(text.is_upright ? Vector2d(text.at[0], text.at[1] + left)
                               : Vector2d(text.at[0] + width - left, text.at[1] + 1));
  }
  if (box.isEmpty()) {
    box = Eigen::AlignedBox2d(Vector2d(0, 0));
  }
  const Vector2d shift = Vector2d::Constant(kAround) - box.min();
  for (PaperLine& line : sheet.lines) {
    for (Vector2d& point : line.points) {
      point += shift;
    }
  }
  for (PaperText& text : sheet.texts) {
    text.at += shift;
  }
  sheet.origin += shift;
  sheet.size = box.sizes() + Vector2d::Constant(2 * kAround);
}

}  // namespace

std::string_view name(Pen pen) {
  constexpr std::array<std::string_view, 6> kNames{"contour", "edge", "hidden",
                                                   "center",  "thin", "arrow"};
  return kNames.at(std::size_t(pen));
}

std::vector<double> dashes(Pen pen) {
  return pen == Pen::hidden   ? std::vector<double>{2, 1}
         : pen == Pen::center ? std::vector<double>{6, 1, 0.5, 1}
                              : std::vector<double>{};
}

DrawingScale usual_scale(double real_by_paper) {
  // The least 1, 2 or 5 times a power of ten that is not below it.
  for (int exponent = int(std::floor(std::log10(real_by_paper)));; ++exponent) {
    for (const double digit : {1.0, 2.0, 5.0}) {
      const double power = std::pow(10.0, std::abs(exponent));
      const double ratio = exponent < 0 ? digit / power : digit * power;
      if (ratio >= real_by_paper) {
        // 5 / 100 is 1 / 20, 2 / 100 is 1 / 50.
        return ratio >= 1 ? DrawingScale{1, ratio} : DrawingScale{std::round(power / digit), 1};
      }
    }
  }
}

PaperSheet paper_sheet(const Drawing& drawing, const DrawingScale& scale,
                       const SheetOptions& options) {
  PaperSheet sheet;
  sheet.title = drawing.source + " " + to_string(scale);
  sheet.factor = millimetres(drawing.unit) * scale.paper / scale.real;
  sheet.lines = lines_of(drawing, sheet.factor);
  if (options.names || options.dimensions) {
    add_notes(drawing, options, sheet);
  }
  if (options.dimensions) {
    add_extents(drawing, sheet);
  }
  std::ranges::stable_sort(sheet.lines, {}, [](const PaperLine& line) { return layer(line.pen); });
  place_on_paper(sheet);
  return sheet;
}

}  // namespace dupin::drawings
