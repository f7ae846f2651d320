#include "rounding/self_crossings.h"

#include <utility>
#include <vector>

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
  mesh::ExactMesh solid = healing::wound_around(soup, surface, {}, is_faulty);
  for (Source& source : solid.sources) {
    source = sources[source.triangle];
  }
  return solid.triangles.empty() ? std::nullopt : std::optional(std::move(solid));
}

}  // namespace dupin::rounding
