#include "predicates/triangle_distance.h"

namespace dupin::predicates {
namespace {

using CGAL::Mpzf;

void lower(Fraction& least, const Fraction& candidate) {
  if (candidate < least) {
    least = candidate;
  }
}

exact::ExactVector normal_of(const ExactTriangle& t) {
  return exact::cross(t[1] - t[0], t[2] - t[0]);
}

/// Whether the point lies in the closed prism over the triangle, along its normal.
bool is_over(const exact::ExactVector& point, const ExactTriangle& t,
             const exact::ExactVector& normal) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (exact::sign(exact::dot(exact::cross(t[(i + 1) % 3] - t[i], point - t[i]), normal)) < 0) {
      return false;
    }
  }
  return true;
}

/// Corners of `a` against the face of `b`, and edges of `a` through it.
void against_face(const ExactTriangle& a, const ExactTriangle& b, Fraction& least) {
  const exact::ExactVector normal = normal_of(b);
  std::array<Mpzf, 3> height;
  for (std::size_t i = 0; i < 3; ++i) {
    height[i] = exact::dot(a[i] - b[0], normal);
    if (is_over(a[i], b, normal)) {
      lower(least, {height[i] * height[i], exact::dot(normal, normal)});
    }
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if (exact::sign(height[i]) * exact::sign(height[j]) >= 0) {
      continue;
    }
    // Each edge of b sees the line through the edge of a turn the same way round, or touches it.
    const exact::ExactVector along = a[j] - a[i];
    int left = 0, right = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const int turn =
          exact::sign(exact::dot(exact::cross(b[k] - a[i], b[(k + 1) % 3] - a[i]), along));
      left += turn > 0 ? 1 : 0;
      right += turn < 0 ? 1 : 0;
    }
    if (left == 0 || right == 0) {
      least = {0, 1};
    }
  }
}

/// A point against the inside of the segment from `from` along `along`.
void against_edge(const exact::ExactVector& point, const exact::ExactVector& from,
                  const exact::ExactVector& along, Fraction& least) {
  const exact::ExactVector d = point - from;
  const Mpzf foot = exact::dot(d, along), length_squared = exact::dot(along, along);
  if (exact::sign(foot) > 0 && foot < length_squared) {
    const exact::ExactVector across = exact::cross(d, along);
    lower(least, {exact::dot(across, across), length_squared});
  }
}

/// Two segments against each other, away from their ends.
void edge_against_edge(const exact::ExactVector& p, const exact::ExactVector& u,
                       const exact::ExactVector& q, const exact::ExactVector& v, Fraction& least) {
  const exact::ExactVector normal = exact::cross(u, v), d = q - p;
  const Mpzf squared = exact::dot(normal, normal);
  if (exact::sign(squared) == 0) {
    return;
  }
  const Mpzf s = exact::dot(exact::cross(d, v), normal), t = exact::dot(exact::cross(d, u), normal);
  if (exact::sign(s) >= 0 && exact::sign(t) >= 0 && s <= squared && t <= squared) {
    const Mpzf height = exact::dot(d, normal);
    lower(least, {height * height, squared});
  }
}

}  // namespace

Fraction squared_distance(const ExactTriangle& a, const ExactTriangle& b) {
  const exact::ExactVector d = b[0] - a[0];
  Fraction least{exact::dot(d, d), 1};
  against_face(a, b, least);
  against_face(b, a, least);
  for (std::size_t i = 0; i < 3; ++i) {
    const exact::ExactVector along_a = a[(i + 1) % 3] - a[i];
    for (std::size_t k = 0; k < 3; ++k) {
      const exact::ExactVector along_b = b[(k + 1) % 3] - b[k], between = b[k] - a[i];
      lower(least, {exact::dot(between, between), 1});
      against_edge(b[k], a[i], along_a, least);
      against_edge(a[i], b[k], along_b, least);
      edge_against_edge(a[i], along_a, b[k], along_b, least);
    }
  }
  return least;
}

}  // namespace dupin::predicates
