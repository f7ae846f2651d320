#include "dupin/kernel/crease.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/Geometry>

#include "dupin/kernel/error.h"
#include "dupin/kernel/patch.h"
#include "mesh/edge_table.h"

namespace dupin {
namespace {

Vec3 doubled_area(const TriMesh& mesh, std::uint32_t triangle) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  return (mesh.points[b] - mesh.points[a]).cross(mesh.points[c] - mesh.points[a]);
}

}  // namespace

std::vector<Crease> creases_between_labels(
    const TriMesh& mesh, double angle,
    const std::function<bool(std::uint32_t, std::uint32_t)>& divides) {
  require_indices(mesh);
  if (!std::isfinite(angle)) {
    throw Error(Errc::invalid_argument, "the least angle of a crease must be finite");
  }
  if (!divides) {
    throw Error(Errc::invalid_argument, "nothing says which labels creases divide");
  }
  std::vector<Crease> result;
  if (mesh.labels.empty()) {
    return result;
  }
  const mesh::EdgeTable edges(mesh.triangles, mesh.points.size());
  // Of two triangles at the edge, if it is one.
  const auto crease = [&](const mesh::Edge& edge, std::uint32_t f,
                          std::uint32_t g) -> std::optional<Crease> {
    const auto [low, high] = std::minmax(mesh.labels[f], mesh.labels[g]);
    if (low == high || !divides(low, high)) {
      return std::nullopt;
    }
    const Vec3 first = doubled_area(mesh, f), second = doubled_area(mesh, g);
    if (!(std::atan2(first.cross(second).norm(), first.dot(second)) > angle)) {
      return std::nullopt;
    }
    return Crease{{edge.low, edge.high},
                  {std::min(f, g), std::max(f, g)},
                  (first.normalized() + second.normalized()).normalized()};
  };
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const mesh::Edge edge = edges[i];
    std::optional<Crease> found;
    for (std::size_t j = 0; j < edge.half_edges.size() && !found; ++j) {
      for (std::size_t k = j + 1; k < edge.half_edges.size() && !found; ++k) {
        found = crease(edge, edge.half_edges[j] / 3, edge.half_edges[k] / 3);
      }
    }
    if (found) {
      result.push_back(*found);
    }
  }
  return result;
}

}  // namespace dupin
