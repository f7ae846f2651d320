#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "dupin/kernel/rounding.h"
#include "mesh/exact_mesh.h"
#include "rounding/edits/fault_tracker.h"

namespace dupin::rounding {

/// What is left of a surface that crossed itself.
struct CutSurface {
  mesh::ExactMesh solid;
  /// How far from it any place of the surface that is not in it may be, at most: sheets that became
  /// one, or turned inside out, are gone.
  double lost = 0;
  std::size_t lost_shells = 0;  ///< of which nothing is left
};

/// The solid that the surface winds around a positive number of times; none if there is nothing, or
/// if something is lost that may be further from it than `most`. Its faces meet in common corners
/// and edges only, but for the `faults`; only these are cut. What is lost is measured from `step`
/// on.
[[nodiscard]] std::optional<CutSurface> without_self_crossings(const TriMesh& surface,
                                                               std::span<const Source> sources,
                                                               std::span<const Fault> faults,
                                                               double step, double most);

}  // namespace dupin::rounding
