#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>

#include "dupin/blends/tessellate.h"
#include "tessellation/cyclide_rows.h"
#include "tessellation/tessellation_tolerance.h"

namespace dupin {
namespace {

using tessellation::BandStepper;
using tessellation::Row;

double largest_radius(const CyclideChain& chain) {
  double largest = 0;
  for (const PeArc& arc : chain.pieces) {
    largest = std::max(largest, tessellation::largest_circle(arc));
  }
  return largest;
}

struct PieceBands {
  std::vector<double> knots;  // fractions of the piece's tangential length
  double error_bound = 0;
};

std::size_t band_count(const std::vector<PieceBands>& pieces) {
  std::size_t count = 0;
  for (const PieceBands& piece : pieces) {
    count += piece.knots.size() - 1;
  }
  return count;
}

// First without a twist, to learn how many bands share it.
std::vector<PieceBands> bands(const CyclideChain& chain, double allowed, std::uint32_t segments) {
  constexpr std::size_t kNoLimit = std::numeric_limits<std::size_t>::max();
  const double around = 2 * std::numbers::pi / segments;
  const auto budget = tessellation::band_budget(allowed, largest_radius(chain), around);
  std::vector<tessellation::BandStepper> marches;
  std::vector<PieceBands> result;
  for (const PeArc& arc : chain.pieces) {
    marches.push_back(tessellation::march_of(arc, around));
    result.push_back({marches.back().knots(budget.enough, 0, kNoLimit), 0});
  }
  const double twist = around / 2 / double(band_count(result));
  for (std::size_t i = 0; i < marches.size(); ++i) {
    result[i].knots = tessellation::even_knots(marches[i], budget, twist);
    result[i].error_bound = marches[i].error_bound(result[i].knots, twist);
  }
  return result;
}

// The rows between the tube's end rings. `first` is the direction of the start polygon's first
// corner, afterwards that in which the frame arrives at the end. Within a piece the frame turns
// about the symmetry plane's normal only, which is all that the tangent forces it to; at a joint
// the angle is counted from the next plane's normal.
std::vector<Row> inner_rows(const CyclideChain& chain, const std::vector<PieceBands>& bands,
                            Vec3& first) {
  std::vector<Row> rows;
  for (std::size_t p = 0; p < chain.pieces.size(); ++p) {
    const PeArc& arc = chain.pieces[p];
    const Vec3 plane_normal = frame(arc).second;
    const Row start = tessellation::row_at(arc, 0, plane_normal);
    const double angle = std::atan2(first.dot(start.second), first.dot(start.first));
    for (std::size_t j = 1; j < bands[p].knots.size(); ++j) {
      rows.push_back(tessellation::row_at(arc, bands[p].knots[j], plane_normal));
      rows.back().angle = angle;
    }
    first = rows.back().direction(angle);
  }
  rows.pop_back();
  return rows;
}

double point_error(const CyclideTube& tube, double grid) {
  double largest = 0;
  for (const PeArc& arc : tube.chain.pieces) {
    largest = std::max(largest, tessellation::point_error(arc, grid));
  }
  return largest;
}

struct Skin {
  Tessellation tube;
  std::uint32_t shift = 0;  // the last row's first point is this one of sample(end)
};

Skin skin(const CyclideTube& tube, const RingSampling& sampling,
          const TessellationOptions& options) {
  const double displacement = point_error(tube, sampling.grid);
  const std::uint32_t n = sampling.segments;
  const auto along =
      bands(tube.chain, tessellation::allowed_error(options.tolerance, displacement), n);
  Vec3 first = tessellation::first_direction(flipped(tube.start), sampling);
  const std::vector<Row> rows = inner_rows(tube.chain, along, first);
  const tessellation::Arrival last = tessellation::arrival(tube.end, sampling, first);

  Skin result;
  result.shift = last.shift;
  result.tube.knots = {0};
  for (std::size_t p = 0; p < along.size(); ++p) {
    for (std::size_t j = 1; j < along[p].knots.size(); ++j) {
      result.tube.knots.push_back(double(p) +
                                  cyclide::parameter_at(tube.chain.pieces[p], along[p].knots[j]));
    }
  }
  result.tube.bands = std::uint32_t(rows.size() + 1);
  for (const PieceBands& piece : along) {
    result.tube.error_bound = std::max(result.tube.error_bound, piece.error_bound + displacement);
  }
  TriMesh& mesh = result.tube.mesh =
      tessellation::first_row(sample(flipped(tube.start), sampling), result.tube.bands);
  for (std::size_t j = 0; j < rows.size(); ++j) {
    const Row& row = rows[j];
    const double turned = row.angle + last.twist * double(j + 1) / double(rows.size() + 1);
    for (std::uint32_t i = 0; i < n; ++i) {
      const Vec3 direction = row.direction(turned + 2 * std::numbers::pi * i / n);
      mesh.points.push_back(
          snapped(row.circle.center + row.circle.radius * direction, sampling.grid));
    }
    tessellation::append_band(mesh, n);
  }
  mesh.points.insert(mesh.points.end(), last.points.begin(), last.points.end());
  tessellation::append_band(mesh, n);
  return result;
}

// The inner skin inside out and the conical rims between the two: straight rulings, so that their
// quadrilaterals are as near to the cone as the outer circle's chords to it.
Tessellation hollow(Skin outer, Skin inner, std::uint32_t segments) {
  const auto offset = std::uint32_t(outer.tube.mesh.points.size());
  const auto last = offset - segments;
  const auto inner_last = std::uint32_t(inner.tube.mesh.points.size()) - segments;
  TriMesh& mesh = outer.tube.mesh;
  mesh.points.insert(mesh.points.end(), inner.tube.mesh.points.begin(),
                     inner.tube.mesh.points.end());
  for (const auto& [a, b, c] : inner.tube.mesh.triangles) {
    mesh.triangles.push_back({offset + a, offset + c, offset + b});
  }
  mesh.labels.assign(mesh.triangles.size(), 0);
  const auto quadrilateral = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d,
                                 std::uint32_t label) {
    mesh.triangles.insert(mesh.triangles.end(), {{a, b, c}, {a, c, d}});
    mesh.labels.insert(mesh.labels.end(), 2, label);
  };
  for (std::uint32_t i = 0; i < segments; ++i) {
    const std::uint32_t k = (i + 1) % segments;
    quadrilateral(k, i, offset + i, offset + k, 1);
  }
  // Point i of the outer last row is point i + outer.shift of its ring's sample.
  const std::uint32_t turn = segments + outer.shift - inner.shift;
  for (std::uint32_t i = 0; i < segments; ++i) {
    const std::uint32_t k = (i + 1) % segments;
    quadrilateral(last + i, last + k, offset + inner_last + (k + turn) % segments,
                  offset + inner_last + (i + turn) % segments, 2);
  }
  outer.tube.error_bound = std::max(outer.tube.error_bound, inner.tube.error_bound);
  outer.tube.bands += inner.tube.bands;
  outer.tube.knots.clear();  // the skins have their own
  return std::move(outer.tube);
}

}  // namespace

std::uint32_t segments_for(const CyclideTube& tube, double tolerance, double grid) {
  const double allowed = tessellation::allowed_error(tolerance, point_error(tube, grid));
  return tessellation::segment_count(2 * std::numbers::pi *
                                     std::sqrt(largest_radius(tube.chain) / (2 * allowed)));
}

Tessellation tessellate(const CyclideTube& tube, const RingSampling& sampling,
                        const TessellationOptions& options) {
  Skin outer = skin(tube, sampling, options);
  if (tube.wall == 0) {
    return std::move(outer.tube);
  }
  return hollow(std::move(outer), skin(inner_tube(tube), sampling, options), sampling.segments);
}

}  // namespace dupin
