#include "surfaces/pieces/cyclide_piece_operations.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "dupin/blends/cyclide_form.h"
#include "dupin/blends/cyclide_tube.h"
#include "surfaces/cyclide_discs.h"
#include "surfaces/nurbs_rows.h"
#include "tessellation/cyclide_rows.h"
#include "tessellation/tessellation_tolerance.h"

namespace dupin {
namespace surfaces {
namespace {

using tessellation::Row;

std::vector<PeArc> arcs_of(std::span<const CyclidePiece> run) {
  std::vector<PeArc> result;
  for (const CyclidePiece& piece : run) {
    result.push_back(arc_of(piece));
  }
  return result;
}

double largest_radius(const std::vector<PeArc>& arcs) {
  double largest = 0;
  for (const PeArc& arc : arcs) {
    largest = std::max(largest, tessellation::largest_circle(arc));
  }
  return largest;
}

double point_error(const std::vector<PeArc>& arcs, double grid) {
  double largest = 0;
  for (const PeArc& arc : arcs) {
    largest = std::max(largest, tessellation::point_error(arc, grid));
  }
  return largest;
}

// Knots are fractions of the pieces' tangential lengths.
std::vector<tessellation::BandStepper> marches_of(const std::vector<PeArc>& arcs,
                                                  std::uint32_t segments) {
  std::vector<tessellation::BandStepper> marches;
  marches.reserve(arcs.size());
  for (const PeArc& arc : arcs) {
    marches.push_back(tessellation::march_of(arc, 2 * std::numbers::pi / segments));
  }
  return marches;
}

// The rows between the end rings. `first` is the direction of the start polygon's first corner,
// afterwards that in which the frame arrives at the end. Within a piece the frame turns about the
// symmetry plane's normal only, which is all that the tangent forces it to; at a joint the angle is
// counted from the next plane's normal.
std::vector<Row> inner_rows(const std::vector<PeArc>& arcs,
                            const std::vector<tessellation::Bands>& bands, Vec3& first) {
  std::vector<Row> rows;
  for (std::size_t p = 0; p < arcs.size(); ++p) {
    const Vec3 plane_normal = frame(arcs[p]).second;
    const Row start = tessellation::row_at(arcs[p], 0, plane_normal);
    const double angle = std::atan2(first.dot(start.second), first.dot(start.first));
    for (std::size_t j = 1; j < bands[p].knots.size(); ++j) {
      rows.push_back(tessellation::row_at(arcs[p], bands[p].knots[j], plane_normal));
      rows.back().angle = angle;
    }
    first = rows.back().direction(angle);
  }
  rows.pop_back();
  return rows;
}

}  // namespace

std::uint32_t segments_for(std::span<const CyclidePiece> run, double tolerance, double grid) {
  const auto arcs = arcs_of(run);
  const double allowed = tessellation::allowed_error(tolerance, point_error(arcs, grid));
  return tessellation::segment_count(2 * std::numbers::pi *
                                     std::sqrt(largest_radius(arcs) / (2 * allowed)));
}

double expected_bands(const CyclidePiece& piece, const RingSampling& sampling, double tolerance) {
  const std::vector<PeArc> arcs{arc_of(piece)};
  return tessellation::expected_bands(
      marches_of(arcs, sampling.segments),
      tessellation::allowed_error(tolerance, point_error(arcs, sampling.grid)),
      largest_radius(arcs), sampling.segments);
}

Tessellation tessellate(std::span<const CyclidePiece> run, const RingSampling& sampling,
                        const TessellationOptions& options) {
  const auto arcs = arcs_of(run);
  const double displacement = point_error(arcs, sampling.grid);
  const auto along =
      tessellation::even_bands(marches_of(arcs, sampling.segments),
                               tessellation::allowed_error(options.tolerance, displacement),
                               largest_radius(arcs), sampling.segments);
  Vec3 first = tessellation::first_direction(flipped(run.front().start), sampling);
  const std::vector<Row> inner = inner_rows(arcs, along, first);
  Tessellation result{
      tessellation::swept_mesh(run.front().start, inner,
                               tessellation::arrival(run.back().end, sampling, first), sampling),
      std::uint32_t(inner.size() + 1),
      0,
      {0}};
  for (std::size_t p = 0; p < along.size(); ++p) {
    result.error_bound = std::max(result.error_bound, along[p].error_bound + displacement);
    for (std::size_t j = 1; j < along[p].knots.size(); ++j) {
      result.knots.push_back(double(p) + cyclide::parameter_at(arcs[p], along[p].knots[j]));
    }
  }
  return result;
}

PieceExtent extent(const CyclidePiece& piece, double wall) {
  const auto reach = [](const PeVector& sphere) {
    return sphere.m.cwiseAbs().maxCoeff() + sphere.r;
  };
  return {least_radius(arc_of(piece)) - wall, std::max(reach(piece.first), reach(piece.last))};
}

MovingRing leaving(const CyclidePiece& piece, End end) {
  return leaving_canal(end_ring(piece, end));
}

PieceDiscs discs(const CyclidePiece& piece) {
  return discs_of(
      [all = CyclideDiscs(piece)](const numbers::Interval& t, bool) { return all.over(t); });
}

// PeArc proved regularity when it was made, exactly.
MarginBounds margin_bounds(const CyclidePiece& piece) {
  const Enclosure bounds = margin(arc_of(piece));
  return {bounds.lower, bounds.upper, true};
}

namespace {

// Of both skins.
MarginOver margin_over(const CyclidePiece& piece, double wall) {
  return [all = CyclideDiscs(piece), wall, outer = discs(piece).pace](const ParameterInterval& t) {
    const double margin = margin_of(outer(t));
    if (wall == 0) {
      return margin;
    }
    const auto inner = all.over({t.from, t.to}, wall);
    return std::min(margin, inner ? margin_of(pace(*inner, 0)) : -1);
  };
}

}  // namespace

double nearly_largest_margin(const CyclidePiece& piece, double wall) {
  return nearly_largest_margin(margin_over(piece, wall));
}

ProvedStretches prove_margin(const CyclidePiece& piece, double wall, double margin) {
  return prove_margin(margin_over(piece, wall), margin);
}

std::optional<double> tangency(const CyclidePiece& piece, End end) {
  return tangency_bound(piece, end);
}

// With the PE-tangent (A; tau) at the end, (2 e / D) d - tangent.
TangencyClaim tangency_claim(const CyclidePiece& piece, End end) {
  const EndRing ring{end_ring(piece, end), end};
  numbers::IntervalVec along = numbers::interval_vec(piece.tangent.m);
  numbers::Interval rise = piece.tangent.r;
  if (end == End::end) {
    const numbers::IntervalVec d =
        numbers::interval_vec(piece.last.m) - numbers::interval_vec(piece.first.m);
    const numbers::Interval dr = numbers::Interval(piece.last.r) - piece.first.r;
    const numbers::Interval factor = numbers::Interval(2) * (numbers::dot(d, along) - dr * rise) /
                                     (numbers::dot(d, d) - square(dr));
    along = factor * d - along;
    rise = factor * dr - rise;
  }
  const numbers::Interval advance = numbers::sqrt(numbers::dot(along, along) - square(rise)),
                          slope = ring.slope();
  const numbers::Interval off = (rise - advance * slope).magnitude();
  const DiscHull disc = discs(piece).hull({ring.parameter(), ring.parameter()});
  return {largest_angle(off, advance + rise * slope),
          largest_angle(numbers::norm(numbers::cross(along, ring.travel())),
                        numbers::dot(along, ring.travel())),
          offset(ring, disc.centers.front(), disc.radius),
          {}};
}

NurbsForm nurbs(const CyclidePiece& piece, double) {
  NurbsForm form;
  for (const BiquadraticPatch& patch : patches(arc_of(piece))) {
    NurbsSurface surface{2, 2, surfaces::bezier_knots(2, 1), surfaces::bezier_knots(2, 1), {}};
    for (std::size_t i = 0; i < 3; ++i) {
      auto& row = surface.net.emplace_back();
      for (std::size_t j = 0; j < 3; ++j) {
        const Vec3& p = patch.points.at(i).at(j);
        row.push_back({p.x(), p.y(), p.z(), patch.weights.at(i).at(j)});
      }
    }
    form.surfaces.push_back(std::move(surface));
  }
  return form;
}

std::uint32_t segments_for(const CyclidePiece& piece, double tolerance, double grid) {
  return segments_for(std::span(&piece, 1), tolerance, grid);
}

Tessellation tessellate(const CyclidePiece& piece, const RingSampling& sampling,
                        const TessellationOptions& options) {
  return tessellate(std::span(&piece, 1), sampling, options);
}

}  // namespace surfaces
}  // namespace dupin
