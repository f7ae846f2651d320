#include "tessellation/trimmed_face.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <iterator>
#include <map>
#include <numbers>
#include <numeric>

#include "dupin/kernel/error.h"
#include "numbers/point_order.h"
#include "tessellation/face_strip.h"
#include "tessellation/refined_region.h"
#include "tessellation/tessellation_tolerance.h"
#include "tessellation/touching_holes.h"
#include "tessellation/unrolled_face.h"

namespace dupin::tessellation {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kRoom = 1.2;  // y between curves and bands

// How many bands are between two rings: of 50 times as long as wide, but not many for a face that
// is as long as it may be.
double band_count(double height) {
  constexpr double kHighest = 50 / UnrolledFace::kCompression, kMost = 8;
  return std::clamp(std::ceil(height / kHighest), 1.0, kMost);
}

class Trimmer {
 public:
  Trimmer(const TrimmedFace& face, const RingSampling& sampling, Bridges bridges)
      : face_(face),
        sampling_(sampling),
        bridges_(bridges),
        chart_(face.start, face.end, sampling) {}

  Tessellation run() {
    if (face_.keeps_start) {
      append_row(sample(flipped(face_.start), sampling_));
    }
    for (const auto& curve : face_.curves) {
      append_curve(curve);
    }
    if (face_.keeps_end) {
      append_row(sample(face_.end, sampling_));
    }
    for (const Vec3& point : result_.mesh.points) {
      places_.push_back(chart_.place(point));
    }
    const std::size_t given = places_.size();
    triangulate();
    result_.error_bound = error();
    put_end_last(given);
    return std::move(result_);
  }

 private:
  using Corners = std::vector<std::uint32_t>;

  void append_row(const std::vector<Vec3>& points) {
    Corners corners(points.size());
    std::iota(corners.begin(), corners.end(), std::uint32_t(result_.mesh.points.size()));
    result_.mesh.points.insert(result_.mesh.points.end(), points.begin(), points.end());
    polygons_.push_back(std::move(corners));
  }

  void append_curve(const std::vector<Vec3>& curve) {
    Corners corners;
    for (const Vec3& point : curve) {
      const double height = chart_.height(point);
      if ((face_.keeps_start && !(height > 0)) || (face_.keeps_end && !(height < 1))) {
        throw Error(Errc::self_intersecting, "a curve leaves the face that it trims");
      }
      const auto [entry, is_new] =
          vertex_at_.try_emplace(point, std::uint32_t(result_.mesh.points.size()));
      if (is_new) {
        result_.mesh.points.push_back(point);
      }
      corners.push_back(entry->second);
    }
    polygons_.push_back(std::move(corners));
  }

  // Curves about the axis, from the start on, bound strips by twos; the others are holes in these.
  void triangulate() {
    std::vector<UnrolledCurve> around, holes;
    for (std::size_t i = 0; i < polygons_.size(); ++i) {
      UnrolledCurve curve = unrolled(std::move(polygons_[i]), places_, chart_.around());
      curve.is_ring =
          (face_.keeps_start && i == 0) || (face_.keeps_end && i + 1 == polygons_.size());
      (curve.turns == 0 ? holes : around).push_back(std::move(curve));
    }
    holes = linked_about(std::move(holes), places_, chart_.around(), bridges_);
    const auto about = std::stable_partition(
        holes.begin(), holes.end(), [](const UnrolledCurve& curve) { return curve.turns == 0; });
    std::move(about, holes.end(), std::back_inserter(around));
    holes.erase(about, holes.end());
    // Of two that do not cross the lower one has less below it; their least y may be the other way.
    std::ranges::stable_sort(
        around, {}, [&](const UnrolledCurve& curve) { return area_below(curve, chart_.around()); });
    if (around.size() % 2 != 0) {
      throw Error(Errc::self_intersecting, "the curves on a tube's face do not bound it");
    }
    std::vector<std::vector<const UnrolledCurve*>> in_strip(around.size() / 2);
    for (const UnrolledCurve& hole : holes) {
      std::size_t i = 0;
      while (i < in_strip.size() &&
             !FaceStrip(around[2 * i], around[2 * i + 1], chart_.around()).contains(hole)) {
        ++i;
      }
      if (i == in_strip.size()) {
        throw Error(Errc::self_intersecting, "a curve on a tube's face is not between its ends");
      }
      in_strip[i].push_back(&hole);
    }
    for (std::size_t i = 0; i < in_strip.size(); ++i) {
      append_strip(around[2 * i], around[2 * i + 1], in_strip[i]);
    }
  }

  // Heights at which there are curves, with some room.
  struct Zone {
    double low, high;
    std::vector<const UnrolledCurve*> holes = {};
  };

  static std::vector<Zone> zones(const UnrolledCurve& lower, const UnrolledCurve& upper,
                                 const std::vector<const UnrolledCurve*>& holes) {
    std::vector<Zone> all;
    if (!lower.is_ring) {
      all.push_back({lower.low, lower.high + kRoom});
    }
    if (!upper.is_ring) {
      all.push_back({upper.low - kRoom, upper.high});
    }
    for (const UnrolledCurve* hole : holes) {
      all.push_back({hole->low - kRoom, hole->high + kRoom, {hole}});
    }
    std::ranges::stable_sort(all, {}, &Zone::low);
    std::vector<Zone> result;
    for (Zone& zone : all) {
      if (result.empty() || zone.low > result.back().high + kRoom) {
        result.push_back(std::move(zone));
      } else {
        result.back().high = std::max(result.back().high, zone.high);
        result.back().holes.insert(result.back().holes.end(), zone.holes.begin(), zone.holes.end());
      }
    }
    return result;
  }

  // Zones are filled with triangles of all sizes that the curves ask for, and between them there
  // are bands.
  void append_strip(const UnrolledCurve& lower, const UnrolledCurve& upper,
                    const std::vector<const UnrolledCurve*>& holes) {
    const auto all = zones(lower, upper, holes);
    const UnrolledCurve* below = &lower;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Zone& zone = all[i];
      if (below->is_ring && zone.low > below->high + kRoom) {
        below = &append_bands(*below, append_ring(zone.low));
      }
      const bool reaches_upper =
          i + 1 == all.size() && (!upper.is_ring || zone.high + kRoom > upper.low);
      const UnrolledCurve& above = reaches_upper ? upper : append_ring(zone.high);
      FaceStrip strip(*below, above, chart_.around());
      std::ranges::for_each(zone.holes, [&](const UnrolledCurve* hole) { strip.add(*hole); });
      strip.append_triangles(result_.mesh.triangles,
                             [&](const Vec2& place) { return append_point(place); });
      below = &above;
    }
    if (below != &upper) {
      append_bands(*below, upper);
    }
  }

  const UnrolledCurve& append_bands(const UnrolledCurve& lower, const UnrolledCurve& upper) {
    const double height = upper.low - lower.low, bands = band_count(height);
    const UnrolledCurve* below = &lower;
    for (double i = 1; i <= bands; ++i) {
      const UnrolledCurve& above = i == bands ? upper : append_ring(lower.low + i / bands * height);
      append_band(*below, above, chart_.around(), result_.mesh.triangles);
      below = &above;
    }
    return upper;
  }

  const UnrolledCurve& append_ring(double y) {
    Corners corners;
    for (const Vec3& point : sample(chart_.ring(y), sampling_)) {
      corners.push_back(append_point(point));
    }
    rings_.push_back(unrolled(std::move(corners), places_, chart_.around()));
    rings_.back().is_ring = true;
    return rings_.back();
  }

  std::uint32_t append_point(const Vec2& place) {
    return append_point(snapped(chart_.point(place), sampling_.grid));
  }

  std::uint32_t append_point(const Vec3& point) {
    result_.mesh.points.push_back(point);
    places_.push_back(chart_.place(point));
    return std::uint32_t(places_.size() - 1);
  }

  // What was added goes before the end's points.
  void put_end_last(std::size_t given) {
    if (!face_.keeps_end) {
      return;
    }
    auto& points = result_.mesh.points;
    const std::size_t first = given - sampling_.segments, added = points.size() - given;
    std::rotate(points.begin() + std::ptrdiff_t(first), points.begin() + std::ptrdiff_t(given),
                points.end());
    for (Triangle& triangle : result_.mesh.triangles) {
      for (std::uint32_t& corner : triangle) {
        if (corner >= given) {
          corner -= sampling_.segments;
        } else if (corner >= first) {
          corner += std::uint32_t(added);
        }
      }
    }
  }

  // The widest angle that a triangle spans.
  [[nodiscard]] double error() const {
    double widest = 0;
    for (const Triangle& triangle : result_.mesh.triangles) {
      for (std::size_t i = 0; i < 3; ++i) {
        const double turn = places_[triangle.at(i)].x() - places_[triangle.at((i + 1) % 3)].x();
        widest = std::max(widest, std::abs(std::remainder(turn, chart_.around())));
      }
    }
    const double radius = std::max(face_.start.radius, face_.end.radius);
    const double half = std::sin(widest / chart_.around() * kTurn / 4);
    return 2 * radius * half * half +
           point_error(face_.start.center.norm() + face_.end.center.norm() + 2 * radius,
                       sampling_.grid);
  }

  const TrimmedFace& face_;
  const RingSampling& sampling_;
  Bridges bridges_;
  UnrolledFace chart_;
  std::map<Vec3, std::uint32_t, numbers::PointOrder> vertex_at_;
  std::vector<Corners> polygons_;
  std::vector<Vec2> places_;
  std::deque<UnrolledCurve> rings_;  // between the curves
  Tessellation result_;
};

struct Heights {
  double low, high;
};

// Of each curve, with room, and of curves together whose zones meet.
std::vector<Heights> zone_heights(const TrimmedFace& face, const UnrolledFace& chart) {
  std::vector<Heights> all;
  for (const auto& curve : face.curves) {
    Heights own{chart.place(curve.front()).y(), chart.place(curve.front()).y()};
    for (const Vec3& point : curve) {
      const double y = chart.place(point).y();
      own = {std::min(own.low, y), std::max(own.high, y)};
    }
    all.push_back({own.low - kRoom, own.high + kRoom});
  }
  std::ranges::sort(all, {}, &Heights::low);
  std::vector<Heights> result;
  for (const Heights& zone : all) {
    if (result.empty() || zone.low > result.back().high + kRoom) {
      result.push_back(zone);
    } else {
      result.back().high = std::max(result.back().high, zone.high);
    }
  }
  return result;
}

}  // namespace

double expected_triangles(const TrimmedFace& face, const RingSampling& sampling) {
  constexpr double kSpacing = Refinement{}.spacing;
  constexpr double kByArea = 4 / (std::numbers::sqrt3 * kSpacing * kSpacing);  // of the lattice
  const UnrolledFace chart(face.start, face.end, sampling);
  const auto height_of = [&](const Ring& ring) {
    return chart.place(ring.center + ring.radius * ring.normal.unitOrthogonal()).y();
  };
  double result = 0, below = height_of(face.start);
  for (const Heights& zone : zone_heights(face, chart)) {
    result +=
        chart.around() * (2 * band_count(zone.low - below) + kByArea * (zone.high - zone.low));
    below = zone.high;
  }
  return result + chart.around() * 2 * band_count(height_of(face.end) - below);
}

Tessellation trimmed_face(const TrimmedFace& face, const RingSampling& sampling) {
  // Where chains of holes are nested, a bridge from one to the other may leave what touches itself,
  // and there are ways past without.
  try {
    return Trimmer(face, sampling, Bridges::across_gaps).run();
  } catch (const Error& error) {
    if (error.code() != Errc::self_intersecting || face.curves.size() < 2) {
      throw;
    }
    return Trimmer(face, sampling, Bridges::none).run();
  }
}

}  // namespace dupin::tessellation
