#include "tiles/district_voids.h"

#include <algorithm>
#include <utility>

#include "dupin/kernel/connected_components.h"
#include "dupin/kernel/interior_point.h"

namespace dupin::cli {
namespace {

std::array<double, 3> key_of(const Vec3& place) { return {place.x(), place.y(), place.z()}; }

/// The triangles of the shells with these ones, shell by shell.
std::vector<TriMesh> shells_of(const TriMesh& mesh, std::span<const std::uint32_t> faces) {
  const auto components = connected_components(mesh.triangles, mesh.points.size());
  std::map<std::uint32_t, std::size_t> place;  // by component
  for (const std::uint32_t face : faces) {
    place.emplace(components[mesh.triangles[face][0]], place.size());
  }
  std::vector<TriMesh> shells(place.size());
  for (const Triangle& triangle : mesh.triangles) {
    const auto found = place.find(components[triangle[0]]);
    if (found == place.end()) {
      continue;
    }
    TriMesh& shell = shells[found->second];
    const auto first = static_cast<std::uint32_t>(shell.points.size());
    for (const std::uint32_t corner : triangle) {
      shell.points.push_back(mesh.points[corner]);
    }
    shell.triangles.push_back({first, first + 1, first + 2});
  }
  return shells;
}

DistrictVoid void_of(const TriMesh& shell, const Vec3& origin, std::size_t district,
                     const DistrictPlaces& places) {
  DistrictVoid result;
  for (const Vec3& point : shell.points) {
    result.box.extend(Vec3(point + origin));
  }
  result.places = places.in(result.box, district);
  for (const Vec3& place : result.places) {
    // The place may move by a rounding: its district's boxes keep away by more.
    const bool is_within = winding_number(shell, place - origin) != 0;
    result.is_within.push_back(is_within ? 1 : 0);
  }
  return result;
}

}  // namespace

DistrictPlaces::DistrictPlaces(std::span<const Boxes> boxes) {
  for (const Boxes& own : boxes) {
    const bool has_place = !own.empty() && Vec3(own.front().center()).allFinite();
    if (has_place) {
      along_x_.push_back(static_cast<std::uint32_t>(by_district_.size()));
    }
    by_district_.push_back(has_place ? Vec3(own.front().center()) : Vec3(Vec3::Zero()));
  }
  std::ranges::stable_sort(along_x_, {}, [&](std::uint32_t i) { return by_district_[i].x(); });
}

std::vector<Vec3> DistrictPlaces::in(const Eigen::AlignedBox3d& box, std::size_t but_of) const {
  std::vector<Vec3> result;
  const auto x = [&](std::uint32_t i) { return by_district_[i].x(); };
  const auto begin = std::ranges::lower_bound(along_x_, box.min().x(), {}, x);
  for (auto i = begin; i != along_x_.end() && x(*i) <= box.max().x(); ++i) {
    if (*i != but_of && box.contains(by_district_[*i])) {
      result.push_back(by_district_[*i]);
    }
  }
  return result;
}

std::vector<DistrictVoid> voids_of(const Rounded& rounded, const Report& report,
                                   std::size_t district, const DistrictPlaces& places) {
  std::vector<std::uint32_t> faces;  // one of each shell around a void
  for (const ShellReport& shell : report.shells) {
    if (shell.depth % 2 != 0) {
      faces.push_back(shell.first_face);
    }
  }
  std::vector<DistrictVoid> result;
  if (!faces.empty()) {
    for (const TriMesh& shell : shells_of(rounded.mesh(), faces)) {
      result.push_back(void_of(shell, rounded.report().origin, district, places));
    }
  }
  return result;
}

bool are_known(std::span<const DistrictVoid> voids, std::size_t district,
               const DistrictPlaces& places) {
  return std::ranges::all_of(
      voids, [&](const DistrictVoid& own) { return own.places == places.in(own.box, district); });
}

void DistrictDepths::add(std::span<const DistrictVoid> voids) {
  for (const DistrictVoid& own : voids) {
    for (std::size_t i = 0; i < own.places.size(); ++i) {
      voids_[key_of(own.places[i])] += own.is_within[i];
    }
  }
}

// What is in a void, outside of all material, is in as many shells around material.
int DistrictDepths::at(const Vec3& place) const {
  const auto found = voids_.find(key_of(place));
  return found == voids_.end() ? 0 : 2 * found->second;
}

}  // namespace dupin::cli
