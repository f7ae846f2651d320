#pragma once

#include <optional>
#include <span>

#include "dupin/kernel/rounding.h"
#include "mesh/exact_mesh.h"
#include "rounding/edits/fault_tracker.h"

namespace dupin::rounding {

/// The solid that the surface winds around a positive number of times; none if there is nothing.
/// Its faces meet in common corners and edges only, but for the `faults`; only these are cut.
[[nodiscard]] std::optional<mesh::ExactMesh> without_self_crossings(const TriMesh& surface,
                                                                    std::span<const Source> sources,
                                                                    std::span<const Fault> faults);

}  // namespace dupin::rounding
