#pragma once

#include <optional>
#include <string>
#include <vector>

#include "dupin/kernel/error.h"
#include "dupin/kernel/mesh.h"

namespace dupin::test {

/// A mesh that is hard on set operations, by itself or beside the others.
struct NastyShape {
  std::string name;
  TriMesh mesh;
  std::optional<Errc> refused;  ///< what it is refused for, if it is no solid
};

/// Identical, nested and touching ones, slivers, huge and tiny ones, and what is open, crosses
/// itself or is inside out: all about the cube from 0 to 2.
[[nodiscard]] std::vector<NastyShape> nasty_shapes();

}  // namespace dupin::test
