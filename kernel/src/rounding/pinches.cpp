#include "rounding/pinches.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>

#include "mesh/coincident_points.h"

namespace dupin::rounding {
namespace {

using Place = std::array<double, 3>;

Place place_of(const Vec3& point) { return {point.x(), point.y(), point.z()}; }

using Corner = std::pair<Place, std::uint32_t>;

/// In the order of their places.
std::vector<Corner> corners_of(const EditedMesh& mesh, std::uint32_t face) {
  std::vector<Corner> corners;
  for (const std::uint32_t v : mesh.triangle(face)) {
    corners.emplace_back(place_of(mesh.point(v)), v);
  }
  std::ranges::sort(corners);
  return corners;
}

std::vector<std::uint8_t> moved_copies(std::span<const std::uint32_t> representatives,
                                       std::span<const std::uint8_t> moved) {
  std::vector<std::uint8_t> result(representatives.size(), 0);
  for (std::uint32_t v = 0; v < representatives.size(); ++v) {
    if (const std::uint32_t first = representatives[v]; first != v) {
      result[v] = moved[v];
      result[first] = moved[first];
    }
  }
  return result;
}

}  // namespace

std::vector<Vec3> pinched_places(const EditedMesh& mesh,
                                 std::span<const std::uint32_t> representatives,
                                 std::span<const std::uint8_t> moved) {
  std::vector<Vec3> places;
  std::vector<std::uint8_t> is_middle;
  for (const Fault& fault : mesh.faults()) {
    std::vector<Corner> corners = corners_of(mesh, fault.first);
    if (fault.first != fault.second) {
      const std::vector<Corner> others = corners_of(mesh, fault.second);
      if (!std::ranges::equal(corners, others, {}, &Corner::first, &Corner::first)) {
        continue;
      }
      corners.insert(corners.end(), others.begin(), others.end());
    }
    if (is_middle.empty()) {
      is_middle = moved_copies(representatives, moved);
    }
    for (const auto& [place, v] : corners) {
      for (const auto& [same, w] : corners) {
        if (is_middle[v] != 0 && v != w && place == same) {
          places.push_back(mesh.point(v));
        }
      }
    }
  }
  std::ranges::sort(places, {}, place_of);
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

double close_pinches(std::span<const Vec3> places, double farthest, TriMesh& surface,
                     std::vector<Fault>& faults) {
  if (places.empty()) {
    return 0;
  }
  using Target = std::pair<double, Place>;  // the nearer one, or the first of two as near
  std::map<Place, std::optional<Target>> targets;
  for (const Vec3& place : places) {
    targets.emplace(place_of(place), std::nullopt);
  }
  for (const Triangle& triangle : surface.triangles) {
    for (const std::uint32_t v : triangle) {
      const auto own = targets.find(place_of(surface.points[v]));
      if (own == targets.end()) {
        continue;
      }
      for (const std::uint32_t w : triangle) {
        const Place other = place_of(surface.points[w]);
        if (targets.contains(other)) {
          continue;
        }
        const Target target{(surface.points[w] - surface.points[v]).norm(), other};
        if (target.first <= farthest && (!own->second || target < *own->second)) {
          own->second = target;
        }
      }
    }
  }
  double longest = 0;
  std::vector<std::uint8_t> moved(surface.points.size(), 0);
  for (std::size_t v = 0; v < surface.points.size(); ++v) {
    const auto own = targets.find(place_of(surface.points[v]));
    if (own != targets.end() && own->second) {
      const auto& [way, to] = *own->second;
      longest = std::max(longest, way);
      surface.points[v] = Vec3(to[0], to[1], to[2]);
      moved[v] = 1;
    }
  }
  if (longest > 0) {
    const auto representatives = mesh::coincident_representatives(surface.points);
    const auto added = find_faults({surface.points, surface.triangles, representatives},
                                   marked_faces(surface.triangles, moved));
    faults.insert(faults.end(), added.begin(), added.end());
  }
  return longest;
}

}  // namespace dupin::rounding
