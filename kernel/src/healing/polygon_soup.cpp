#include "healing/polygon_soup.h"

#include <algorithm>
#include <utility>

#include "arrangement/arrange.h"
#include "mesh/coincident_points.h"
#include "mesh/edge_table.h"
#include "mesh/measure.h"
#include "mesh/shell_nesting.h"

namespace dupin::healing {
namespace {

void turn(Triangle& t) { std::swap(t[1], t[2]); }

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

std::size_t turn_shells_outward(PolygonSoup& soup, std::vector<bool> is_turned) {
  for (const std::uint32_t face : faces_inside_out(soup)) {
    turn(soup.triangles[face]);
    is_turned[face] = !is_turned[face];
  }
  return static_cast<std::size_t>(std::ranges::count(is_turned, true));
}

}  // namespace dupin::healing
