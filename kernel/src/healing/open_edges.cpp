#include "healing/open_edges.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "healing/degenerate_faces.h"
#include "healing/face_copies.h"
#include "mesh/edge_table.h"
#include "support/disjoint_sets.h"

namespace dupin::healing {
namespace {

using mesh::Edge;
using mesh::EdgeTable;
using Numbers = std::set<std::uint32_t>;

struct OpenEdges {
  std::size_t count = 0;
  std::size_t first = 0;
};

OpenEdges find_open(const EdgeTable& edges) {
  OpenEdges open;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const Edge edge = edges[i];
    const auto up = std::ranges::count_if(
        edge.half_edges, [&](std::uint32_t h) { return edges.origin(h) == edge.low; });
    if (2 * up != std::ssize(edge.half_edges) && open.count++ == 0) {
      open.first = i;
    }
  }
  return open;
}

// "face 3", "faces 1, 2 and 3".
std::string listed(const Numbers& faces) {
  constexpr std::size_t kMost = 6;
  std::string text = faces.size() == 1 ? "face " : "faces ";
  std::size_t shown = 0;
  for (const std::uint32_t face : faces) {
    if (shown == kMost) {
      return text + " and " + std::to_string(faces.size() - shown) + " more";
    }
    text += (shown == 0 ? "" : shown + 1 == faces.size() ? " and " : ", ") + std::to_string(face);
    ++shown;
  }
  return text;
}

struct FacesAtEdge {
  Numbers faces;               // of the mesh
  std::set<Triangle> corners;  // ascending
};

Triangle ascending(Triangle corners) {
  std::ranges::sort(corners);
  return corners;
}

FacesAtEdge faces_at(const Edge& edge, const PolygonSoup& soup) {
  FacesAtEdge at;
  for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
    const Triangle& t = soup.triangles[i];
    if (std::ranges::find(t, edge.low) != t.end() && std::ranges::find(t, edge.high) != t.end()) {
      at.faces.insert(soup.sources[i]);
      at.corners.insert(ascending(t));
    }
  }
  return at;
}

bool closes(PolygonSoup soup) {
  try {
    close_surface(soup);
  } catch (const Error& error) {
    if (error.code() == Errc::not_oriented) {
      return false;
    }
    throw;
  }
  return !soup.triangles.empty() &&
         find_open(EdgeTable(soup.triangles, soup.points.size())).count == 0;
}

// The faces that have some of the triangles, or copies of them.
Numbers faces_of(std::vector<Triangle> triangles, const PolygonSoup& soup) {
  for (Triangle& t : triangles) {
    t = ascending(t);
  }
  std::ranges::sort(triangles);
  Numbers faces;
  for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
    if (std::ranges::binary_search(triangles, ascending(soup.triangles[i]))) {
      faces.insert(soup.sources[i]);
    }
  }
  return faces;
}

PolygonSoup without(const Numbers& faces, const PolygonSoup& soup) {
  PolygonSoup rest{soup.points, {}, {}};
  for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
    if (!faces.contains(soup.sources[i])) {
      rest.triangles.push_back(soup.triangles[i]);
      rest.sources.push_back(soup.sources[i]);
    }
  }
  return rest;
}

// The fewest faces that hang together by edges of two, one of them at the edge, without which the
// rest could be closed. `given`: with the copies that the soup has no more.
Numbers faces_too_many(const Edge& edge, const EdgeTable& edges, const PolygonSoup& soup,
                       const PolygonSoup& given) {
  support::DisjointSets patches(soup.triangles.size());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (const auto along = edges[i].half_edges; along.size() == 2) {
      patches.unite(along[0] / 3, along[1] / 3);
    }
  }
  const std::vector<std::uint32_t> patch_of = patches.representatives();
  Numbers tried, best;
  for (const std::uint32_t half_edge : edge.half_edges) {
    constexpr std::size_t kMostTried = 6;
    const std::uint32_t patch = patch_of[half_edge / 3];
    if (tried.size() == kMostTried || !tried.insert(patch).second) {
      continue;
    }
    std::vector<Triangle> of_patch;
    for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
      if (patch_of[i] == patch) {
        of_patch.push_back(soup.triangles[i]);
      }
    }
    const Numbers faces = faces_of(std::move(of_patch), given);
    if ((best.empty() || faces.size() < best.size()) && closes(without(faces, given))) {
      best = faces;
    }
  }
  return best;
}

std::string fault_at(const Edge& edge, const EdgeTable& edges, const PolygonSoup& soup,
                     const TriMesh& mesh) {
  PolygonSoup given = merge_duplicate_points(mesh).soup;
  drop_degenerate_faces(given);
  const auto [faces, corners] = faces_at(edge, given);
  std::string text = "where " + listed(faces) +
                     " meet, and no way was found to turn and count them that closes the surface";
  if (faces.size() == 1) {
    text = "which only " + listed(faces) + " has";
  } else if (corners.size() == 1) {
    text = "which only " + listed(faces) + " have, copies of each other";
  }
  const Numbers too_many = faces_too_many(edge, edges, soup, given);
  return text + (too_many.empty() ? "" : "; without " + listed(too_many) + " it would be closed");
}

}  // namespace

void refuse_open_edges(const PolygonSoup& soup, const TriMesh& given) {
  const EdgeTable edges(soup.triangles, soup.points.size());
  const OpenEdges open = find_open(edges);
  if (open.count == 0) {
    return;
  }
  const Edge edge = edges[open.first];
  throw Error(Errc::not_closed, "the mesh cannot be repaired: " + std::to_string(open.count) +
                                    (open.count == 1 ? " edge is" : " edges are") +
                                    " open, first the one from " + decimal(soup.points[edge.low]) +
                                    " to " + decimal(soup.points[edge.high]) + ", " +
                                    fault_at(edge, edges, soup, given) + "; holes are not filled");
}

}  // namespace dupin::healing
