#include "rounding/sliver_voids.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <CGAL/Interval_nt.h>
#include <Eigen/Geometry>

#include "exact/vector_algebra.h"
#include "mesh/ball_mesh.h"
#include "mesh/measure.h"
#include "mesh/self_contact.h"
#include "support/blocks.h"
#include "support/disjoint_sets.h"
#include "support/sequences.h"

namespace dupin::rounding {
namespace {

std::vector<Triangle> merged(const mesh::ExactMesh& mesh,
                             std::span<const std::uint32_t> representatives) {
  std::vector<Triangle> triangles = mesh.triangles;
  for (Triangle& corners : triangles) {
    for (std::uint32_t& corner : corners) {
      corner = representatives[corner];
    }
  }
  return triangles;
}

/// The mean normal of the triangles that face the same way as the largest, of length 1 but for
/// rounding; any direction if doubles cannot tell it.
Vec3 mean_normal(const mesh::ExactMesh& mesh, std::span<const std::uint32_t> faces) {
  std::vector<Vec3> normals;
  Vec3 largest = Vec3::Zero(), sum = Vec3::Zero();
  for (const std::uint32_t face : faces) {
    const Triangle& t = mesh.triangles[face];
    const Vec3& a = mesh.points[t[0]];
    normals.push_back((mesh.points[t[1]] - a).cross(mesh.points[t[2]] - a));
    largest = normals.back().squaredNorm() > largest.squaredNorm() ? normals.back() : largest;
  }
  for (const Vec3& normal : normals) {
    sum += normal.dot(largest) > 0 ? normal : Vec3::Zero();
  }
  const Vec3 normal = sum.stableNormalized();
  return normal.allFinite() && !normal.isZero(0) ? normal : Vec3::UnitZ();
}

/// The distance of the two planes across `normal` that enclose the points, rounded up; infinite if
/// it is above `widest`. Needs rounding upward.
double width_across(const Vec3& normal, std::span<const exact::BallPoint> points, double widest) {
  const exact::BallPoint& first = points.front();
  const exact::BallPoint direction = {normal[0], normal[1], normal[2]};
  double low = 0, high = 0;
  for (const exact::BallPoint& p : points.subspan(1)) {
    const exact::Ball height = exact::dot(exact::difference(p, first), direction);
    low = std::min(low, height.infimum());
    high = std::max(high, height.supremum());
    if (!std::isfinite(height.radius()) || !(high - low <= widest)) {
      return std::numeric_limits<double>::infinity();
    }
  }
  return (high - low) * (1 + 0x1p-48);  // for the rounding of the normal's length
}

/// Per shell. Nearest doubles do not change the order of coordinates.
std::vector<Eigen::AlignedBox3d> bounds_of(const mesh::Shells& shells,
                                           const mesh::ExactMesh& mesh) {
  std::vector<Eigen::AlignedBox3d> bounds(shells.count);
  for (std::uint32_t face = 0; face < mesh.triangles.size(); ++face) {
    for (const std::uint32_t point : mesh.triangles[face]) {
      bounds[shells.of_face[face]].extend(mesh.points[point]);
    }
  }
  return bounds;
}

}  // namespace

SliverVoids::SliverVoids(const mesh::ExactMesh& mesh,
                         std::span<const std::uint32_t> representatives, double widest)
    : mesh_(mesh), merged_(merged(mesh, representatives)), edges_(merged_, mesh.points.size()) {
  const auto crowded = support::indices_where(
      edges_.size(), [&](std::uint32_t i) { return edges_[i].half_edges.size() > 2; });
  std::vector<std::vector<std::uint32_t>> around(crowded.size());
  support::for_each_in_parallel(crowded.size(), [&](std::size_t i) {
    around[i] = mesh::sorted_around(mesh::MeshView(mesh_), edges_, edges_[crowded[i]]);
  });
  for (std::size_t i = 0; i < crowded.size(); ++i) {
    around_.emplace(crowded[i], std::move(around[i]));
  }
  cells_ = find_cells();
  voids_ = find_voids(widest);
}

/// Going around an edge from its lower to its upper end, a triangle that runs along it has material
/// before it and free space behind it.
void SliverVoids::pair_around(const std::vector<std::uint32_t>& around,
                              const std::vector<std::uint8_t>& gone, Side side,
                              std::vector<std::uint32_t>& partners) const {
  std::vector<std::uint32_t> left;
  for (const std::uint32_t half_edge : around) {
    if (gone[half_edge / 3] == 0) {
      left.push_back(half_edge);
    }
  }
  const std::size_t n = left.size();
  for (std::size_t i = 0; i < n; ++i) {
    const bool along = edges_.origin(left[i]) < edges_.target(left[i]);
    const bool forward = along == (side == Side::free);
    partners[left[i]] = left[forward ? (i + 1) % n : (i + n - 1) % n];
  }
}

/// Per half-edge the other one at its edge that bounds the same part of the solid or of what it
/// leaves free.
std::vector<std::uint32_t> SliverVoids::partners(const std::vector<std::uint8_t>& gone,
                                                 Side side) const {
  std::vector<std::uint32_t> partners(3 * merged_.size());
  support::for_each_block(edges_.size(), [&](const support::Block& block) {
    for (std::size_t i = block.begin; i < block.end; ++i) {
      const auto half_edges = edges_[i].half_edges;
      if (half_edges.size() == 2) {
        partners[half_edges[0]] = half_edges[1];
        partners[half_edges[1]] = half_edges[0];
      }
    }
  });
  for (const auto& [edge, around] : around_) {
    pair_around(around, gone, side, partners);
  }
  return partners;
}

mesh::Shells SliverVoids::find_cells() const {
  const auto across = partners(std::vector<std::uint8_t>(merged_.size(), 0), Side::free);
  support::DisjointSets sets(merged_.size());
  support::for_each_block(merged_.size(), [&](const support::Block& block) {
    for (auto face = static_cast<std::uint32_t>(block.begin); face < block.end; ++face) {
      for (std::uint32_t h = 3 * face; h < 3 * face + 3; ++h) {
        sets.unite(face, across[h] / 3);
      }
    }
  });
  return mesh::grouped(sets.representatives());
}

/// Whether the cell's surface encloses free space. Others enclose material.
bool SliverVoids::is_void(std::uint32_t cell) const {
  const auto triangles =
      support::selected(std::span<const Triangle>(merged_), cells_.faces_of(cell));
  mesh::MeshView view(mesh_);
  view.triangles = triangles;
  return mesh::volume_sign(view) < 0;
}

/// Of a cell that encloses free space and is nowhere wider; else infinite.
double SliverVoids::width_of_void(std::uint32_t cell, double widest) const {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  constexpr std::size_t kFewFaces = 64;
  const auto faces = cells_.faces_of(cell);
  const Vec3 normal = mean_normal(mesh_, faces);
  // A few triangles of a wide cell show that it is wide.
  if (faces.size() > kFewFaces &&
      !(measure(normal, faces.first(kFewFaces), widest).width <= widest)) {
    return kNone;
  }
  const Measured measured = measure(normal, faces, widest);
  if (!(measured.width <= widest)) {
    return kNone;
  }
  const bool is_free = measured.volume_sign < 0 || (measured.volume_sign == 0 && is_void(cell));
  return is_free ? measured.width : kNone;
}

/// Rounds upward no longer than it takes: other tasks must not find that so.
SliverVoids::Measured SliverVoids::measure(const Vec3& normal, std::span<const std::uint32_t> faces,
                                           double widest) const {
  const auto triangles = support::selected(std::span<const Triangle>(merged_), faces);
  const CGAL::Protect_FPU_rounding<true> upward;
  const mesh::BallMesh mesh(mesh::MeshView(mesh_), triangles);
  const double width = width_across(normal, mesh.points, widest);
  return {width, width <= widest ? mesh::volume_sign(mesh) : 0};
}

/// Those in which material might float are left out.
std::vector<SliverVoids::Void> SliverVoids::find_voids(double widest) const {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  std::vector<double> widths(cells_.count, kNone);
  support::for_each_in_parallel(cells_.count, [&](std::size_t i) {
    widths[i] = width_of_void(static_cast<std::uint32_t>(i), widest);
  });
  std::vector<Void> voids;
  for (std::uint32_t cell = 0; cell < cells_.count; ++cell) {
    if (widths[cell] < kNone) {
      voids.push_back({cell, widths[cell]});
    }
  }
  const std::vector<Eigen::AlignedBox3d> bounds = bounds_of(cells_, mesh_);
  std::vector<std::uint8_t> is_sliver(cells_.count, 0);
  for (const Void& sliver : voids) {
    is_sliver[sliver.cell] = 1;
  }
  std::vector<std::uint32_t> others;
  for (std::uint32_t cell = 0; cell < cells_.count; ++cell) {
    if (is_sliver[cell] == 0) {
      others.push_back(cell);
    }
  }
  std::erase_if(voids, [&](const Void& sliver) {
    return std::ranges::any_of(others, [&](std::uint32_t cell) {
      return bounds[sliver.cell].contains(bounds[cell]) && !is_void(cell);
    });
  });
  return voids;
}

mesh::ExactMesh SliverVoids::without(const std::vector<std::uint8_t>& gone) const {
  mesh::ExactMesh rest;
  rest.points = mesh_.points;
  rest.implicit = mesh_.implicit;
  rest.names = mesh_.names;
  rest.planes = mesh_.planes;
  std::vector<std::uint32_t> number(merged_.size(), 0), old;
  for (std::uint32_t f = 0; f < merged_.size(); ++f) {
    if (gone[f] != 0) {
      continue;
    }
    number[f] = static_cast<std::uint32_t>(old.size());
    old.push_back(f);
    rest.triangles.push_back(merged_[f]);
    rest.sources.push_back(mesh_.sources[f]);
    if (!mesh_.labels.empty()) {
      rest.labels.push_back(mesh_.labels[f]);
    }
    if (!mesh_.plane_of.empty()) {
      rest.plane_of.push_back(mesh_.plane_of[f]);
    }
  }
  const auto across = partners(gone, Side::material);
  const auto corner = [&](std::uint32_t half_edge) {  // at its origin, in the rest
    return 3 * number[half_edge / 3] + half_edge % 3;
  };
  support::DisjointSets sets(3 * old.size());
  for (const std::uint32_t f : old) {
    for (std::uint32_t h = 3 * f; h < 3 * f + 3; ++h) {
      sets.unite(corner(h), corner(mesh::next_half_edge(across[h])));
    }
  }
  mesh::separate_fans(rest, sets.representatives());
  return rest;
}

std::optional<FilledVoids> SliverVoids::filled(double width) const {
  FilledVoids result;
  std::vector<std::uint8_t> gone(merged_.size(), 0);
  for (const Void& sliver : voids_) {
    if (sliver.width > width) {
      continue;
    }
    const auto faces = cells_.faces_of(sliver.cell);
    result.places.push_back(mesh_.points[merged_[faces.front()][0]]);
    result.width = std::max(result.width, sliver.width);
    for (const std::uint32_t face : faces) {
      gone[face] = 1;
    }
  }
  if (result.places.empty()) {
    return std::nullopt;
  }
  result.mesh = without(gone);
  return tells_sheets_apart(result.mesh, gone) ? std::optional(std::move(result)) : std::nullopt;
}

/// Copies of points might no longer tell apart two sheets that still touch along an edge; then more
/// than two half-edges run between the same two.
bool SliverVoids::tells_sheets_apart(const mesh::ExactMesh& rest,
                                     const std::vector<std::uint8_t>& gone) const {
  std::vector<std::uint32_t> number(gone.size(), 0);  // in the rest
  for (std::size_t f = 1; f < gone.size(); ++f) {
    number[f] = number[f - 1] + (gone[f - 1] == 0 ? 1 : 0);
  }
  for (const auto& [edge, around] : around_) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> ends;
    for (const std::uint32_t h : around) {
      if (gone[h / 3] == 0) {
        const Triangle& t = rest.triangles[number[h / 3]];
        ends.emplace_back(std::minmax(t[h % 3], t[(h + 1) % 3]));
      }
    }
    std::ranges::sort(ends);
    for (std::size_t i = 0; i + 2 < ends.size(); ++i) {
      if (ends[i] == ends[i + 2]) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace dupin::rounding
