#include "rounding/self_crossings.h"

#include <utility>
#include <vector>

#include "arrangement/arrange.h"
#include "healing/degenerate_faces.h"
#include "healing/polygon_soup.h"

namespace dupin::rounding {

std::optional<mesh::ExactMesh> without_self_crossings(const TriMesh& surface,
                                                      std::span<const Source> sources,
                                                      std::span<const Fault> faults) {
  std::vector<std::uint8_t> is_faulty(surface.triangles.size(), 0);
  for (const Fault& fault : faults) {
    is_faulty[fault.first] = is_faulty[fault.second] = 1;
  }
  healing::PolygonSoup soup = healing::merge_duplicate_points(surface).soup;
  healing::drop_degenerate_faces(soup);
  mesh::ExactMesh closed;
  closed.points = std::move(soup.points);
  closed.triangles = std::move(soup.triangles);
  closed.names = surface.names;
  std::vector<std::uint8_t> crossing;
  for (const std::uint32_t face : soup.sources) {
    crossing.push_back(is_faulty[face]);
    closed.sources.push_back(sources[face]);
    if (!surface.labels.empty()) {
      closed.labels.push_back(surface.labels[face]);
    }
  }
  mesh::ExactMesh solid = arrangement::positive_winding_boundary(closed, {}, crossing);
  for (Source& source : solid.sources) {
    source = closed.sources[source.triangle];
  }
  return solid.triangles.empty() ? std::nullopt : std::optional(std::move(solid));
}

}  // namespace dupin::rounding
