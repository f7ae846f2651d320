#include "meshing/edge_lengths.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <numbers>
#include <sstream>
#include <unordered_map>

#include <Eigen/Geometry>

#include "dupin/kernel/error.h"

namespace dupin::meshing {
namespace {

/// Directions about a point, in groups.
class Turns {
 public:
  void add(std::uint32_t group, const Vec3& direction, double distance) {
    groups_[group].push_back({direction, distance});
  }
  /// The largest angle between the direction nearest to the point and others of one group, of those
  /// within a distance.
  [[nodiscard]] double largest(double within) const {
    double largest = 0;
    for (const auto& [group, items] : groups_) {
      const Item& nearest = *std::ranges::min_element(items, {}, &Item::distance);
      for (const Item& item : items) {
        if (item.distance <= within) {
          const Vec3 &a = nearest.direction, &b = item.direction;
          largest = std::max(largest, std::atan2(a.cross(b).norm(), a.dot(b)));
        }
      }
    }
    return largest;
  }

 private:
  struct Item {
    Vec3 direction;
    double distance;
  };
  std::unordered_map<std::uint32_t, std::vector<Item>> groups_;
};

std::vector<Vec3> points_of(const std::vector<Curve>& curves) {
  std::vector<Vec3> points;
  for (const Curve& curve : curves) {
    points.insert(points.end(), curve.points.begin(), curve.points.end());
  }
  return points;
}

std::vector<Triangle> edges_of(const std::vector<Curve>& curves) {
  std::vector<Triangle> edges;
  std::uint32_t at = 0;
  for (const Curve& curve : curves) {
    for (std::size_t i = 1; i < curve.points.size(); ++i, ++at) {
      edges.push_back({at, at + 1, at + 1});
    }
    ++at;
  }
  return edges;
}

std::vector<std::uint32_t> curves_of_edges(const std::vector<Curve>& curves) {
  std::vector<std::uint32_t> numbers;
  for (std::uint32_t c = 0; c < curves.size(); ++c) {
    numbers.insert(numbers.end(), curves[c].points.size() - 1, c);
  }
  return numbers;
}

std::vector<std::set<std::uint32_t>> regions_beside(const std::vector<Curve>& curves) {
  const auto less = [](const Vec3& a, const Vec3& b) {
    return std::ranges::lexicographical_compare(a, b);
  };
  std::map<Vec3, std::set<std::uint32_t>, decltype(less)> at_ends(less);
  for (const Curve& curve : curves) {
    for (const Vec3& end : {curve.points.front(), curve.points.back()}) {
      at_ends[end].insert(curve.regions.begin(), curve.regions.end());
    }
  }
  std::vector<std::set<std::uint32_t>> beside;
  for (const Curve& curve : curves) {
    beside.push_back(at_ends[curve.points.front()]);
    beside.back().merge(std::set(at_ends[curve.points.back()]));
  }
  return beside;
}

}  // namespace

EdgeLengths::EdgeLengths(const ReferenceSurface& surface, const Features& features, double distance,
                         double largest)
    : surface_(surface),
      features_(features),
      distance_(distance),
      largest_(largest),
      points_(points_of(features.curves)),
      edges_(edges_of(features.curves)),
      curves_(curves_of_edges(features.curves)),
      beside_(regions_beside(features.curves)),
      curve_edges_(points_, edges_, curves_) {}

double EdgeLengths::at(const Vec3& point) const {
  constexpr double kShrink = 0.8;
  double length = std::min(largest_, room_about(point));
  Turns of_regions, of_curves;
  surface_.visit_near(point, length, [&](std::uint32_t f, const Vec3&, double distance) {
    of_regions.add(surface_.region(f), features_.normals[f], distance);
  });
  curve_edges_.visit_near(point, length, [&](std::uint32_t e, const Vec3&, double distance) {
    of_curves.add(curves_[e], points_[edges_[e][1]] - points_[edges_[e][0]], distance);
  });
  // A turn is at most pi, so the loop ends at a length of the distance.
  while (length > distance_ &&
         length * std::max(of_regions.largest(length), of_curves.largest(length)) / 2 > distance_) {
    length *= kShrink;
  }
  return length;
}

double EdgeLengths::gap_to_others(const Vec3& point, std::uint32_t curve, double reach) const {
  double nearest = reach;
  curve_edges_.visit_near(point, reach, [&](std::uint32_t e, const Vec3&, double distance) {
    if (curves_[e] != curve) {
      nearest = std::min(nearest, distance);
    }
  });
  return nearest;
}

void EdgeLengths::require_room(std::size_t most) const {
  // Balls about a curve have no room for more than the gap to others; at its ends, where it meets
  // them, there is one for an eighth of it, or of the largest length.
  std::size_t balls = 0;
  for (std::uint32_t c = 0; c < features_.curves.size(); ++c) {
    const std::vector<Vec3>& points = features_.curves[c].points;
    double length = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
      length += (points[i] - points[i - 1]).norm();
    }
    const double end = std::min(length, largest_) / 8;
    double before = 0, at = end;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const double edge = (points[i] - points[i - 1]).norm();
      while (at <= std::min(before + edge, length - end)) {
        const Vec3 place = points[i - 1] + (at - before) / edge * (points[i] - points[i - 1]);
        const double gap = gap_to_others(place, c, largest_);
        if (++balls > most || !(at + gap > at)) {
          std::ostringstream text;
          text << "sharp edges or borders come within " << gap << " of each other near "
               << place.x() << " " << place.y() << " " << place.z()
               << ", and a mesh that keeps them gets too many points; join the patches there";
          throw Error(Errc::limit_exceeded, text.str());
        }
        at += gap;
      }
      before += edge;
    }
  }
}

double EdgeLengths::room_about(const Vec3& point) const {
  // Generators compute points of curves, which are then beside them by rounding.
  const double beside = largest_ * 0x1p-20;
  std::set<std::uint32_t> own;
  curve_edges_.visit_near(point, beside, [&](std::uint32_t e, const Vec3&, double) {
    own.insert(beside_[curves_[e]].begin(), beside_[curves_[e]].end());
  });
  if (own.empty()) {
    return largest_;
  }
  double nearest = 2 * largest_;
  surface_.visit_near(point, nearest, [&](std::uint32_t f, const Vec3&, double distance) {
    if (!own.contains(surface_.region(f))) {
      nearest = std::min(nearest, distance);
    }
  });
  return nearest / 2;
}

}  // namespace dupin::meshing
