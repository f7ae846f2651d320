#pragma once

#include <cstdint>
#include <vector>

#include "dupin/kernel/error.h"
#include "dupin/kernel/mesh.h"
#include "dupin/kernel/ring.h"
#include "tessellation/band_stepper.h"

namespace dupin::tessellation {

// This folder: triangles of one surface, with a proof of how far they are from it. The bound is
// that of bilinear interpolation, (dt^2 Mtt + 2 dt du Mtu + du^2 Muu)/8 with certified bounds of
// second derivatives (docs/geometry.md, Tessellation), so rows are placed without ever measuring a
// distance. The polygons of stored rings are taken over bitwise: neighbours share them.
//
// A tube's mesh: polygons of equally many points, one after the other, from the polygon of the ring
// stored at its start to that at its end, and a band of triangles between neighbours. The columns
// follow a frame that turns no more than the tube does; what is missing between the frame's arrival
// and the end's polygon, at most half a segment, is spread evenly over the bands (the twist).

/// The direction of the polygon's first point, exactly across the ring's normal.
[[nodiscard]] Vec3 first_direction(const Ring& ring, const RingSampling& sampling);

/// `v` under the smallest rotation that takes the unit vector `from` to `to`, which must turn by
/// less than half a turn.
[[nodiscard]] Vec3 carried(const Vec3& from, const Vec3& to, const Vec3& v);

/// How far the arcs of a circle are from their chords.
[[nodiscard]] double sagitta(double radius, std::uint32_t segments);

/// A row of mesh points: center + scale (cos u first + sin u second), `angle` being the parameter u
/// of its first corner but for the twist. `first` and `second` are across each other.
struct Row {
  Vec3 center, first, second;
  double scale = 1, angle = 0;

  [[nodiscard]] Vec3 direction(double u) const;
};

/// The end polygon, counted from the point that the carried frame arrives at: the frame differs
/// from the ring's own axis by whole segments and a rest of at most half a segment.
struct Arrival {
  std::vector<Vec3> points;
  double twist = 0;  ///< radians, right-handed about the spine
};

/// Of a frame that is carried along: `carried_first` is where its first axis arrives.
[[nodiscard]] Arrival arrival(const Ring& end, const RingSampling& sampling,
                              const Vec3& carried_first);

/// Where rows lie along a piece, and how far the mesh between them is from it.
struct Bands {
  std::vector<double> knots;
  double error_bound = 0;
};

/// About how many bands even_bands() makes.
[[nodiscard]] double expected_bands(const std::vector<BandStepper>& marches, double allowed,
                                    double largest_radius, std::uint32_t segments);

[[nodiscard]] double expected_bands(const BoundsOfCells& bounds, double allowed,
                                    double largest_radius, std::uint32_t segments);

/// As few bands as keep to `allowed` along pieces that share a twist of at most half a segment.
[[nodiscard]] std::vector<Bands> even_bands(const std::vector<BandStepper>& marches, double allowed,
                                            double largest_radius, std::uint32_t segments);
/// Along one piece, over as many cells as it needs.
[[nodiscard]] Bands even_bands(const BoundsOfCells& bounds, double allowed, double largest_radius,
                               std::uint32_t segments);

/// The mesh from the polygon of `start` through the rows to the last polygon.
[[nodiscard]] TriMesh swept_mesh(const Ring& start, const std::vector<Row>& inner,
                                 const Arrival& last, const RingSampling& sampling);

/// The mesh between two rings through rows with frames of their own. The first and last row say
/// where on the surface the rings' polygons begin; their points are the polygons'.
[[nodiscard]] TriMesh swept_mesh(const Ring& start, const Ring& end, std::vector<Row> rows,
                                 const RingSampling& sampling);

/// A mesh with a row of points, and room for so many bands from there. Throws
/// Error{limit_exceeded} as refuse_too_fine().
[[nodiscard]] TriMesh first_row(const std::vector<Vec3>& points, std::size_t bands);

/// The quadrilaterals between the last two rows of points, halved along the shorter diagonals.
void append_band(TriMesh& mesh, std::uint32_t segments);

}  // namespace dupin::tessellation
