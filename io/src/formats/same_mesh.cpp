#include "formats/same_mesh.h"

#include <limits>
#include <numeric>
#include <vector>

#include "text/mesh_text.h"

namespace dupin::formats {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

std::optional<std::uint32_t> first_difference(const TriMesh& mesh, const TriMesh& read_back,
                                              const std::vector<std::uint32_t>& order) {
  std::vector<std::uint32_t> there(mesh.points.size(), kNone), here(read_back.points.size(), kNone);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::uint32_t face = order[i];
    if (i >= read_back.triangles.size()) {
      return face;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t point = mesh.triangles[face][k], other = read_back.triangles[i][k];
      if (there[point] == kNone && here[other] == kNone) {
        there[point] = other;
        here[other] = point;
        if (mesh.points[point] != read_back.points[other]) {
          return face;
        }
      } else if (there[point] != other || here[other] != point) {
        return face;
      }
    }
  }
  const bool has_more = read_back.triangles.size() > order.size();
  return has_more ? std::optional(order.empty() ? 0 : order.back()) : std::nullopt;
}

}  // namespace

std::optional<std::uint32_t> first_difference(const TriMesh& mesh, const TriMesh& read_back) {
  if (read_back.points == mesh.points && read_back.triangles == mesh.triangles) {
    return std::nullopt;
  }
  std::vector<std::uint32_t> order(mesh.triangles.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto difference = first_difference(mesh, read_back, order);
  if (!difference || mesh.labels.empty()) {
    return difference;
  }
  order.clear();
  for (const auto& group : text::triangles_by_label(mesh)) {
    order.insert(order.end(), group.begin(), group.end());
  }
  return first_difference(mesh, read_back, order);
}

}  // namespace dupin::formats
