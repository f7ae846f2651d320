#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "dupin/kernel/mesh.h"
#include "tessellation/unrolled_face.h"

namespace dupin::tessellation {

/// Makes a corner of the mesh at a place of the unrolled face.
using NewCorner = std::function<std::uint32_t(const Vec2&)>;

/// What lies between two curves about a face's axis, less holes: cut open along a straight line
/// between corners of both or, where the holes leave no way, along such lines from one to another
/// of them and their sides in between. The curves outlive it.
class FaceStrip {
 public:
  FaceStrip(const UnrolledCurve& lower, const UnrolledCurve& upper, double around)
      : lower_(lower), upper_(upper), around_(around) {}

  [[nodiscard]] bool contains(const UnrolledCurve& hole) const;
  void add(const UnrolledCurve& hole) { holes_.push_back(&hole); }

  /// By `refined_region`, of what is so wide at most. Throws Error{self_intersecting} where curves
  /// cross or touch, or one hole lies inside another.
  void append_triangles(std::vector<Triangle>& triangles, const NewCorner& new_corner);

 private:
  [[nodiscard]] std::size_t inner_corner(const UnrolledCurve& hole) const;
  void refuse_nested() const;
  [[nodiscard]] bool is_below(const UnrolledCurve& curve, const Vec2& place) const;
  template <class Visit>
  void for_each_side(const UnrolledCurve& curve, double x, const Visit& visit) const;
  [[nodiscard]] bool is_crossed(const Vec2& from, const Vec2& to) const;
  [[nodiscard]] double clearance_of_holes(double x) const;
  // A hole that the cut passes through, and at which of its corners.
  struct Via {
    const UnrolledCurve* hole;
    std::size_t in, out;
  };
  struct Step {
    std::size_t from, to;
    Vec2 along;
  };
  // Its two sides, the second a turn further on.
  struct CutSides {
    std::vector<std::uint32_t> left, right;
  };

  class OutlineColumns;

  void find_cut();
  [[nodiscard]] bool find_straight_cut();
  [[nodiscard]] bool find_cut_through_holes();
  [[nodiscard]] std::optional<Step> shortest_step(const UnrolledCurve& from,
                                                  const UnrolledCurve& to,
                                                  std::optional<std::size_t> not_from) const;
  Vec2 append_step(const Vec2& from, const Vec2& to, const NewCorner& new_corner, CutSides& sides);
  void append_via(const Via& via, const Vec2& place, CutSides& sides);
  std::uint32_t add_hole_corner(std::uint32_t corner, const Vec2& place);
  [[nodiscard]] double turns_into_outline(const UnrolledCurve& hole,
                                          const OutlineColumns& outline) const;
  std::uint32_t add_corner(std::uint32_t corner, const Vec2& place);
  [[nodiscard]] std::vector<std::uint32_t> once_around(const UnrolledCurve& curve,
                                                       std::size_t first, double x);
  void append_outline(const NewCorner& new_corner);
  void append_hole(const UnrolledCurve& hole, const OutlineColumns& outline);

  const UnrolledCurve &lower_, &upper_;
  double around_;
  std::vector<const UnrolledCurve*> holes_;
  std::array<std::size_t, 2> cut_{};  // its corners of lower and upper
  std::array<Vec2, 2> cut_at_;
  std::vector<Via> via_;
  std::vector<std::uint32_t> corners_;  // what the triangulation's points are
  std::vector<Vec2> places_;
  std::vector<std::vector<std::uint32_t>> polygons_;
  std::multimap<std::uint32_t, std::uint32_t> in_hole_;  // the triangulation's points by corner
};

/// Equally many triangles at both of two rings of equally many corners, the first one's below.
void append_band(const UnrolledCurve& lower, const UnrolledCurve& upper, double around,
                 std::vector<Triangle>& triangles);

}  // namespace dupin::tessellation
