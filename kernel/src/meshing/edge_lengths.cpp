#include "meshing/edge_lengths.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>

#include <Eigen/Geometry>

#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "support/none.h"

namespace dupin::meshing {
namespace {

/// What is about a point, in groups: how far does it bend away from the plane, or the line, that is
/// nearest to the point?
class Bends {
 public:
  enum class Of : std::uint8_t { planes, lines };
  explicit Bends(Of of) : of_(of) {}

  struct Item {
    Vec3 direction;   ///< a unit vector, along the line or across the plane
    Vec3 way;         ///< from the point to the item's nearest place
    double distance;  ///< its length
    double extent;    ///< of the item
  };
  void add(std::uint32_t group, const Item& item) { groups_[group].push_back(item); }

  /// The largest way off, of items within a distance.
  [[nodiscard]] double largest(double within) const {
    double largest = 0;
    for (const auto& [group, items] : groups_) {
      const Item& nearest = *std::ranges::min_element(items, {}, &Item::distance);
      for (const Item& item : items) {
        if (item.distance <= within) {
          const double along = std::abs(nearest.direction.dot(item.way));
          const double across = nearest.direction.cross(item.way).norm();
          const double turn = nearest.direction.cross(item.direction).norm();
          largest = std::max(largest, (of_ == Of::planes ? along : across) +
                                          turn * std::min(item.extent, within - item.distance));
        }
      }
    }
    return largest;
  }

 private:
  Of of_;
  std::unordered_map<std::uint32_t, std::vector<Item>> groups_;
};

double extent_of(const Vec3& a, const Vec3& b, const Vec3& c) {
  return std::sqrt(std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()}));
}

std::vector<Vec3> points_of(const std::vector<Curve>& curves) {
  std::vector<Vec3> points;
  for (const Curve& curve : curves) {
    points.insert(points.end(), curve.points.begin(), curve.points.end());
  }
  return points;
}

// Of which all triangles have one normal, but for its rounding. Absorbed ones do not count.
std::vector<std::uint8_t> flat_regions(const Features& features) {
  constexpr double kRounding = 1e-14;
  std::vector<std::uint8_t> is_flat;
  std::vector<std::optional<Vec3>> normal;
  for (std::size_t f = 0; f < features.regions.size(); ++f) {
    const std::uint32_t region = features.regions[f];
    if (region >= is_flat.size()) {
      is_flat.resize(region + 1, 1);
      normal.resize(region + 1);
    }
    if (features.is_absorbed[f] == 0) {
      const Vec3 first = normal[region].value_or(features.normals[f]);
      normal[region] = first;
      if ((first - features.normals[f]).norm() > kRounding) {
        is_flat[region] = 0;
      }
    }
  }
  return is_flat;
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

std::vector<double> starts_of_edges(const std::vector<Curve>& curves) {
  std::vector<double> starts;
  for (const Curve& curve : curves) {
    double at = 0;
    for (std::size_t i = 1; i < curve.points.size(); ++i) {
      starts.push_back(at);
      at += (curve.points[i] - curve.points[i - 1]).norm();
    }
  }
  return starts;
}

std::vector<double> lengths_of_loops(const std::vector<Curve>& curves) {
  std::vector<double> lengths(curves.size(), std::numeric_limits<double>::infinity());
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const std::vector<Vec3>& points = curves[c].points;
    if (points.front() == points.back()) {
      lengths[c] = 0;
      for (std::size_t i = 1; i < points.size(); ++i) {
        lengths[c] += (points[i] - points[i - 1]).norm();
      }
    }
  }
  return lengths;
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

EdgeLengths::EdgeLengths(const mesh::ReferenceSurface& surface, const Features& features,
                         double distance, double largest)
    : surface_(surface),
      features_(features),
      distance_(distance),
      largest_(largest),
      is_flat_(flat_regions(features)),
      points_(points_of(features.curves)),
      edges_(edges_of(features.curves)),
      curves_(curves_of_edges(features.curves)),
      starts_(starts_of_edges(features.curves)),
      curve_lengths_(lengths_of_loops(features.curves)),
      beside_(regions_beside(features.curves)),
      curve_edges_(points_, edges_, curves_) {}

double EdgeLengths::at(const Vec3& point) const {
  return length_at(point, std::min(largest_, room_about(point)), nullptr, support::kNone);
}

double EdgeLengths::along(const Vec3& point, std::uint32_t curve) const {
  return length_at(point, largest_, &features_.curves[curve].regions, curve);
}

double EdgeLengths::length_at(const Vec3& point, double most,
                              const std::array<std::uint32_t, 2>* regions,
                              std::uint32_t curve) const {
  constexpr double kShrink = 0.8, kFirst = 4;
  const auto bend_within = [&](double reach) {
    Bends of_regions(Bends::Of::planes), of_curves(Bends::Of::lines);
    // Flat ones that the point is on bend nowhere.
    const auto may_bend = [&](std::uint32_t f) {
      const std::uint32_t region = surface_.region(f);
      return features_.is_absorbed[f] == 0 &&
             (regions == nullptr ||
              (is_flat_[region] == 0 && std::ranges::find(*regions, region) != regions->end()));
    };
    surface_.visit_near(
        point, reach, may_bend, [&](std::uint32_t f, const Vec3& here, double distance) {
          const auto& [a, b, c] = surface_.corners(f);
          of_regions.add(surface_.region(f),
                         {features_.normals[f], here - point, distance, extent_of(a, b, c)});
        });
    const auto is_wanted = [&](std::uint32_t e) {
      return regions == nullptr || curves_[e] == curve;
    };
    curve_edges_.visit_near(
        point, reach, is_wanted, [&](std::uint32_t e, const Vec3& here, double distance) {
          const Vec3 way = points_[edges_[e][1]] - points_[edges_[e][0]];
          const double extent = way.norm();
          if (extent > 0) {
            of_curves.add(curves_[e], {way / extent, here - point, distance, extent});
          }
        });
    return [of_regions = std::move(of_regions), of_curves = std::move(of_curves)](double within) {
      return std::max(of_regions.largest(within), of_curves.largest(within));
    };
  };
  // Little is looked at where little is allowed. The loops end at the most, or at the distance.
  double length = std::min(most, kFirst * distance_);
  std::function<double(double)> bend = bend_within(length);
  while (length < most && bend(length) <= distance_) {
    length = std::min(2 * length, most);
    bend = bend_within(length);
  }
  while (length > distance_ && bend(length) > distance_) {
    length *= kShrink;
  }
  return length;
}

bool EdgeLengths::share_a_region(std::uint32_t curve, std::uint32_t other) const {
  const std::array<std::uint32_t, 2>&own = features_.curves[curve].regions,
                                  &regions = features_.curves[other].regions;
  return std::ranges::any_of(
      own, [&](std::uint32_t r) { return std::ranges::find(regions, r) != regions.end(); });
}

// Most are near: one that may be far is not looked for among all at once.
template <class Counts>
double EdgeLengths::nearest_edge(const Vec3& point, double reach, const Counts& counts) const {
  constexpr double kFirst = 0x1p-12, kStep = 4;
  for (double within = kFirst * reach;; within = std::min(kStep * within, reach)) {
    double nearest = reach;
    curve_edges_.visit_near(point, within, [&](std::uint32_t e, const Vec3&, double distance) {
      if (distance < nearest && counts(e, distance)) {
        nearest = distance;
      }
    });
    if (nearest < reach || !(within < reach)) {
      return nearest;
    }
  }
}

double EdgeLengths::gap_beside(const Vec3& point, std::uint32_t curve,
                               const std::vector<std::uint32_t>& without, double reach) const {
  return nearest_edge(point, reach, [&](std::uint32_t e, double) {
    return share_a_region(curve, curves_[e]) && !std::ranges::binary_search(without, curves_[e]);
  });
}

double EdgeLengths::gap(const Vec3& point, std::uint32_t curve, double along, double reach) const {
  // Of a circle, the way across is not less than 0.63 of that along it.
  constexpr double kBack = 0.4;
  return nearest_edge(point, reach, [&](std::uint32_t e, double distance) {
    const std::uint32_t other = curves_[e];
    if (other != curve) {
      return share_a_region(curve, other);
    }
    const double extent = (points_[edges_[e][1]] - points_[edges_[e][0]]).norm();
    const double ahead = starts_[e] - along, back = -ahead - extent;
    const double way = std::max({ahead, back, 0.0});
    return distance < kBack * std::min(way, curve_lengths_[curve] - way - extent);
  });
}

double EdgeLengths::gap_to_others(const Vec3& point, std::uint32_t curve, double reach,
                                  Between between) const {
  return nearest_edge(point, reach, [&](std::uint32_t e, double) {
    return curves_[e] != curve && (between == Between::all || share_a_region(curve, curves_[e]));
  });
}

void EdgeLengths::require_room(std::size_t most, Between between) const {
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
        const double gap = gap_to_others(place, c, largest_, between);
        if (++balls > most || !(at + gap > at)) {
          throw gap < largest_ ? too_near(place, gap) : too_many(most);
        }
        at += gap;
      }
      before += edge;
    }
  }
}

Error too_near(const Vec3& place, double gap) {
  return Error(Errc::limit_exceeded,
               "sharp edges or borders come " +
                   (gap > 0 ? "within " + decimal(gap, kMessageDigits) + " of each other"
                            : "nearer to each other than doubles can tell") +
                   " near " + decimal(place) +
                   ", and a mesh that keeps them gets too many points; join the patches there");
}

Error too_short(const Vec3& place, double length) {
  return Error(Errc::limit_exceeded,
               "edges along the curve near " + decimal(place) + " are to be no longer than " +
                   decimal(length, kMessageDigits) +
                   ", and a mesh gets too many points; allow longer ones or a larger distance");
}

Error too_many(std::size_t most) {
  return Error(Errc::limit_exceeded, "a mesh with these lengths and distances gets more than " +
                                         std::to_string(most) +
                                         " points; allow longer edges or a larger distance");
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
