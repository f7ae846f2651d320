#include "gaps/opposing_faces.h"

#include <vector>

namespace dupin::gaps {
namespace {

using CGAL::Mpzf;

/// (x / w, y / w), w > 0.
struct FlatPoint {
  Mpzf x, y, w;
};
using Polygon = std::vector<FlatPoint>;

int turn(const FlatPoint& a, const FlatPoint& b, const FlatPoint& c) {
  return exact::sign(a.x * (b.y * c.w - c.y * b.w) - a.y * (b.x * c.w - c.x * b.w) +
                     a.w * (b.x * c.y - c.x * b.y));
}

/// Maps a triangle's plane to coordinates that the projection along its normal keeps.
class Projection {
 public:
  explicit Projection(const exact::ExactVector& normal) {
    // Two vectors orthogonal to the normal: those with a zero in place of a coordinate other than
    // `axis`, on which the normal is not zero.
    std::size_t axis = 0;
    while (exact::sign(normal[axis]) == 0) {
      ++axis;
    }
    const std::size_t i = (axis + 1) % 3, j = (axis + 2) % 3;
    first_[i] = normal[axis];
    first_[axis] = -normal[i];
    second_[j] = normal[axis];
    second_[axis] = -normal[j];
  }
  [[nodiscard]] FlatPoint operator()(const exact::ExactVector& p, const Mpzf& w) const {
    return {exact::dot(p, first_), exact::dot(p, second_), w};
  }

 private:
  exact::ExactVector first_, second_;
};

/// The part of `b` on the positive side of a plane, projected; empty unless some of it is strictly
/// on that side.
Polygon part_above(const predicates::ExactTriangle& b, const std::array<Mpzf, 3>& heights,
                   const Projection& projected) {
  Polygon part;
  bool above = false;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const int here = exact::sign(heights[i]), there = exact::sign(heights[j]);
    above = above || here > 0;
    if (here >= 0) {
      part.push_back(projected(b[i], 1));
    }
    if (here * there < 0) {
      const Mpzf drop = here > 0 ? heights[i] - heights[j] : heights[j] - heights[i];
      exact::ExactVector crossing;
      for (std::size_t k = 0; k < 3; ++k) {
        crossing[k] = b[j][k] * heights[i] - b[i][k] * heights[j];
        crossing[k] = here > 0 ? crossing[k] : -crossing[k];
      }
      part.push_back(projected(crossing, drop));
    }
  }
  return above ? part : Polygon{};
}

/// Whether the line through some edge of one convex polygon has all of the other beyond or on it.
bool edge_separates(const Polygon& one, const Polygon& other) {
  for (std::size_t i = 0; i < one.size(); ++i) {
    const FlatPoint &from = one[i], &to = one[(i + 1) % one.size()];
    int inner = 0;
    for (const FlatPoint& p : one) {
      const int side = turn(from, to, p);
      inner = side != 0 ? side : inner;
    }
    bool beyond = true;
    for (const FlatPoint& p : other) {
      beyond = beyond && turn(from, to, p) * inner <= 0;
    }
    if (beyond) {
      return true;
    }
  }
  return false;
}

}  // namespace

bool opposed(const predicates::ExactTriangle& a, const predicates::ExactTriangle& b,
             double cosine) {
  const exact::ExactVector n = exact::cross(a[1] - a[0], a[2] - a[0]),
                           m = exact::cross(b[1] - b[0], b[2] - b[0]);
  const Mpzf along = exact::dot(n, m), limit(cosine);
  return exact::sign(along) < 0 &&
         limit * limit * exact::dot(n, n) * exact::dot(m, m) <= along * along;
}

bool in_front(const predicates::ExactTriangle& a, const predicates::ExactTriangle& b) {
  const exact::ExactVector normal = exact::cross(a[1] - a[0], a[2] - a[0]);
  std::array<Mpzf, 3> heights;
  for (std::size_t i = 0; i < 3; ++i) {
    heights[i] = exact::dot(b[i] - a[0], normal);
  }
  const Projection projected(normal);
  const Polygon part = part_above(b, heights, projected);
  const Polygon base = {projected(a[0], 1), projected(a[1], 1), projected(a[2], 1)};
  return !part.empty() && !edge_separates(base, part) && !edge_separates(part, base);
}

}  // namespace dupin::gaps
