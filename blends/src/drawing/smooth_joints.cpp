#include "drawing/smooth_joints.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Dense>

#include "drawing/sheet.h"
#include "numbers/angle.h"

namespace dupin::drawing {
namespace {

// The end row of a part: an ellipse, and the normals on it.
class EndRow {
 public:
  EndRow(const Chain& chain, End end)
      : sheet_(sheet_of(end == End::start ? chain.pieces.front() : chain.pieces.back())),
        t_(end == End::start ? 0 : 1),
        center_((at(0).position + at(0.5).position) / 2) {
    axes_.col(0) = at(0).position - center_;
    axes_.col(1) = at(0.25).position - center_;
  }

  [[nodiscard]] SheetPoint at(double v) const { return sheet_.at(t_, v); }
  // The normal on the row nearest to the point.
  [[nodiscard]] Vec3 normal_near(const Vec3& point) const {
    const Eigen::Vector2d place = axes_.colPivHouseholderQr().solve(point - center_);
    const double v = std::atan2(place[1], place[0]) / (2 * std::numbers::pi);
    return at(v < 0 ? v + 1 : v).normal;
  }

 private:
  Sheet sheet_;
  double t_;
  Vec3 center_;
  Eigen::Matrix<double, 3, 2> axes_;
};

bool is_smooth(const PartSurface& a, End a_end, const PartSurface& b, End b_end, double angle) {
  const auto *first = std::get_if<Chain>(&a), *second = std::get_if<Chain>(&b);
  if (first == nullptr || second == nullptr) {
    return false;
  }
  constexpr int kPlaces = 8;
  const EndRow row(*first, a_end), other(*second, b_end);
  for (int i = 0; i < kPlaces; ++i) {
    const SheetPoint point = row.at(double(i) / kPlaces);
    if (!(numbers::angle_between(point.normal, other.normal_near(point.position)) <= angle)) {
      return false;
    }
  }
  return true;
}

}  // namespace

NamePair name_pair(const std::string& a, const std::string& b) { return std::minmax(a, b); }

std::set<NamePair> smooth_joints(const ResolvedAssembly& assembly, double angle) {
  std::set<NamePair> result;
  for (const ResolvedPart& part : assembly.parts) {
    for (const End end : {End::start, End::end}) {
      if (const auto& joined = part.joined.at(at(end))) {
        const ResolvedPart& other = assembly.parts[joined->part];
        if (is_smooth(part.shape, end, other.shape, joined->end, angle)) {
          result.insert(name_pair(part.name, other.name));
        }
      }
    }
  }
  for (const ResolvedFillet& fillet : assembly.fillets) {
    if (!fillet.shape.is_cope()) {
      for (const std::uint32_t part : fillet.between) {
        result.insert(name_pair(fillet.name, assembly.parts[part].name));
      }
    }
  }
  for (const ResolvedJunction& junction : assembly.junctions) {
    for (const std::uint32_t arm : junction.arms) {
      result.insert(name_pair(junction.name, assembly.parts[arm].name));
    }
  }
  return result;
}

}  // namespace dupin::drawing
