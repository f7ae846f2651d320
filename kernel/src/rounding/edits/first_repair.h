#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "rounding/edits/edit_strategy.h"
#include "rounding/edits/edited_mesh.h"
#include "rounding/edits/mesh_part.h"

namespace dupin::rounding {

/// A surface after a first attempt to repair it.
struct FirstRepair {
  std::optional<MeshPart> part;    ///< that is all the mesh is of, free of faults; or none
  std::optional<EditedMesh> mesh;  ///< never none; refers to the part
  std::size_t removed_shells = 0;
  bool is_ended = true;  ///< false if trying more was not worth it
};

/// Edits around the broken faces. `broken_pairs` are the faults of the mesh that is rounded only.
[[nodiscard]] FirstRepair first_repair(const BrokenMesh& mesh,
                                       const std::vector<std::uint32_t>& broken,
                                       const std::vector<Fault>& broken_pairs,
                                       const RepairLimits& limits);

/// The same in a part of the mesh, if that is small. Where it leaves faults the whole is given,
/// with what the part has become. None if it is not small, or meets the rest. `step` bounds the
/// moves of rounding.
[[nodiscard]] std::optional<FirstRepair> first_repair_in_part(
    const BrokenMesh& whole, const std::vector<std::uint32_t>& broken,
    std::span<const Fault> broken_pairs, const RepairLimits& limits, double step);

}  // namespace dupin::rounding
