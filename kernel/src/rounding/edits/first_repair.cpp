#include "rounding/edits/first_repair.h"

#include <utility>

#include "rounding/edits/small_shells.h"

namespace dupin::rounding {

FirstRepair first_repair(const BrokenMesh& mesh, const std::vector<std::uint32_t>& broken,
                         const std::vector<Fault>& broken_pairs, const RepairLimits& limits) {
  FirstRepair repair{.part = {}, .mesh = unedited(mesh)};
  repair.removed_shells = remove_small_shells(*repair.mesh, broken, limits.reach);
  repair.is_ended = repair_around(*repair.mesh, mesh, broken, broken_pairs, limits);
  return repair;
}

std::optional<FirstRepair> first_repair_in_part(const BrokenMesh& whole,
                                                const std::vector<std::uint32_t>& broken,
                                                std::span<const Fault> broken_pairs,
                                                const RepairLimits& limits, double step) {
  auto part = MeshPart::around(whole, broken, limits.reach, step);
  if (!part) {
    return std::nullopt;
  }
  FirstRepair repair =
      first_repair(part->view(), part->numbered(broken), part->numbered(broken_pairs), limits);
  if (repair.mesh->faults().empty()) {
    repair.part = std::move(part);
    return repair;
  }
  EditedMesh all = unedited(whole);
  all.place(whole.on_lattice);
  all.take_over(*repair.mesh, part->faces(), part->points());
  if (part->meets_rest(*repair.mesh, {all.points(), all.triangles(), whole.representatives})) {
    return std::nullopt;
  }
  repair.mesh = std::move(all);
  return repair;
}

}  // namespace dupin::rounding
