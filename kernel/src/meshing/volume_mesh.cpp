#include "dupin/kernel/volume_mesh.h"

#include <algorithm>
#include <string>
#include <utility>

#include "dupin/kernel/error.h"
#include "support/none.h"

namespace dupin {
namespace {

template <class Cells>
void require_corners(const Cells& cells, std::size_t points, const std::string& kind) {
  for (std::size_t i = 0; i < cells.size(); ++i) {
    for (const std::uint32_t corner : cells[i]) {
      if (corner >= points) {
        throw Error(Errc::invalid_argument, kind + " " + std::to_string(i) + " has the corner " +
                                                std::to_string(corner) + "; there are " +
                                                std::to_string(points) + " points");
      }
    }
  }
}

}  // namespace

VolumeMesh volume_mesh_of(TriMesh surface, std::vector<Tetrahedron> tetrahedra) {
  require_corners(tetrahedra, surface.points.size(), "tetrahedron");
  require_corners(surface.triangles, surface.points.size(), "triangle");
  enum class Place : std::uint8_t { nowhere, on_surface, inside };
  std::vector<Place> places(surface.points.size(), Place::nowhere);
  for (const Tetrahedron& tetrahedron : tetrahedra) {
    for (const std::uint32_t corner : tetrahedron) {
      places[corner] = Place::inside;
    }
  }
  for (const Triangle& triangle : surface.triangles) {
    for (const std::uint32_t corner : triangle) {
      places[corner] = Place::on_surface;
    }
  }
  VolumeMesh mesh;
  std::vector<std::uint32_t> position(places.size(), support::kNone);
  std::uint32_t next = 0;
  for (const Place place : {Place::on_surface, Place::inside}) {
    std::vector<Vec3>& points =
        place == Place::on_surface ? mesh.surface.points : mesh.inner_points;
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (places[i] == place) {
        position[i] = next++;
        points.push_back(surface.points[i]);
      }
    }
  }
  const auto renumber = [&](auto& corners) {
    std::ranges::transform(corners, corners.begin(),
                           [&](std::uint32_t corner) { return position[corner]; });
  };
  std::ranges::for_each(surface.triangles, renumber);
  std::ranges::for_each(tetrahedra, renumber);
  surface.points = std::move(mesh.surface.points);
  mesh.surface = std::move(surface);
  mesh.tetrahedra = std::move(tetrahedra);
  return mesh;
}

}  // namespace dupin
