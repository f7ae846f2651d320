#include "healing/kept_surface.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <vector>

#include "mesh/coincident_points.h"
#include "mesh/measure.h"
#include "mesh/projected_areas.h"

namespace dupin::healing {
namespace {

using Triangles = std::vector<Triangle>;

// By the places of their corners, of which the first is the least.
Triangles sorted(const std::vector<Triangle>& triangles, std::uint32_t first,
                 const std::vector<std::uint32_t>& place) {
  Triangles result;
  result.reserve(triangles.size());
  for (Triangle t : triangles) {
    for (std::uint32_t& corner : t) {
      corner = place[first + corner];
    }
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    result.push_back(t);
  }
  std::sort(result.begin(), result.end());
  return result;
}

Triangles without(const Triangles& from, const Triangles& what) {
  Triangles rest;
  std::ranges::set_difference(from, what, std::back_inserter(rest));
  return rest;
}

}  // namespace

// Lemma: the boundary's pieces are parts of the soup's triangles, none of them there twice. So
// nothing is missing if for each axis the areas of projections along it have the same sum.
bool keeps_surface(const mesh::ExactMesh& solid, const PolygonSoup& soup) {
  const mesh::MeshView before(soup.points, soup.triangles), after(solid);
  constexpr double kCertain = 1e-11;  // of areas that are right to 1e-12
  if (mesh::area(after) < (1 - kCertain) * mesh::area(before)) {
    return false;
  }
  // Points of both, those that no double holds last, each in a place of its own.
  std::vector<Vec3> points = soup.points;
  const auto first = static_cast<std::uint32_t>(points.size());
  points.insert(points.end(), solid.points.begin(), solid.points.begin() + solid.double_count());
  std::vector<std::uint32_t> place = mesh::coincident_representatives(points);
  for (std::size_t i = solid.double_count(); i < solid.points.size(); ++i) {
    place.push_back(static_cast<std::uint32_t>(first + i));
    points.push_back(solid.points[i]);
  }
  const Triangles of_soup = sorted(soup.triangles, 0, place),
                  of_solid = sorted(solid.triangles, first, place);
  const Triangles lost = without(of_soup, of_solid), made = without(of_solid, of_soup);
  mesh::MeshView lost_view(points, lost), made_view(points, made);
  lost_view.implicit = made_view.implicit = &solid.implicit;
  return mesh::projected_areas(lost_view) == mesh::projected_areas(made_view);
}

}  // namespace dupin::healing
