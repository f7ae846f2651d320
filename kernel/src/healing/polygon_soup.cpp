#include "healing/polygon_soup.h"

#include <algorithm>
#include <map>

#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "mesh/coincident_points.h"
#include "mesh/edge_table.h"
#include "mesh/measure.h"
#include "mesh/shell_nesting.h"
#include "predicates/triangle_overlap.h"
#include "support/none.h"

namespace dupin::healing {
namespace {

bool repeats_a_corner(const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

// Keeps the triangles for which `keep` says so.
template <class Keep>
std::size_t filter(PolygonSoup& soup, Keep&& keep) {
  std::size_t kept = 0;
  for (std::uint32_t i = 0; i < soup.triangles.size(); ++i) {
    if (keep(i)) {
      soup.triangles[kept] = soup.triangles[i];
      soup.sources[kept++] = soup.sources[i];
    }
  }
  const std::size_t dropped = soup.triangles.size() - kept;
  soup.triangles.resize(kept);
  soup.sources.resize(kept);
  return dropped;
}

// The corner between the other two of a triangle without area.
std::size_t middle_corner(const PolygonSoup& soup, const Triangle& t) {
  std::size_t i = 0;
  const auto is_between = [&] {
    const Vec3 &p = soup.points[t[i]], &a = soup.points[t[(i + 1) % 3]],
               &b = soup.points[t[(i + 2) % 3]];
    return (p.array() >= a.cwiseMin(b).array()).all() && (p.array() <= a.cwiseMax(b).array()).all();
  };
  while (!is_between()) {
    ++i;
  }
  return i;
}

// Replaces a triangle without area by splitting one across its longest edge; false if there is
// none, or it has been changed since the edges were looked up.
bool split_neighbour(PolygonSoup& soup, const mesh::EdgeTable& edges, const mesh::Edge& longest,
                     std::uint32_t face, std::vector<bool>& changed) {
  const Triangle dropped = soup.triangles[face];
  const std::uint32_t p = dropped[middle_corner(soup, dropped)];
  for (const std::uint32_t half_edge : longest.half_edges) {
    const std::uint32_t other = half_edge / 3;
    if (other == face || changed[other]) {
      continue;
    }
    const std::uint32_t from = edges.origin(half_edge), to = edges.target(half_edge),
                        apex = edges.target(mesh::next_half_edge(half_edge));
    soup.triangles[face] = {from, p, apex};
    soup.triangles[other] = {p, to, apex};
    soup.sources[face] = soup.sources[other];
    changed[face] = changed[other] = true;
    return true;
  }
  return false;
}

// One pass over all; the number of triangles replaced.
std::size_t replace_degenerate_faces(PolygonSoup& soup) {
  const std::vector<Triangle> before = soup.triangles;
  const mesh::EdgeTable edges(before, soup.points.size());
  std::vector<bool> changed(before.size(), false);
  std::size_t replaced = 0;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const mesh::Edge edge = edges[i];
    for (const std::uint32_t half_edge : edge.half_edges) {
      const std::uint32_t face = half_edge / 3;
      const Triangle& t = before[face];
      if (changed[face] ||
          !predicates::collinear(soup.points[t[0]], soup.points[t[1]], soup.points[t[2]])) {
        continue;
      }
      const std::uint32_t opposite = edges.target(mesh::next_half_edge(half_edge));
      if (t[middle_corner(soup, t)] == opposite) {
        replaced += split_neighbour(soup, edges, edge, face, changed) ? 1 : 0;
      }
    }
  }
  return replaced;
}

// For each triangle, turned or not to agree with the lowest one of its component: those that hang
// together by edges of two.
struct Components {
  std::vector<std::uint32_t> of_face;
  std::vector<bool> is_turned;
};

Components find_components(const PolygonSoup& soup, const mesh::EdgeTable& edges) {
  using support::kNone;
  struct Link {
    std::uint32_t face = kNone;
    bool agrees = true;
  };
  std::vector<std::array<Link, 3>> links(soup.triangles.size());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const mesh::Edge edge = edges[i];
    if (edge.half_edges.size() == 2) {
      const std::uint32_t a = edge.half_edges[0], b = edge.half_edges[1];
      const bool agrees = edges.origin(a) != edges.origin(b);
      links[a / 3][a % 3] = {b / 3, agrees};
      links[b / 3][b % 3] = {a / 3, agrees};
    }
  }
  Components components{std::vector(soup.triangles.size(), kNone), std::vector<bool>(links.size())};
  for (std::uint32_t first = 0; first < links.size(); ++first) {
    if (components.of_face[first] != kNone) {
      continue;
    }
    components.of_face[first] = first;
    std::vector<std::uint32_t> queue{first};
    for (std::size_t q = 0; q < queue.size(); ++q) {
      const bool is_turned = components.is_turned[queue[q]];
      for (const Link& link : links[queue[q]]) {
        if (link.face == kNone) {
          continue;
        }
        const bool should_turn = is_turned == link.agrees;
        if (components.of_face[link.face] == kNone) {
          components.of_face[link.face] = first;
          components.is_turned[link.face] = should_turn;
          queue.push_back(link.face);
        } else if (components.is_turned[link.face] != should_turn) {
          throw Error(Errc::not_oriented,
                      "the mesh cannot be repaired: its surface has only one side, near " +
                          decimal(soup.points[soup.triangles[link.face][0]]));
        }
      }
    }
  }
  return components;
}

void turn(Triangle& t) { std::swap(t[1], t[2]); }

std::vector<std::uint32_t> faces_to_agree(const PolygonSoup& soup) {
  const mesh::EdgeTable edges(soup.triangles, soup.points.size());
  const Components components = find_components(soup, edges);
  std::map<std::uint32_t, std::ptrdiff_t> majority;  // of unturned faces of each component
  for (std::uint32_t i = 0; i < soup.triangles.size(); ++i) {
    majority[components.of_face[i]] += components.is_turned[i] ? -1 : 1;
  }
  std::vector<std::uint32_t> to_turn;
  for (std::uint32_t i = 0; i < soup.triangles.size(); ++i) {
    if (components.is_turned[i] == (majority[components.of_face[i]] >= 0)) {
      to_turn.push_back(i);
    }
  }
  return to_turn;
}

// Shells of negative volume that an even number of others encloses.
std::vector<std::uint32_t> faces_inside_out(const PolygonSoup& soup) {
  const mesh::EdgeTable edges(soup.triangles, soup.points.size());
  const mesh::Shells shells = mesh::shells(soup.triangles.size(), edges);
  const mesh::MeshView mesh(soup.points, soup.triangles);
  const std::vector<int> depths = mesh::nesting_depths(mesh, shells);
  std::vector<std::uint32_t> to_turn;
  for (std::size_t shell = 0; shell < shells.count; ++shell) {
    std::vector<Triangle> faces;
    for (const std::uint32_t face : shells.faces_of(shell)) {
      faces.push_back(soup.triangles[face]);
    }
    if (depths[shell] % 2 == 0 && mesh::volume_sign({soup.points, faces}) < 0) {
      const auto of_shell = shells.faces_of(shell);
      to_turn.insert(to_turn.end(), of_shell.begin(), of_shell.end());
    }
  }
  return to_turn;
}

}  // namespace

PolygonSoup merge_duplicate_points(const TriMesh& mesh, RepairReport& report) {
  const std::vector<std::uint32_t> first = mesh::coincident_representatives(mesh.points);
  PolygonSoup soup{mesh.points, mesh.triangles, {}};
  std::vector<bool> is_copy(mesh.points.size());
  for (std::uint32_t i = 0; i < soup.triangles.size(); ++i) {
    soup.sources.push_back(i);
    for (std::uint32_t& corner : soup.triangles[i]) {
      is_copy[corner] = first[corner] != corner;
      corner = first[corner];
    }
  }
  report.merged_points = static_cast<std::size_t>(std::count(is_copy.begin(), is_copy.end(), true));
  return soup;
}

void drop_degenerate_faces(PolygonSoup& soup, RepairReport& report) {
  const auto drop_folded = [&] {
    return filter(soup, [&](std::uint32_t i) { return !repeats_a_corner(soup.triangles[i]); });
  };
  report.degenerate_faces += drop_folded();
  // Each replacement leaves a shorter edge to mend, if any; chains of them are rare and short.
  constexpr int kPasses = 64;
  for (int pass = 0; pass < kPasses; ++pass) {
    const std::size_t replaced = replace_degenerate_faces(soup);
    report.degenerate_faces += replaced;
    if (replaced == 0) {
      return;
    }
    drop_folded();
  }
}

void drop_duplicate_faces(PolygonSoup& soup, RepairReport& report) {
  struct Copies {
    std::vector<std::uint32_t> even, odd;  // by the orientation of the corners
  };
  std::map<Triangle, Copies> by_corners;
  for (std::uint32_t i = 0; i < soup.triangles.size(); ++i) {
    Triangle corners = soup.triangles[i];
    const auto first = std::min_element(corners.begin(), corners.end());
    std::rotate(corners.begin(), first, corners.end());
    const bool is_odd = corners[1] > corners[2];
    std::sort(corners.begin(), corners.end());
    (is_odd ? by_corners[corners].odd : by_corners[corners].even).push_back(i);
  }
  std::vector<bool> is_kept(soup.triangles.size(), false);
  std::map<std::array<std::uint32_t, 2>, std::size_t> single;  // edges by faces that cover alone
  for (const auto& [corners, copies] : by_corners) {
    for (const auto* same : {&copies.even, &copies.odd}) {
      if (!same->empty()) {
        is_kept[same->front()] = true;
      }
    }
    if (copies.even.empty() || copies.odd.empty()) {
      ++single[{corners[0], corners[1]}];
      ++single[{corners[0], corners[2]}];
      ++single[{corners[1], corners[2]}];
    }
  }
  for (const auto& [corners, copies] : by_corners) {
    if (!copies.even.empty() && !copies.odd.empty()) {
      const auto alone = single.find({corners[0], corners[1]});
      const bool is_needed = alone != single.end() && alone->second % 2 == 1;
      is_kept[std::max(copies.even.front(), copies.odd.front())] = false;
      is_kept[std::min(copies.even.front(), copies.odd.front())] = is_needed;
    }
  }
  report.duplicate_faces = filter(soup, [&](std::uint32_t i) { return is_kept[i]; });
}

void orient_soup(PolygonSoup& soup, RepairReport& report) {
  const std::vector<Triangle> before = soup.triangles;
  for (const std::uint32_t face : faces_to_agree(soup)) {
    turn(soup.triangles[face]);
  }
  for (const std::uint32_t face : faces_inside_out(soup)) {
    turn(soup.triangles[face]);
  }
  for (std::size_t i = 0; i < before.size(); ++i) {
    report.turned_faces += soup.triangles[i] == before[i] ? 0 : 1;
  }
}

}  // namespace dupin::healing
