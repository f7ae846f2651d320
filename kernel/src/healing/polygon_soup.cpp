#include "healing/polygon_soup.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "arrangement/arrange.h"
#include "healing/closed_shells.h"
#include "healing/shell_enclosure.h"
#include "mesh/coincident_points.h"
#include "mesh/edge_table.h"
#include "mesh/measure.h"
#include "support/disjoint_sets.h"
#include "support/sequences.h"

namespace dupin::healing {
namespace {

void turn(Triangle& t) { std::swap(t[1], t[2]); }

using Faces = std::vector<std::uint32_t>;

std::vector<int> volume_signs(const PolygonSoup& soup, const mesh::Shells& shells) {
  std::vector<int> signs;
  for (std::size_t shell = 0; shell < shells.count; ++shell) {
    const auto faces =
        support::selected(std::span(std::as_const(soup.triangles)), shells.faces_of(shell));
    signs.push_back(mesh::volume_sign({soup.points, faces}));
  }
  return signs;
}

struct InsideOut {
  Faces faces;
  std::size_t cavities = 0;  // shells of negative volume, once these are turned
};

using Ends = std::array<std::uint32_t, 2>;

Triangle ascending(Triangle corners) {
  std::ranges::sort(corners);
  return corners;
}

std::array<Ends, 3> edges_of(const Triangle& t) {
  const auto [a, b, c] = ascending(t);
  return {Ends{a, b}, Ends{a, c}, Ends{b, c}};
}

// If what a shell has alone is in several parts without the edges that another one has, too.
bool is_parted_by(std::span<const Triangle> shell, std::span<const Triangle> other) {
  std::set<Triangle> faces;
  std::set<Ends> edges;
  for (const Triangle& t : other) {
    faces.insert(ascending(t));
    for (const Ends& edge : edges_of(t)) {
      edges.insert(edge);
    }
  }
  std::map<Ends, std::uint32_t> face_at;
  support::DisjointSets parts(shell.size());
  std::set<std::uint32_t> alone;
  for (std::uint32_t i = 0; i < shell.size(); ++i) {
    if (faces.contains(ascending(shell[i]))) {
      continue;
    }
    alone.insert(i);
    for (const Ends& edge : edges_of(shell[i])) {
      if (!edges.contains(edge)) {
        parts.unite(i, face_at.try_emplace(edge, i).first->second);
      }
    }
  }
  return std::ranges::any_of(
      alone, [&](std::uint32_t i) { return parts.find(i) != parts.find(*alone.begin()); });
}

// If shells of which one is within the other might as well be others that cross: parts of the one
// go on as parts of the other. Of a single part each, they would be what they are.
bool may_cross(const PolygonSoup& soup, const mesh::Shells& shells, const ShellPair& pair) {
  const std::span all(std::as_const(soup.triangles));
  const auto a = support::selected(all, shells.faces_of(pair.first)),
             b = support::selected(all, shells.faces_of(pair.second));
  return is_parted_by(a, b) || is_parted_by(b, a);
}

// Per shell the number of those around it. Where some of one sign of volume might as well be
// others that cross, of these the inmost counts alone, and only around what is none of them.
std::vector<int> depths_of(const PolygonSoup& soup, const ClosedShells& closed,
                           std::span<const int> signs, const ShellEnclosure& enclosure) {
  std::vector<std::vector<std::uint32_t>> within(closed.shells.count);
  for (const auto& [a, b] : closed.at_one_edge) {
    if (signs[a] == signs[b]) {
      for (const auto& [outer, inner] : {ShellPair(a, b), ShellPair(b, a)}) {
        if (std::ranges::binary_search(enclosure.around(inner), outer) &&
            may_cross(soup, closed.shells, {outer, inner})) {
          within[outer].push_back(inner);
        }
      }
    }
  }
  std::vector<int> depths;
  depths.reserve(closed.shells.count);
  for (std::uint32_t shell = 0; shell < closed.shells.count; ++shell) {
    const auto around = enclosure.around(shell);
    const auto is_replaced = [&](std::uint32_t outer) {
      return std::ranges::any_of(within[outer], [&](std::uint32_t inner) {
        return inner == shell || std::ranges::binary_search(around, inner);
      });
    };
    depths.push_back(
        static_cast<int>(std::ssize(around) - std::ranges::count_if(around, is_replaced)));
  }
  return depths;
}

// Shells of negative volume that an even number of others encloses, and those right inside of one
// of these that face it as a cavity's wall does.
InsideOut inside_out(const PolygonSoup& soup) {
  const ClosedShells closed = closed_shells(soup.points, soup.triangles);
  const mesh::Shells& shells = closed.shells;
  const std::vector<int> signs = volume_signs(soup, shells);
  if (std::ranges::find(signs, -1) == signs.end()) {
    return {};
  }
  const ShellEnclosure enclosure(soup, shells, signs);
  const std::vector<int> depths = depths_of(soup, closed, signs, enclosure);
  std::vector<std::size_t> to_turn;
  InsideOut result;
  for (std::size_t shell = 0; shell < shells.count; ++shell) {
    if (depths[shell] % 2 == 0 && signs[shell] < 0) {
      to_turn.push_back(shell);
    } else if (signs[shell] < 0) {
      ++result.cavities;
    } else if (depths[shell] % 2 != 0 && signs[shell] > 0 &&
               std::ranges::any_of(enclosure.around(shell), [&](std::uint32_t outer) {
                 return depths[outer] + 1 == depths[shell] && signs[outer] < 0;
               })) {
      to_turn.push_back(shell);
      ++result.cavities;
    }
  }
  for (const std::size_t shell : to_turn) {
    const auto of_shell = shells.faces_of(shell);
    result.faces.insert(result.faces.end(), of_shell.begin(), of_shell.end());
  }
  return result;
}

}  // namespace

MergedPoints merge_duplicate_points(const TriMesh& mesh) {
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
  const auto copies = std::ranges::count(is_copy, true);
  return {std::move(soup), static_cast<std::size_t>(copies)};
}

mesh::ExactMesh wound_around(const PolygonSoup& soup, const TriMesh& mesh, const Progress& progress,
                             std::span<const std::uint8_t> crossing) {
  mesh::ExactMesh surface;
  surface.points = soup.points;
  surface.triangles = soup.triangles;
  surface.names = mesh.names;
  std::vector<std::uint8_t> is_crossing;
  for (const std::uint32_t face : soup.sources) {
    surface.sources.push_back({0, face});
    if (!mesh.labels.empty()) {
      surface.labels.push_back(mesh.labels[face]);
    }
    if (!crossing.empty()) {
      is_crossing.push_back(crossing[face]);
    }
  }
  mesh::ExactMesh solid = arrangement::positive_winding_boundary(surface, progress, is_crossing);
  for (Source& source : solid.sources) {
    source.triangle = soup.sources[source.triangle];
  }
  return solid;
}

std::size_t turn_shells_outward(PolygonSoup& soup, std::vector<std::uint8_t>& is_turned) {
  const InsideOut found = inside_out(soup);
  for (const std::uint32_t face : found.faces) {
    turn(soup.triangles[face]);
    is_turned[face] ^= 1;
  }
  return found.cavities;
}

}  // namespace dupin::healing
