#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <Eigen/Geometry>
#include <gmpxx.h>

#include "dupin/kernel/tiled_check.h"
#include "mesh/point_winding.h"
#include "support/disjoint_sets.h"
#include "support/none.h"

namespace dupin::tiles {

/// What a tile counts of a shell, or all of it.
struct ShellPart {
  std::uint32_t first_face = support::kNone;
  std::size_t triangles = 0;
  std::int64_t euler_number = 0;
  mpq_class volume;
  Eigen::AlignedBox3f box;
  /// The first of the facets that cost least (mesh::ray_cost).
  std::uint32_t test_face = support::kNone;
  double test_cost = std::numeric_limits<double>::infinity();
  Facet test_facet{};
};

void add(const ShellPart& part, ShellPart& shell);

struct JoinedShells {
  std::vector<ShellPart> shells;       ///< in order of first face
  std::vector<std::uint32_t> of_part;  ///< the shell that each part is of
};

/// The parts of shells, numbered as they come.
class ShellParts {
 public:
  std::uint32_t add(ShellPart part);
  void unite(std::uint32_t a, std::uint32_t b) { sets_.unite(a, b); }
  [[nodiscard]] JoinedShells joined() &&;

 private:
  std::vector<ShellPart> parts_;
  support::DisjointSets sets_{0};
};

/// Which shells are around which, as mesh::nesting_depths(), from facets that come in any order.
class ShellDepths {
 public:
  /// The shells share no area and do not cross.
  explicit ShellDepths(std::span<const ShellPart> shells);

  /// Whether no facet is needed.
  [[nodiscard]] bool are_known() const { return points_.empty(); }
  void add(std::uint32_t shell, const Facet& facet);
  /// All facets have been added.
  [[nodiscard]] std::vector<int> depths() const;

 private:
  struct Question {
    std::uint32_t inner, point;
    int winding;  // of the shell about the point
  };

  std::vector<mesh::WindingPoint> points_;
  std::vector<std::vector<Question>> questions_;  // per shell that may be around others
};

}  // namespace dupin::tiles
