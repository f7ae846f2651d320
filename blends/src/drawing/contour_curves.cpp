#include "drawing/contour_curves.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace dupin::drawing {
namespace {

// The great circle across the direction, within the tolerance of its chords.
ZeroLine great_circle(const Sphere& ball, const Vec3& towards, double tolerance) {
  constexpr double kFewest = 16, kMost = 65536;
  const double half_step = std::acos(1 - std::min(tolerance / ball.radius, 1.0));
  const auto count =
      static_cast<int>(std::clamp(std::ceil(std::numbers::pi / half_step), kFewest, kMost));
  const Vec3 first = towards.unitOrthogonal(), second = towards.cross(first);
  ZeroLine result;
  result.reserve(std::size_t(count) + 1);
  for (int i = 0; i <= count; ++i) {
    const double angle = 2 * std::numbers::pi * (i % count) / count;
    const Vec3 normal = std::cos(angle) * first + std::sin(angle) * second;
    result.push_back({ball.center + ball.radius * normal, normal, 1 / ball.radius});
  }
  return result;
}

class Contours {
 public:
  Contours(const Vec3& towards, double tolerance) : towards_(towards), tolerance_(tolerance) {}

  void add(const std::vector<Sheet>& sheets) {
    for (const Sheet& sheet : sheets) {
      std::ranges::move(zero_lines(sheet, towards_, tolerance_), std::back_inserter(curves_));
    }
  }
  void operator()(const Sphere& ball) {
    curves_.push_back(great_circle(ball, towards_, tolerance_));
  }
  void operator()(const Chain& chain) {
    add(sheets_of(chain));
    if (chain.joints == Joints::spherical) {
      const std::vector<PeArc> arcs = cyclide_pieces(chain);
      for (std::size_t i = 1; i < arcs.size(); ++i) {
        (*this)(Sphere{arcs[i].start().m, arcs[i].start().r});
      }
    }
  }

  [[nodiscard]] std::vector<ZeroLine> taken(bool turned) {
    for (ZeroLine& curve : curves_) {
      for (ZeroPoint& point : curve) {
        point.normal = turned ? Vec3(-point.normal) : point.normal;
        point.curvature = turned ? -point.curvature : point.curvature;
      }
    }
    return std::exchange(curves_, {});
  }

 private:
  const Vec3& towards_;
  double tolerance_;
  std::vector<ZeroLine> curves_;
};

}  // namespace

std::vector<PartContours> contours_of(const ResolvedAssembly& assembly, const Vec3& towards,
                                      double tolerance, bool are_bores) {
  std::vector<PartContours> result;
  result.reserve(assembly.parts.size() + assembly.fillets.size() + assembly.junctions.size());
  Contours contours(towards, tolerance);
  for (const ResolvedPart& part : assembly.parts) {
    std::visit(contours, part.shape);
    result.push_back({part.name, contours.taken(are_bores)});
  }
  for (const ResolvedFillet& fillet : assembly.fillets) {
    contours.add(sheets_of(fillet.shape));
    result.push_back({fillet.name, contours.taken(are_bores)});
  }
  for (const ResolvedJunction& junction : assembly.junctions) {
    contours(junction.shape.hub);
    result.push_back({junction.name, contours.taken(are_bores)});
  }
  return result;
}

std::vector<ZeroLine> contours_of(const PartSurface& surface, const Vec3& towards,
                                  double tolerance) {
  Contours result(towards, tolerance);
  std::visit(result, surface);
  return result.taken(false);
}

}  // namespace dupin::drawing
