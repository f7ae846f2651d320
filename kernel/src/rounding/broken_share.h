#pragma once

#include <cstddef>
#include <span>

#include "dupin/kernel/mesh.h"
#include "rounding/edits/fault_tracker.h"

/// How much of a surface rounding breaks, which tells what to do about it.
namespace dupin::rounding {

/// So many faults are no accident of single points: open slits are looked for before repair.
inline constexpr std::size_t kManyFaults = 256;

/// Whether rounding leaves nothing of so many triangles, and such a part of all, that this is no
/// accident either: what is thinner than a step is thickened first.
[[nodiscard]] bool is_full_of_needles(std::span<const Vec3> on_lattice,
                                      std::span<const Triangle> triangles);

/// A surface, as it was before rounding, and the faults that it has then.
struct FaultySurface {
  std::span<const Vec3> points;
  std::span<const Triangle> triangles;
  std::span<const Fault> faults;
};

/// Whether so much of a rounded surface crosses itself that to cut all of it takes less time than
/// to look at edits, one by one. Not where most of that comes of edges shorter than a step: these
/// are collapsed.
[[nodiscard]] bool is_full_of_crossings(const FaultySurface& surface, double step);

}  // namespace dupin::rounding
