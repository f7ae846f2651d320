#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "arrangement/input.h"

namespace dupin::arrangement {

/// Where on a triangle a point lies: corner 0..2, edge 3..5 (edge 3 + i runs from corner i to the
/// next), or inside.
using Feature = std::uint8_t;
inline constexpr Feature kInside = 6;
[[nodiscard]] constexpr Feature edge_feature(int i) { return static_cast<Feature>(3 + i); }
[[nodiscard]] constexpr bool is_corner(Feature f) { return f < 3; }
[[nodiscard]] constexpr bool is_edge(Feature f) { return f >= 3 && f < kInside; }
/// The edge of a triangle that a feature of it is.
[[nodiscard]] inline EdgeKey edge_of(const Triangle& corners, Feature feature) {
  const std::size_t i = feature - 3u;
  return edge_key(corners[i], corners[(i + 1) % 3]);
}
/// The edge of the triangle on which two features lie, which are not the same corner; or kInside.
[[nodiscard]] Feature common_edge(Feature a, Feature b);

/// What two triangles have in common beyond corners they share.
struct TriangleIntersection {
  enum class Kind : std::uint8_t {
    point,    ///< ends[0]
    segment,  ///< from ends[0] to ends[1]
    overlap,  ///< they are coplanar and have an area in common; its points come as `point`s
  };
  struct End {
    Feature on_first = kInside, on_second = kInside;
    bool first_crosses = true;  ///< the feature of the first ends at the plane of the second
  };
  std::uint32_t first = 0, second = 0;
  Kind kind = Kind::point;
  bool coplanar = false;
  std::uint8_t axis = 0;  ///< of projection, if coplanar
  std::array<End, 2> ends;
};

/// Stage 3: appends what the two triangles have in common, by signs of determinants of
/// input points only [GD03]; exact zeros tell corners and edges from insides. Points that are
/// corners of both are not reported. Needs UpwardRounding.
void intersect(const ArrangementInput& input, std::uint32_t first, std::uint32_t second,
               std::vector<TriangleIntersection>& intersections);
/// The same of triangles that do not lie in one plane; false, and nothing, of those that do.
bool intersect_across(const ArrangementInput& input, std::uint32_t first, std::uint32_t second,
                      std::vector<TriangleIntersection>& intersections);
/// Whether to leave out the point where edges of the first and the second, 0..2, cross.
using LeavesOut = std::function<bool(std::size_t, std::size_t)>;
/// The same of those that do, but for the points that are left out; none if that is empty.
void intersect_in_plane(const ArrangementInput& input, std::uint32_t first, std::uint32_t second,
                        const LeavesOut& leaves_out,
                        std::vector<TriangleIntersection>& intersections);

/// The axis along which the triangle projects to a proper one, the nearest to its normal if
/// rounding lets us see it; and the orientation of the projection.
struct Projection {
  int axis = 0;
  int orientation = 1;
};
[[nodiscard]] Projection projection_of(const PointTable& points, const Triangle& support);

}  // namespace dupin::arrangement
