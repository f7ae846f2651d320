#include "assembly/joined_hubs.h"

#include <algorithm>
#include <map>

#include "assembly/part_context.h"
#include "junction/hub_mesh.h"
#include "numbers/point_order.h"

namespace dupin::assembly {
Tessellation hub_tessellation(const Assembly& assembly, const ResolvedJunction& junction,
                              std::span<const RingSampling> samplings, std::size_t most_triangles) {
  return with_part_context(assembly, junction.index, [&] {
    std::vector<std::vector<Vec3>> circles;
    for (std::size_t i = 0; i < junction.arms.size(); ++i) {
      circles.push_back(sample(cap_circle(junction.shape.arms[i]), samplings[i]));
    }
    return junction::hub_mesh(junction.shape, circles,
                              {assembly.tolerance, samplings.front().grid, most_triangles});
  });
}

TriMesh joined_with_hubs(const TriMesh& runs, std::span<const HubPatch> hubs) {
  std::map<Vec3, std::uint32_t, numbers::PointOrder> vertex_at;
  for (const HubPatch& hub : hubs) {
    for (std::size_t i = 0; i < hub.on_circles; ++i) {
      vertex_at.try_emplace(hub.mesh.points[i], std::uint32_t(-1));
    }
  }
  TriMesh result = runs;
  for (std::size_t i = 0; i < runs.points.size(); ++i) {
    const auto found = vertex_at.find(runs.points[i]);
    if (found != vertex_at.end()) {
      found->second = std::uint32_t(i);
    }
  }
  for (const HubPatch& hub : hubs) {
    const auto offset = std::uint32_t(result.points.size() - hub.on_circles);
    result.points.insert(result.points.end(),
                         hub.mesh.points.begin() + std::ptrdiff_t(hub.on_circles),
                         hub.mesh.points.end());
    const auto label = std::uint32_t(result.names.size());
    result.names.insert(result.names.end(), hub.mesh.names.begin(), hub.mesh.names.end());
    for (Triangle t : hub.mesh.triangles) {
      std::ranges::transform(t, t.begin(), [&](std::uint32_t corner) {
        return corner < hub.on_circles ? vertex_at.at(hub.mesh.points[corner]) : offset + corner;
      });
      result.triangles.push_back(t);
      result.labels.push_back(label);
    }
  }
  return result;
}

}  // namespace dupin::assembly
