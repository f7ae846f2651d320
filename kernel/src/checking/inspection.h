#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "dupin/kernel/check.h"
#include "mesh/edge_table.h"
#include "mesh/self_contact.h"

/// What is wrong with a mesh, exactly: the folder behind dupin/kernel/check.h and Solid::from,
/// which asks plain_solid.h first: most meshes have nothing wrong with them, and nobody asks how
/// large they are.
///
/// `inspect` (this file) looks at indices, edges, corners and places in turn, and asks
/// self_intersection.h whether triangles meet where they should not, which is most of the work.
/// There boxes (boxes/box_tree.h) name the pairs that may, exact predicates decide, and three
/// lemmas spare most of the pairs (disjoint_face_groups.h): height field patches, injective stars,
/// and, for solids that have been looked at before, triangles that keep apart while their points
/// move by a margin (mesh/stable_face_groups.h, predicates/stable_predicates.h). Each header states
/// its lemma. What no lemma settles costs time and no truth. docs/robustness.md tells the same as a
/// whole.
namespace dupin::checking {

/// A report with what else was learnt on the way.
struct Inspection {
  Report report;
  std::vector<mesh::ContactPlace> contacts;
  std::vector<std::uint8_t> stable;  ///< see SelfIntersections; of a solid
  /// Of a tile: per triangle its shell, as far as the tile shows it, or support::kNone where
  /// corners repeat.
  std::vector<std::uint32_t> shell_of_face;
};

/// `margin` is that of SelfIntersectionOptions.
[[nodiscard]] Inspection inspect(const TriMesh& mesh, const CheckOptions& options,
                                 double margin = 0);

/// What one tile of a mesh counts of what it shares with others. Its points, all of them in
/// different places, are in the whole's order.
struct TileShare {
  mesh::Counted counted;  ///< of points all triangles are in the tile
  /// Of two triangles that meet.
  std::function<bool(std::uint32_t, std::uint32_t)> counts_pair;
};

/// What a tile adds to the whole's counts, findings and Euler numbers, `shells` being parts of the
/// whole's, of which it knows neither volumes nor depths. The tile has a point.
[[nodiscard]] Inspection inspect_tile(const TriMesh& mesh, const CheckOptions& options,
                                      const TileShare& share);

/// Puts the findings kept of each defect into the report: by defect, then by face.
void append_findings(std::vector<std::vector<Finding>> kept, Report& report);

}  // namespace dupin::checking
