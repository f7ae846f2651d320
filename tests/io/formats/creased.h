#pragma once

#include <cstddef>

#include "dupin/kernel/crease.h"

namespace dupin::test {

/// Normals of test::tetrahedron(): its first two triangles are one smooth face, the others another
/// one.
inline CornerNormals creased_normals() {
  const Direction down{0, -0.6F, -0.8F}, up{0.36F, 0.48F, 0.8F};
  return {{down, down, down}, {down, down, down}, {up, up, up}, {up, up, up}};
}

/// All four points of the tetrahedron are on both faces.
inline constexpr std::size_t kCreasedCopies = 4;

}  // namespace dupin::test
