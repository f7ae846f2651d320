#pragma once

#include <cstdint>
#include <vector>

#include "arrangement/constraints.h"
#include "arrangement/input.h"

namespace dupin::arrangement {

/// A triangle of the result.
struct OutputTriangle {
  Triangle corners;
  std::uint32_t support;  ///< a triangle of the input with its plane
  bool reversed;          ///< against the support's orientation
  std::uint32_t source;   ///< a triangle of the input it is part of
};

/// Where the result touches itself.
struct Touch {
  PointId from, to;                  ///< the same for a vertex
  std::vector<std::uint32_t> faces;  ///< indices of the kept triangles that meet there
};

struct VertexDuplicates {
  PointId first_copy = 0;
  std::vector<PointId> copies;  ///< the point that first_copy + i stands for
  std::vector<Touch> touches;   ///< edges and vertices, ascending
};

/// Gives every fan of triangles around a point but the first a copy of the point, so that the
/// surface becomes 2-manifold. At an edge of more than two triangles those that bound the same part
/// of the solid stay together; where copies of its ends do not tell them apart, it is split in the
/// middle, a point added to the input. Needs UpwardRounding.
[[nodiscard]] VertexDuplicates duplicate_non_manifold_vertices(
    ArrangementInput& input, support::BulkVector<OutputTriangle>& kept);

}  // namespace dupin::arrangement
