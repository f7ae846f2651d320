#include "healing/polygon_soup.h"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "arrangement/arrange.h"
#include "mesh/coincident_points.h"
#include "mesh/edge_table.h"
#include "mesh/measure.h"
#include "mesh/shell_nesting.h"

namespace dupin::healing {
namespace {

void turn(Triangle& t) { std::swap(t[1], t[2]); }

using Faces = std::vector<std::uint32_t>;

int volume_sign(const PolygonSoup& soup, const mesh::Shells& shells, std::size_t shell) {
  std::vector<Triangle> faces;
  for (const std::uint32_t face : shells.faces_of(shell)) {
    faces.push_back(soup.triangles[face]);
  }
  return mesh::volume_sign({soup.points, faces});
}

// Shells of negative volume that an even number of others encloses, and those right inside of one
// of these that face it as a cavity's wall does.
Faces faces_inside_out(const PolygonSoup& soup) {
  const mesh::EdgeTable edges(soup.triangles, soup.points.size());
  const mesh::Shells shells = mesh::shells(soup.triangles.size(), edges);
  const mesh::MeshView mesh(soup.points, soup.triangles);
  const std::vector<int> depths = mesh::nesting_depths(mesh, shells);
  std::vector<std::size_t> outer, cavities;
  for (std::size_t shell = 0; shell < shells.count; ++shell) {
    const int sign = volume_sign(soup, shells, shell);
    if (depths[shell] % 2 == 0 && sign < 0) {
      outer.push_back(shell);
    } else if (depths[shell] % 2 != 0 && sign > 0) {
      cavities.push_back(shell);
    }
  }
  std::vector<std::size_t> to_turn = outer;
  if (!outer.empty() && !cavities.empty()) {
    const mesh::ShellNest nest(mesh, shells);
    std::ranges::copy_if(cavities, std::back_inserter(to_turn), [&](std::size_t inner) {
      return std::ranges::any_of(outer, [&](std::size_t shell) {
        return depths[shell] + 1 == depths[inner] && nest.encloses(shell, inner);
      });
    });
  }
  Faces faces;
  for (const std::size_t shell : to_turn) {
    const auto of_shell = shells.faces_of(shell);
    faces.insert(faces.end(), of_shell.begin(), of_shell.end());
  }
  return faces;
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
