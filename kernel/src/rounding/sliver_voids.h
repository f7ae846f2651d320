#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "mesh/edge_table.h"
#include "mesh/exact_mesh.h"

namespace dupin::rounding {

/// A solid together with some of its voids.
struct FilledVoids {
  mesh::ExactMesh mesh;
  std::vector<Vec3> places;  ///< a point in each
  double width = 0;          ///< of the widest of them
};

/// The sliver voids of a solid: between two parallel planes that are close to each other. They
/// remain where two parts end in the same ring of points and close it by different triangles,
/// because such a ring is flat only to within rounding. There they touch the outside along edges of
/// the ring, so voids are told apart by what they bound, not by how the triangles are joined.
class SliverVoids {
 public:
  /// Voids wider than `widest` are no slivers. `representatives`: per point the first one in
  /// exactly the same place. The mesh outlives this. O(n log n).
  SliverVoids(const mesh::ExactMesh& mesh, std::span<const std::uint32_t> representatives,
              double widest);

  /// Fills the sliver voids up to a width. None if there are no such. The solid does not touch
  /// itself any more where it did so because of them.
  [[nodiscard]] std::optional<FilledVoids> filled(double width) const;

 private:
  enum class Side { material, free };
  struct Void {
    std::uint32_t cell = 0;
    double width = 0;
  };

  struct Measured {
    double width = 0;     // infinite above the widest
    int volume_sign = 0;  // 0 where balls do not tell it, too
  };

  void pair_around(const std::vector<std::uint32_t>& around, const std::vector<std::uint8_t>& gone,
                   Side side, std::vector<std::uint32_t>& partners) const;
  [[nodiscard]] std::vector<std::uint32_t> partners(const std::vector<std::uint8_t>& gone,
                                                    Side side) const;
  [[nodiscard]] mesh::Shells find_cells() const;
  [[nodiscard]] bool is_void(std::uint32_t cell) const;
  [[nodiscard]] double width_of_void(std::uint32_t cell, double widest) const;
  [[nodiscard]] Measured measure(const Vec3& normal, std::span<const std::uint32_t> faces,
                                 double widest) const;
  [[nodiscard]] std::vector<Void> find_voids(double widest) const;
  [[nodiscard]] mesh::ExactMesh without(const std::vector<std::uint8_t>& gone) const;
  [[nodiscard]] bool tells_sheets_apart(const mesh::ExactMesh& rest,
                                        const std::vector<std::uint8_t>& gone) const;

  const mesh::ExactMesh& mesh_;
  std::vector<Triangle> merged_;  // the triangles with coincident points as one
  mesh::EdgeTable edges_;
  std::map<std::size_t, std::vector<std::uint32_t>> around_;  // edges of more than two triangles
  mesh::Shells cells_;  // triangles that bound one connected part of what the solid leaves free
  std::vector<Void> voids_;
};

}  // namespace dupin::rounding
