#include "healing/shell_lobes.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>

#include "arrangement/arrange.h"

namespace dupin::healing {
namespace {

struct Sides {
  std::vector<std::uint32_t> even, odd;  // copies of one face, by orientation
};

Triangle ascending(Triangle corners) {
  std::ranges::sort(corners);
  return corners;
}

bool is_odd(const Triangle& t) { return ((t[0] > t[1]) != (t[1] > t[2])) != (t[0] > t[2]); }

// A triangle of the result by the soup's points, if it is a whole face.
std::optional<Triangle> whole_face(const mesh::ExactMesh& lobes, std::size_t t,
                                   const PolygonSoup& soup, const Triangle& face) {
  Triangle whole{};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t corner = lobes.triangles[t][k];
    const auto same = std::ranges::find_if(face, [&](std::uint32_t point) {
      return corner < lobes.double_count() && soup.points[point] == lobes.points[corner];
    });
    if (same == face.end()) {
      return std::nullopt;
    }
    whole[k] = *same;
  }
  return whole;
}

}  // namespace

mesh::ExactMesh surface_of(const PolygonSoup& soup, std::span<const std::uint32_t> faces,
                           bool turned) {
  mesh::ExactMesh surface;
  std::unordered_map<std::uint32_t, std::uint32_t> number;
  for (std::uint32_t i = 0; i < faces.size(); ++i) {
    Triangle t = soup.triangles[faces[i]];
    for (std::uint32_t& corner : t) {
      const auto place = number.emplace(corner, static_cast<std::uint32_t>(number.size()));
      if (place.second) {
        surface.points.push_back(soup.points[corner]);
      }
      corner = place.first->second;
    }
    if (turned) {
      std::swap(t[1], t[2]);
    }
    surface.triangles.push_back(t);
    surface.sources.push_back({0, i});
  }
  return surface;
}

std::vector<std::uint32_t> lobe_faces(const PolygonSoup& soup, std::span<const std::uint32_t> faces,
                                      int sign) {
  const mesh::ExactMesh lobes =
      arrangement::positive_winding_boundary(surface_of(soup, faces, sign >= 0));
  std::map<Triangle, Sides> copies;
  if (!lobes.triangles.empty()) {
    for (const std::uint32_t face : faces) {
      const Triangle& t = soup.triangles[face];
      Sides& sides = copies[ascending(t)];
      (is_odd(t) ? sides.odd : sides.even).push_back(face);
    }
  }
  std::vector<std::uint32_t> to_turn;
  for (std::size_t t = 0; t < lobes.triangles.size(); ++t) {
    const auto whole = whole_face(lobes, t, soup, soup.triangles[faces[lobes.sources[t].triangle]]);
    if (!whole) {
      return {};
    }
    Sides& sides = copies[ascending(*whole)];
    auto& of_side = is_odd(*whole) == (sign >= 0) ? sides.even : sides.odd;
    if (of_side.empty()) {
      return {};
    }
    to_turn.push_back(of_side.back());
    of_side.pop_back();
  }
  return to_turn;
}

}  // namespace dupin::healing
