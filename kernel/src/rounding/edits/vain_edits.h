#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "dupin/kernel/mesh.h"
#include "rounding/edits/fault_tracker.h"

namespace dupin::rounding {

/// An edit of a mesh that is tried.
struct TriedEdit {
  enum class Kind : std::uint8_t { collapse, flip, move };
  Kind kind = Kind::move;
  std::uint32_t what = 0, how = 0;  ///< points from and to; a face and an edge of it; a point
  Vec3 place = Vec3::Zero();        ///< of a moved point
  friend bool operator==(const TriedEdit&, const TriedEdit&) = default;
};

/// Edits that were refused, and the faults they would have led to. Most are tried again for the
/// next fault of the same triangles, and need no look then.
class VainEdits {
 public:
  /// The faults are of faces as they are after so many edits of the mesh.
  void refuse(const TriedEdit& edit, std::uint64_t edits, std::span<const Fault> faults);

  /// The number of faults that an edit of these faces was refused for, if it would still lead to
  /// them: if none of all their faces has been edited since. Else 0. `last_edit`: per face.
  [[nodiscard]] std::size_t faults_of(const TriedEdit& edit, std::span<const std::uint32_t> faces,
                                      std::span<const std::uint64_t> last_edit) const;

  void clear();

 private:
  struct Hash {
    std::size_t operator()(const TriedEdit& edit) const;
  };
  struct Refusal {
    std::uint64_t edits;
    std::size_t begin, end;  // of faults
  };
  std::unordered_map<TriedEdit, Refusal, Hash> refusals_;
  std::vector<Fault> faults_;
};

}  // namespace dupin::rounding
