#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "rounding/edits/edited_mesh.h"

namespace dupin::rounding {

/// Which collapses spoil edges at which the surface touches itself. No two triangles need cross
/// where one sheet passes through another at such an edge: each pair of them meets in it alone.
class ContactEdges {
 public:
  /// `representatives`: per point the first one in its place. Points stay where they are.
  explicit ContactEdges(std::span<const std::uint32_t> representatives);

  /// Whether all such edges are the same once `from` is where `to` is, with faces around that bound
  /// inside and outside in turn. Exact, by the faces around what `from` is connected to.
  [[nodiscard]] bool stay(const EditedMesh& mesh, std::uint32_t from, std::uint32_t to) const;

 private:
  class Surroundings;

  std::vector<std::uint32_t> representatives_;
  std::vector<std::uint8_t> is_shared_;
  std::map<std::uint32_t, std::vector<std::uint32_t>> at_place_;  // of shared places, by the first
};

}  // namespace dupin::rounding
