#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include "dupin/kernel/mesh.h"

namespace dupin::bench {

/// A closed pipe about the z axis of `segments` by `rows` quads with capped ends.
inline TriMesh pipe(double radius, double low, double high, std::uint32_t segments,
                    std::uint32_t rows) {
  TriMesh mesh;
  for (std::uint32_t row = 0; row <= rows; ++row) {
    const double height = low + (high - low) * row / rows;
    for (std::uint32_t i = 0; i < segments; ++i) {
      const double angle = 2 * std::numbers::pi * i / segments;
      mesh.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), height);
    }
  }
  for (std::uint32_t row = 0; row < rows; ++row) {
    for (std::uint32_t i = 0; i < segments; ++i) {
      const std::uint32_t a = row * segments + i, b = row * segments + (i + 1) % segments;
      mesh.triangles.push_back({a, b, b + segments});
      mesh.triangles.push_back({a, b + segments, a + segments});
    }
  }
  const std::uint32_t top = rows * segments;
  // In a zigzag: in a fan of n, all n^2 pairs would be neighbours.
  for (std::uint32_t left = 0, right = segments - 1; right - left > 1;) {
    const std::uint32_t next = (left + right) % 2 == (segments - 1) % 2 ? left + 1 : right - 1;
    mesh.triangles.push_back({left, right, next});
    mesh.triangles.push_back({top + left, top + next, top + right});
    (next == left + 1 ? left : right) = next;
  }
  return mesh;
}

}  // namespace dupin::bench
