#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "dupin/kernel/rounding.h"
#include "mesh/exact_mesh.h"
#include "rounding/edits/fault_tracker.h"

namespace dupin::rounding {

/// A surface cut at itself.
struct CutSurface {
  mesh::ExactMesh solid;              ///< what the surface winds around
  std::vector<std::uint32_t> origin;  ///< per triangle that of the surface which it is a part of
};

/// The solid that the surface winds around a positive number of times; none if there is nothing.
/// Its faces meet in common corners and edges only, but for the `faults`; only these are cut.
[[nodiscard]] std::optional<CutSurface> without_self_crossings(const TriMesh& surface,
                                                               std::span<const Source> sources,
                                                               std::span<const Fault> faults);

/// Whether each shell of the surface is in one piece still, alone or with others: nothing has been
/// cut off, and no void closed.
[[nodiscard]] bool keeps_shells_whole(const TriMesh& surface, const CutSurface& cut);

}  // namespace dupin::rounding
