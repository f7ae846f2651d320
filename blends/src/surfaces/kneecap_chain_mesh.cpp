#include "surfaces/kneecap_chain_mesh.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <span>
#include <vector>

#include "cyclide/arc_bounds.h"
#include "tessellation/convex_fill.h"
#include "tessellation/cyclide_rows.h"
#include "tessellation/kneecap_mesh.h"
#include "tessellation/tessellation_tolerance.h"

namespace dupin::surfaces {
namespace {

using std::numbers::pi;
using tessellation::allowed_error;
using tessellation::append_band;
using tessellation::append_kneecap;
using tessellation::band_budget;
using tessellation::BandStepper;
using tessellation::even_knots;
using tessellation::fill;
using tessellation::first_direction;
using tessellation::joint;
using tessellation::joint_polygon;
using tessellation::JointCircles;
using tessellation::JointKind;
using tessellation::JointPolygon;
using tessellation::kSameCorners;
using tessellation::largest_circle;
using tessellation::march_of;
using tessellation::refuse_too_fine;
using tessellation::Row;
using tessellation::row_at;
using tessellation::segment_count;
using Indices = std::vector<std::uint32_t>;

// The share of the tolerance that two circles may be apart and still count as one.
constexpr double kNegligible = 1.0 / 16;

double point_error(const std::vector<PeArc>& arcs, double grid) {
  double largest = 0;
  for (const PeArc& arc : arcs) {
    largest = std::max(largest, tessellation::point_error(arc, grid));
  }
  return largest;
}

// Polygons around two circles of a joint may need a point more than a regular one.
std::uint32_t segments_of(const std::vector<PeArc>& arcs, double allowed) {
  double largest = 0;
  for (const PeArc& arc : arcs) {
    largest = std::max({largest, largest_circle(arc), arc.start().r, arc.end().r});
  }
  return 1 + segment_count(2 * pi * std::sqrt(largest / (2 * allowed)));
}

JointPolygon port_polygon(const Ring& ring, const RingSampling& sampling) {
  JointPolygon result{sample(ring, sampling), first_direction(ring, sampling), {}, 0};
  for (std::uint32_t i = 0; i < sampling.segments; ++i) {
    result.angles.push_back(2 * pi * i / sampling.segments);
  }
  return result;
}

// The angles of a polygon's points in the frame of a row.
std::vector<double> angles_in(const Row& row, const JointPolygon& polygon) {
  const double base = std::atan2(polygon.first.dot(row.second), polygon.first.dot(row.first));
  std::vector<double> result = polygon.angles;
  for (double& angle : result) {
    angle += base;
  }
  return result;
}

// `angles` counted from index `shift`, ascending, and as near to `target` as whole turns permit.
std::vector<double> counted_from(const std::vector<double>& angles, std::uint32_t shift,
                                 double target) {
  const double turns = std::round((target - angles[shift]) / (2 * pi));
  std::vector<double> result(angles.size());
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const std::size_t k = (i + shift) % angles.size();
    result[i] = angles[k] + 2 * pi * (turns + (k < shift ? 1 : 0));
  }
  return result;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    largest = std::max(largest, std::abs(a[i] - b[i]));
  }
  return largest;
}

double largest_step(const std::vector<double>& angles) {
  double largest = angles.front() + 2 * pi - angles.back();
  for (std::size_t i = 1; i < angles.size(); ++i) {
    largest = std::max(largest, angles[i] - angles[i - 1]);
  }
  return largest;
}

// How the columns of a piece run from one polygon to the other: a point of the start at angle
// from[i] to one of the end at to[i], which is number i + shift of that polygon.
struct Columns {
  std::vector<double> from, to;
  std::uint32_t shift = 0;

  [[nodiscard]] double twist() const { return largest_difference(from, to); }
  [[nodiscard]] double step() const { return std::max(largest_step(from), largest_step(to)); }
};

// The shift of least twist among those next to the one that twists the first column least.
Columns columns(const std::vector<double>& from, const std::vector<double>& end) {
  const auto n = std::uint32_t(from.size());
  assert(n > 0 && n == end.size());
  std::uint32_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t i = 0; i < n; ++i) {
    const double off = std::abs(std::remainder(end[i] - from[0], 2 * pi));
    if (off < least) {
      least = off;
      nearest = i;
    }
  }
  Columns best;
  for (std::uint32_t d = 0; d < 5; ++d) {
    const std::uint32_t shift = (nearest + n + d - 2) % n;
    Columns candidate{from, counted_from(end, shift, from[0]), shift};
    if (best.from.empty() || candidate.twist() < best.twist()) {
      best = std::move(candidate);
    }
  }
  return best;
}

class Mesher {
 public:
  Mesher(const Ring& start, const Ring& end, const std::vector<PeArc>& arcs,
         const RingSampling& sampling, double allowed)
      : start_(start),
        end_(end),
        arcs_(arcs),
        sampling_(sampling),
        allowed_((1 - kNegligible) * allowed) {
    for (std::size_t i = 1; i < arcs.size(); ++i) {
      joints_.push_back(joint(arcs[i - 1], arcs[i], kNegligible * allowed, sampling.grid));
    }
  }

  KneecapChainMesh run() {
    const std::size_t count = arcs_.size();
    double apart = 0;
    mesh_.knots.push_back(0);
    for (std::size_t i = 0; i < count; ++i) {
      const bool is_first = i == 0, is_last = i + 1 == count;
      const JointPolygon start = is_first ? port_polygon(flipped(start_), sampling_)
                                          : polygon(joints_[i - 1], joints_[i - 1].after);
      const JointPolygon end =
          is_last ? port_polygon(end_, sampling_) : polygon(joints_[i], joints_[i].before);
      const auto [first, last] = tube(i, start, end);
      if (!is_first) {
        append_backward(disc_of(start), first);
        apart = std::max(apart, joints_[i - 1].apart);
      }
      if (!is_last) {
        append(disc_of(end), last);
        append_sector(joints_[i], end);
      }
    }
    result_.error_bound += apart;
    mesh_.apart = std::max(apart, kSameCorners * sampling_.grid);
    return std::move(mesh_);
  }

 private:
  [[nodiscard]] JointPolygon polygon(const JointCircles& joint, const Ring& circle) const {
    return joint_polygon(joint, circle, sampling_.segments, sampling_.grid);
  }

  [[nodiscard]] std::vector<double> knots(const BandStepper& march, double radius,
                                          const Columns& columns) const {
    constexpr std::size_t kNoLimit = std::numeric_limits<std::size_t>::max();
    const double around = columns.step();
    const auto budget = band_budget(allowed_, radius, around);
    const auto untwisted = double(march.knots(budget.enough, 0, kNoLimit).size() - 1);
    // What the budget has room for.
    const double most = around / 2;
    auto result = even_knots(march, budget, std::min(most, columns.twist() / untwisted));
    const auto parts = int(std::ceil(columns.twist() / (most * double(result.size() - 1))));
    if (parts < 2) {
      return result;
    }
    std::vector<double> split{0};
    for (std::size_t i = 1; i < result.size(); ++i) {
      for (int k = 1; k <= parts; ++k) {
        split.push_back(std::lerp(result[i - 1], result[i], double(k) / parts));
      }
    }
    return split;
  }

  struct Ends {
    Indices start, end;  // of the polygons' points, in their orders
  };

  Ends tube(std::size_t piece, const JointPolygon& start, const JointPolygon& end) {
    const PeArc& arc = arcs_[piece];
    const Vec3 plane_normal = frame(arc).second;
    const Columns along = columns(angles_in(row_at(arc, 0, plane_normal), start),
                                  angles_in(row_at(arc, 1, plane_normal), end));
    const BandStepper march = march_of(arc, along.step());
    const std::vector<double> rows = knots(march, largest_circle(arc), along);
    const auto bands = rows.size() - 1;
    const double turn = along.twist() / double(bands);
    mesh_.turn = std::max(mesh_.turn, turn);
    for (std::size_t j = 1; j <= bands; ++j) {
      mesh_.knots.push_back(double(piece) + cyclide::parameter_at(arc, rows[j]));
    }
    result_.error_bound = std::max(result_.error_bound, march.error_bound(rows, turn));
    result_.bands += std::uint32_t(bands);
    refuse_too_fine(2. * sampling_.segments * result_.bands);

    TriMesh& mesh = result_.mesh;
    const std::uint32_t n = sampling_.segments;
    Ends ends{appended(start.points), Indices(n)};
    for (std::size_t j = 1; j < bands; ++j) {
      const Row row = row_at(arc, rows[j], plane_normal);
      for (std::uint32_t i = 0; i < n; ++i) {
        const double angle = std::lerp(along.from[i], along.to[i], double(j) / double(bands));
        mesh.points.push_back(
            snapped(row.center + row.scale * row.direction(angle), sampling_.grid));
      }
      append_band(mesh, n);
    }
    for (std::uint32_t i = 0; i < n; ++i) {
      mesh.points.push_back(end.points[(i + along.shift) % n]);
    }
    append_band(mesh, n);
    for (std::uint32_t i = 0; i < n; ++i) {
      ends.end[(i + along.shift) % n] = std::uint32_t(mesh.points.size()) - n + i;
    }
    return ends;
  }

  Indices appended(std::span<const Vec3> points) {
    TriMesh& mesh = result_.mesh;
    Indices result(points.size());
    std::iota(result.begin(), result.end(), std::uint32_t(mesh.points.size()));
    mesh.points.insert(mesh.points.end(), points.begin(), points.end());
    return result;
  }

  // The part of a polygon's disc at the kneecap: beyond the chord of a lune, else all of it.
  static std::vector<Triangle> exposed_disc(const JointPolygon& polygon) {
    std::vector<Triangle> result;
    fill(0, std::min(polygon.exposed, std::uint32_t(polygon.points.size()) - 1), result);
    return result;
  }

  // Seen from ahead: one polygon or, where the kneecap is a lune, one on either side of its chord.
  static std::vector<Triangle> disc_of(const JointPolygon& polygon) {
    const auto n = std::uint32_t(polygon.points.size());
    std::vector<Triangle> result = exposed_disc(polygon);
    if (polygon.exposed == 0) {
      fill(0, n - 1, result);
    } else if (polygon.exposed < n) {
      fill(polygon.exposed, n, result);
    }
    for (Triangle& triangle : result) {
      for (std::uint32_t& corner : triangle) {
        corner %= n;
      }
    }
    return result;
  }

  void append(const std::vector<Triangle>& triangles, const Indices& points) {
    for (const auto& [a, b, c] : triangles) {
      result_.mesh.triangles.push_back({points[a], points[b], points[c]});
    }
  }

  void append_backward(const std::vector<Triangle>& triangles, const Indices& points) {
    for (const auto& [a, b, c] : triangles) {
      result_.mesh.triangles.push_back({points[a], points[c], points[b]});
    }
  }

  // What the ball has between the discs, if anything: closed by the kneecap and the very triangles
  // of the pieces' discs.
  void append_sector(const JointCircles& joint, const JointPolygon& before) {
    if (joint.kind == JointKind::smooth || joint.kind == JointKind::hidden) {
      mesh_.depths.push_back(0);
      return;
    }
    const JointPolygon after = polygon(joint, joint.after);
    const std::span here_points(before.points), ahead_points(after.points);
    Indices here, ahead;
    if (joint.kind == JointKind::lune) {
      here = appended(here_points.first(before.exposed + 1));
      ahead = appended(ahead_points.subspan(1, after.exposed - 1));
      ahead.insert(ahead.begin(), here.front());
      ahead.push_back(here.back());
    } else {
      here = appended(here_points);
      ahead = appended(ahead_points);
    }
    const double error = append_kneecap(result_.mesh, joint, here, ahead,
                                        {sampling_.segments, allowed_, sampling_.grid});
    result_.error_bound = std::max(result_.error_bound, error);
    mesh_.depths.push_back(error);
    append_backward(exposed_disc(before), here);
    append(exposed_disc(after), ahead);
  }

  const Ring& start_;
  const Ring& end_;
  const std::vector<PeArc>& arcs_;
  const RingSampling& sampling_;
  double allowed_;
  std::vector<JointCircles> joints_;
  KneecapChainMesh mesh_;
  Tessellation& result_ = mesh_.tessellation;
};

}  // namespace

std::uint32_t kneecap_chain_segments(const std::vector<PeArc>& arcs, double tolerance,
                                     double grid) {
  const double allowed = allowed_error(tolerance, point_error(arcs, grid));
  return segments_of(arcs, (1 - kNegligible) * allowed);
}

double expected_kneecap_rows(const std::vector<PeArc>& arcs, const RingSampling& sampling,
                             double tolerance) {
  const double allowed = allowed_error(tolerance, point_error(arcs, sampling.grid));
  double sum = 0;
  for (std::size_t i = 1; i < arcs.size(); ++i) {
    sum += tessellation::expected_rows(
        joint(arcs[i - 1], arcs[i], kNegligible * allowed, sampling.grid), sampling.segments);
  }
  return sum;
}

KneecapChainMesh kneecap_chain_mesh(const Ring& start, const Ring& end,
                                    const std::vector<PeArc>& arcs, const RingSampling& sampling,
                                    const TessellationOptions& options) {
  const double displacement = point_error(arcs, sampling.grid);
  KneecapChainMesh result =
      Mesher(start, end, arcs, sampling, allowed_error(options.tolerance, displacement)).run();
  result.tessellation.error_bound += displacement;
  return result;
}

}  // namespace dupin::surfaces
