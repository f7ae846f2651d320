#include "gaps/gap_regions.h"

#include <map>
#include <set>
#include <vector>

#include "exact/exact_numbers.h"
#include "mesh/edge_table.h"
#include "support/blocks.h"
#include "support/disjoint_sets.h"

namespace dupin::gaps {
namespace {

using CGAL::Mpzf;

/// (x / w, y / w), w > 0.
struct FlatPoint {
  Mpzf x, y, w;
};
using Polygon = std::vector<FlatPoint>;

int turn(const FlatPoint& a, const FlatPoint& b, const FlatPoint& c) {
  return exact::sign(a.x * (b.y * c.w - c.y * b.w) - a.y * (b.x * c.w - c.x * b.w) +
                     a.w * (b.x * c.y - c.x * b.y));
}

/// Maps a triangle's plane to coordinates that the projection along its normal keeps.
class Projection {
 public:
  explicit Projection(const exact::ExactVector& normal) {
    // Two vectors orthogonal to the normal: those with a zero in place of a coordinate other than
    // `axis`, on which the normal is not zero.
    std::size_t axis = 0;
    while (exact::sign(normal[axis]) == 0) {
      ++axis;
    }
    const std::size_t i = (axis + 1) % 3, j = (axis + 2) % 3;
    first_[i] = normal[axis];
    first_[axis] = -normal[i];
    second_[j] = normal[axis];
    second_[axis] = -normal[j];
  }
  [[nodiscard]] FlatPoint operator()(const exact::ExactVector& p, const Mpzf& w) const {
    return {exact::dot(p, first_), exact::dot(p, second_), w};
  }

 private:
  exact::ExactVector first_, second_;
};

/// The part of `b` on the positive side of a plane, projected; empty unless some of it is strictly
/// on that side.
Polygon part_above(const predicates::ExactTriangle& b, const std::array<Mpzf, 3>& heights,
                   const Projection& projected) {
  Polygon part;
  bool above = false;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const int here = exact::sign(heights[i]), there = exact::sign(heights[j]);
    above = above || here > 0;
    if (here >= 0) {
      part.push_back(projected(b[i], 1));
    }
    if (here * there < 0) {
      const Mpzf drop = here > 0 ? heights[i] - heights[j] : heights[j] - heights[i];
      exact::ExactVector crossing;
      for (std::size_t k = 0; k < 3; ++k) {
        crossing[k] = b[j][k] * heights[i] - b[i][k] * heights[j];
        crossing[k] = here > 0 ? crossing[k] : -crossing[k];
      }
      part.push_back(projected(crossing, drop));
    }
  }
  return above ? part : Polygon{};
}

/// Whether the line through some edge of one convex polygon has all of the other beyond or on it.
bool edge_separates(const Polygon& one, const Polygon& other) {
  for (std::size_t i = 0; i < one.size(); ++i) {
    const FlatPoint &from = one[i], &to = one[(i + 1) % one.size()];
    int inner = 0;
    for (const FlatPoint& p : one) {
      const int side = turn(from, to, p);
      inner = side != 0 ? side : inner;
    }
    bool beyond = true;
    for (const FlatPoint& p : other) {
      beyond = beyond && turn(from, to, p) * inner <= 0;
    }
    if (beyond) {
      return true;
    }
  }
  return false;
}

/// A face of a and one of b that look at each other.
struct Sight {
  std::uint32_t a = 0, b = 0;
  predicates::Fraction squared;
};

predicates::ExactTriangle exact_corners(const MeshPair& pair, std::uint32_t face) {
  predicates::ExactTriangle exact;
  const std::array<Vec3, 3> corners = pair.corners(face);
  for (std::size_t i = 0; i < 3; ++i) {
    exact[i] = exact::exact_vector(corners[i]);
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

bool opposed(const predicates::ExactTriangle& a, const predicates::ExactTriangle& b,
             double cosine) {
  const exact::ExactVector n = exact::cross(a[1] - a[0], a[2] - a[0]),
                           m = exact::cross(b[1] - b[0], b[2] - b[0]);
  const Mpzf along = exact::dot(n, m), limit(cosine);
  return exact::sign(along) < 0 &&
         limit * limit * exact::dot(n, n) * exact::dot(m, m) <= along * along;
}

bool in_front(const predicates::ExactTriangle& a, const predicates::ExactTriangle& b) {
  const exact::ExactVector normal = exact::cross(a[1] - a[0], a[2] - a[0]);
  std::array<Mpzf, 3> heights;
  for (std::size_t i = 0; i < 3; ++i) {
    heights[i] = exact::dot(b[i] - a[0], normal);
  }
  const Projection projected(normal);
  const Polygon part = part_above(b, heights, projected);
  const Polygon base = {projected(a[0], 1), projected(a[1], 1), projected(a[2], 1)};
  return !part.empty() && !edge_separates(base, part) && !edge_separates(part, base);
}

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
