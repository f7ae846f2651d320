#include "gaps/gap_regions.h"

#include <map>
#include <set>

#include "exact/exact_numbers.h"
#include "gaps/opposing_faces.h"
#include "mesh/edge_table.h"
#include "support/blocks.h"
#include "support/disjoint_sets.h"

namespace dupin::gaps {
namespace {

/// A face of a and one of b that look at each other.
struct Sight {
  std::uint32_t a = 0, b = 0;
  predicates::Fraction squared;
};

predicates::ExactTriangle exact_corners(const MeshPair& pair, std::uint32_t face) {
  predicates::ExactTriangle exact;
  const std::array<Vec3, 3> corners = pair.corners(face);
  for (std::size_t i = 0; i < 3; ++i) {
    exact[i] = {corners[i].x(), corners[i].y(), corners[i].z()};
  }
  return exact;
}

std::vector<std::vector<Sight>> all_sights(const MeshPair& pair, const FaceBoxIndex& boxes,
                                           const MeshGapOptions& options) {
  const predicates::Fraction limit{CGAL::Mpzf(options.connect) * CGAL::Mpzf(options.connect), 1};
  std::vector<std::vector<Sight>> sights(pair.faces_of_a);
  support::for_each_in_parallel(pair.faces_of_a, [&](std::size_t index) {
    const auto face = static_cast<std::uint32_t>(index);
    const predicates::ExactTriangle a = exact_corners(pair, face);
    boxes.visit_near(face, options.connect, [&](std::uint32_t other) {
      const predicates::ExactTriangle b = exact_corners(pair, other);
      if (!opposed(a, b, options.cosine) || !(in_front(a, b) || in_front(b, a))) {
        return;
      }
      const predicates::Fraction squared = predicates::squared_distance(a, b);
      if (!(limit < squared)) {
        sights[face].push_back({face, other, squared});
      }
    });
  });
  return sights;
}

/// Joins faces of one mesh that are neighbours and both in sight of the other mesh.
void join_neighbours(std::span<const Triangle> triangles, std::uint32_t shift, const MeshPair& pair,
                     const std::vector<std::uint8_t>& seen, support::DisjointSets& regions) {
  const mesh::EdgeTable edges(triangles, pair.points.size());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto half_edges = edges[i].half_edges;
    const std::uint32_t first = half_edges.front() / 3 + shift;
    for (const std::uint32_t half_edge : half_edges.subspan(1)) {
      const std::uint32_t face = half_edge / 3 + shift;
      if (seen[first] != 0 && seen[face] != 0) {
        regions.unite(first, face);
      }
    }
  }
}

GapRegion region_of(const MeshPair& pair, const std::vector<const Sight*>& sights) {
  GapRegion region;
  std::set<std::uint32_t> of_a, of_b;
  const Sight *nearest = sights.front(), *farthest = nearest;
  for (const Sight* sight : sights) {
    of_a.insert(pair.source[sight->a]);
    of_b.insert(pair.source[sight->b]);
    nearest = sight->squared < nearest->squared ? sight : nearest;
    farthest = farthest->squared < sight->squared ? sight : farthest;
  }
  region.faces_a.assign(of_a.begin(), of_a.end());
  region.faces_b.assign(of_b.begin(), of_b.end());
  region.pairs = sights.size();
  const auto value = [](const predicates::Fraction& f) {
    return mpq_class(exact::rational(f.numerator) / exact::rational(f.denominator));
  };
  region.least_squared = value(nearest->squared);
  region.greatest_squared = value(farthest->squared);
  region.least = root_of(region.least_squared);
  region.greatest = root_of(region.greatest_squared);
  const auto a = pair.corners(nearest->a), b = pair.corners(nearest->b);
  region.place = (a[0] + a[1] + a[2] + b[0] + b[1] + b[2]) / 6;
  return region;
}

}  // namespace

std::vector<GapRegion> gap_regions(const MeshPair& pair, const FaceBoxIndex& boxes,
                                   const MeshGapOptions& options) {
  std::vector<std::vector<Sight>> sights = all_sights(pair, boxes, options);
  support::DisjointSets regions(pair.triangles.size());
  std::vector<std::uint8_t> seen(pair.triangles.size());
  for (const auto& of_face : sights) {
    for (const Sight& sight : of_face) {
      seen[sight.a] = seen[sight.b] = 1;
      regions.unite(sight.a, sight.b);
    }
  }
  join_neighbours(pair.of_a(), 0, pair, seen, regions);
  join_neighbours(pair.of_b(), pair.faces_of_a, pair, seen, regions);
  std::map<std::uint32_t, std::vector<const Sight*>> by_region;
  for (const auto& of_face : sights) {
    for (const Sight& sight : of_face) {
      by_region[regions.find(sight.a)].push_back(&sight);
    }
  }
  std::vector<GapRegion> result;
  for (const auto& [lowest, members] : by_region) {
    result.push_back(region_of(pair, members));
  }
  return result;
}

}  // namespace dupin::gaps
