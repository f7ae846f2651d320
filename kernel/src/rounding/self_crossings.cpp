#include "rounding/self_crossings.h"

#include <utility>
#include <vector>

#include "dupin/kernel/connected_components.h"
#include "healing/degenerate_faces.h"
#include "healing/polygon_soup.h"
#include "support/none.h"

namespace dupin::rounding {

std::optional<CutSurface> without_self_crossings(const TriMesh& surface,
                                                 std::span<const Source> sources,
                                                 std::span<const Fault> faults) {
  std::vector<std::uint8_t> is_faulty(surface.triangles.size(), 0);
  for (const Fault& fault : faults) {
    is_faulty[fault.first] = is_faulty[fault.second] = 1;
  }
  healing::PolygonSoup soup = healing::merge_duplicate_points(surface).soup;
  healing::drop_degenerate_faces(soup);
  CutSurface cut{.solid = healing::wound_around(soup, surface, {}, is_faulty), .origin = {}};
  cut.origin.reserve(cut.solid.sources.size());
  for (Source& source : cut.solid.sources) {
    cut.origin.push_back(source.triangle);
    source = sources[source.triangle];
  }
  return cut.solid.triangles.empty() ? std::nullopt : std::optional(std::move(cut));
}

bool keeps_shells_whole(const TriMesh& surface, const CutSurface& cut) {
  const auto before = connected_components(surface.triangles, surface.points.size());
  const auto after = connected_components(cut.solid.triangles, cut.solid.points.size());
  std::vector<std::uint32_t> became(surface.points.size(), support::kNone);  // of shells before
  for (std::size_t f = 0; f < cut.origin.size(); ++f) {
    std::uint32_t& shell = became[before[surface.triangles[cut.origin[f]][0]]];
    const std::uint32_t here = after[cut.solid.triangles[f][0]];
    if (shell != support::kNone && shell != here) {
      return false;
    }
    shell = here;
  }
  return true;
}

}  // namespace dupin::rounding
