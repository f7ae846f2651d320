#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "arrangement/input.h"
#include "dupin/kernel/progress.h"

/// All surfaces cut each other into patches, and the result keeps the patches with the inside of
/// the rule on exactly one side, as in [ZGZJ16]. Points that are not input are implicit: known by
/// the lines and planes they lie on, whose coordinates intervals enclose and exact numbers give
/// where those cannot decide [Att20]. The stages, one file each, in the order of arrange.cpp: 1
/// input (operands in one index space), 2 broad_phase (pairs of triangles whose boxes overlap), 3
/// triangle_intersection, 4 constraints (points and segments on each face and edge), 5 subdivision
/// (outlines of regions, or constrained triangulations), 6 manifold_patches, 7 winding_numbers, 8
/// output_mesh; outlines that are kept are triangulated before that. A face is a
/// triangle of the input, or several that overlap in one plane; sub-triangles are what it falls
/// into. Whatever is said to need UpwardRounding compares intervals.
namespace dupin::arrangement {

/// The boundary of the set that `rule` makes of the operands: one exact arrangement of all their
/// surfaces, each part of them kept where the rule tells its two sides apart.
///
/// Operands are closed and oriented and do not intersect themselves (contacts apart). Deterministic
/// whatever the number of threads. `memory_limit` is in bytes, 0 for the machine's. Throws
/// Error{limit_exceeded | cancelled | boolean_failed}.
[[nodiscard]] mesh::ExactMesh arrange(std::span<const mesh::ExactMesh* const> operands,
                                      const BooleanRule& rule, const Progress& progress = {},
                                      std::uint64_t memory_limit = 0);

/// The same, or nothing if the operands are `crowded` (crowding.h), which a few of them may tell
/// before all are searched.
[[nodiscard]] std::optional<mesh::ExactMesh> arrange_unless_crowded(
    std::span<const mesh::ExactMesh* const> operands, const BooleanRule& rule,
    const Progress& progress = {}, std::uint64_t memory_limit = 0);

/// arrange(), and then what is kept of one triangle merged (piece_merging.h). Two triangles of the
/// operands that have the same source there are pieces of one.
[[nodiscard]] mesh::ExactMesh arrange_and_merge(std::span<const mesh::ExactMesh* const> operands,
                                                const BooleanRule& rule,
                                                const Progress& progress = {},
                                                std::uint64_t memory_limit = 0);

/// The boundary of the points that a surface winds around a positive number of times. It is closed
/// (each edge is run along as often one way as the other) and has no degenerate or duplicate
/// triangles, but may cross and cover itself. Throws like arrange().
[[nodiscard]] mesh::ExactMesh positive_winding_boundary(const mesh::ExactMesh& surface,
                                                        const Progress& progress = {});

/// Triangles of sheets that have no inside on either side, so that nothing is left of them.
struct OutsideSheets {
  std::vector<std::array<Vec3, 3>> triangles;
  std::vector<std::uint32_t> sources;  ///< of each, a triangle of the surface that it is part of
  double error = 0;                    ///< of coordinates, at most
};

struct WoundSurface {
  mesh::ExactMesh boundary;
  OutsideSheets outside;
};

/// The same boundary, and what of the surface is neither on it nor within. `crossing`: 1 per
/// triangle that may meet another one but in common corners and edges.
[[nodiscard]] WoundSurface wound_surface(const mesh::ExactMesh& surface,
                                         std::span<const std::uint8_t> crossing);

/// The boundary of the points that are inside the solid or that the surface, which may cross and
/// cover itself and the solid's, winds around a positive number of times. Contacts of the solid
/// become places where the result touches itself. Throws like arrange().
[[nodiscard]] mesh::ExactMesh united_with_winding(const mesh::ExactMesh& solid,
                                                  const mesh::ExactMesh& surface);

/// Inside any, inside all, inside the first but none of the others.
[[nodiscard]] BooleanRule union_rule(std::size_t operands);
[[nodiscard]] BooleanRule intersection_rule(std::size_t operands);
[[nodiscard]] BooleanRule difference_rule(std::size_t operands);

}  // namespace dupin::arrangement
