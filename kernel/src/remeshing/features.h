#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "dupin/kernel/mesh.h"
#include "support/none.h"

/// Meshes for solvers: triangles of good shape in place of those of an exact union. features.h says
/// what stays, reference_surface.h how far a mesh is from the one given, size_field.h how long
/// edges should be, working_mesh.h holds the mesh as it is edited, batch.h makes edits side by side
/// and undoes those that exact predicates object to, steps.h says which edits there are, and
/// remesh.cpp strings them together.
namespace dupin::remeshing {

/// A polyline of sharp edges between two corners, which may be the same point.
struct Curve {
  std::vector<Vec3> points;
  std::vector<double> lengths;                      ///< along it, of each point
  std::array<std::uint32_t, 2> ends{};              ///< corners of the mesh
  std::vector<std::array<std::uint32_t, 2>> sides;  ///< per edge, the regions beside it

  [[nodiscard]] double length() const { return lengths.back(); }
  /// The edge of the polyline that the place at a length lies on.
  [[nodiscard]] std::size_t edge_at(double length) const;
  [[nodiscard]] Vec3 at(double length) const;
  /// A bound of the distance between the curve from one length to another and the segment between
  /// two points, either way: that of a map of one to the other.
  [[nodiscard]] double deviation(double from, double to, const Vec3& a, const Vec3& b) const;
};

/// A part of a curve that an edge stands for, in the direction of the edge.
struct Span {
  std::uint32_t curve = support::kNone;
  double from = 0, to = 0;  ///< lengths along it

  [[nodiscard]] bool is_sharp() const { return curve != support::kNone; }
  [[nodiscard]] Span reversed() const { return {curve, to, from}; }
};

/// How a point may move.
enum class Freedom : std::uint8_t {
  region,  ///< over a smooth region
  curve,   ///< along a curve
  none,
};

/// What remeshing keeps of a mesh.
struct Features {
  std::vector<Curve> curves;
  std::vector<std::array<Span, 3>> spans;  ///< per triangle, of the edge from each corner on
  std::vector<std::uint32_t> regions;      ///< per triangle: those that hang together smoothly
  std::vector<Freedom> freedoms;           ///< per point
};

struct FeatureOptions {
  double angle = 0;   ///< beyond which an edge is sharp
  double length = 0;  ///< over which it is seen whether a curve turns
};

/// The sharp edges of a closed mesh, and those between labels. `fixed`: points that must stay.
[[nodiscard]] Features find_features(const TriMesh& mesh, std::span<const std::uint8_t> fixed,
                                     const FeatureOptions& options);

}  // namespace dupin::remeshing
