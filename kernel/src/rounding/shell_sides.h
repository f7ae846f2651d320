#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "dupin/kernel/mesh.h"
#include "rounding/edits/edited_mesh.h"

namespace dupin::rounding {

/// Which collapses turn a shell inside out: those that take faces past all others of it. Neither
/// surface need meet itself for that, as where a tetrahedron's corner goes through the face across.
class ShellSides {
 public:
  /// `shell_of`: per point the first one of its shell.
  explicit ShellSides(std::span<const std::uint32_t> shell_of);

  /// Whether the shell of `from` has the same side inside once `from` is where `to` is; `swept` is
  /// about all faces of `from`. Exact. What lies between these faces and those that replace them is
  /// in the box, so that one point of the shell elsewhere tells: others are seldom looked at.
  [[nodiscard]] bool stay(const EditedMesh& mesh, std::uint32_t from, std::uint32_t to,
                          const Eigen::AlignedBox3d& swept);

 private:
  [[nodiscard]] std::vector<Triangle> triangles_from(const EditedMesh& mesh,
                                                     std::size_t first) const;

  std::vector<std::uint32_t> shell_of_, points_;  // points by shell
  std::vector<std::size_t> first_;  // per shell the place of its first point that is left
};

}  // namespace dupin::rounding
