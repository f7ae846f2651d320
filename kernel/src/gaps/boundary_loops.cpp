#include "gaps/boundary_loops.h"

#include <map>
#include <set>
#include <span>

#include "exact/exact_numbers.h"
#include "gaps/mesh_pair.h"
#include "mesh/edge_table.h"

namespace dupin::gaps {
namespace {

using Successors = std::map<std::uint32_t, std::multiset<std::uint32_t>>;

Successors open_edges(std::span<const Triangle> triangles, std::size_t point_count) {
  const mesh::EdgeTable edges(triangles, point_count);
  Successors next;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const mesh::Edge edge = edges[i];
    std::ptrdiff_t surplus = 0;  // of half-edges upwards
    for (const std::uint32_t half_edge : edge.half_edges) {
      surplus += edges.origin(half_edge) == edge.low ? 1 : -1;
    }
    for (; surplus > 0; --surplus) {
      next[edge.low].insert(edge.high);
    }
    for (; surplus < 0; ++surplus) {
      next[edge.high].insert(edge.low);
    }
  }
  return next;
}

Enclosure distance(const Vec3& from, const Vec3& to) {
  const exact::ExactVector d = exact::exact_vector(to) - exact::exact_vector(from);
  return root_of(exact::rational(exact::dot(d, d)));
}

void measure(BoundaryLoop& loop, std::span<const Vec3> points) {
  loop.place = Vec3::Zero();
  const std::size_t count = loop.points.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3& here = points[loop.points[i]];
    loop.place += here / static_cast<double>(count);
    if (i + 1 < count || loop.closed) {
      loop.length = loop.length + distance(here, points[loop.points[(i + 1) % count]]);
    }
  }
}

}  // namespace

std::vector<BoundaryLoop> boundary_loops(const TriMesh& mesh) {
  const MeshPair merged_mesh = merged(mesh, {});
  Successors next = open_edges(merged_mesh.triangles, mesh.points.size());
  std::vector<BoundaryLoop> loops;
  while (!next.empty()) {
    BoundaryLoop& loop = loops.emplace_back();
    const std::uint32_t start = next.begin()->first;
    std::uint32_t here = start;
    do {
      loop.points.push_back(here);
      const auto place = next.find(here);
      if (place == next.end()) {
        loop.closed = false;
        break;
      }
      here = *place->second.begin();
      place->second.erase(place->second.begin());
      if (place->second.empty()) {
        next.erase(place);
      }
    } while (here != start);
    measure(loop, mesh.points);
  }
  return loops;
}

}  // namespace dupin::gaps
