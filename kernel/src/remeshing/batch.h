#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <unordered_set>
#include <vector>

#include "remeshing/working_mesh.h"

namespace dupin::remeshing {

/// An edit that might be made: at an edge, or at a point, where both are the same.
struct Candidate {
  double priority = 0;  ///< the lowest goes first
  std::uint32_t from = 0, to = 0;
};

/// What a candidate takes for itself.
struct Claim {
  std::vector<std::uint32_t> faces;  ///< that it changes
  std::vector<std::uint32_t> needs;  ///< points that no other one may have marked
  std::vector<std::uint32_t> marks;
};

/// One kind of edits.
struct EditKind {
  bool is_at_points = false;  ///< where candidates are looked for, else at faces
  /// Called in parallel.
  std::function<void(std::uint32_t place, std::vector<Candidate>& found)> collect;
  std::function<Claim(const Candidate& candidate)> claim;
  /// The edit of a candidate, if it may be made. Called in parallel.
  std::function<std::optional<Edit>(const Candidate& candidate)> build;
};

/// Makes edits of one kind, as many as can be made side by side. Those that make faces meet others,
/// by exact predicates, are taken back, and not tried again in this pass.
class Pass {
 public:
  explicit Pass(WorkingMesh& mesh) : mesh_(mesh) {}

  /// How many edits were made. Rounds after the first one look where something has changed, or was
  /// claimed by another edit, only.
  std::size_t round(const EditKind& kind);

 private:
  [[nodiscard]] std::vector<Candidate> chosen(const EditKind& kind);
  void look_again_at(const EditKind& kind, const std::vector<Applied>& applied);
  std::size_t undo_faulty(const std::vector<Applied>& applied,
                          const std::vector<Candidate>& candidates);
  void refuse(const Candidate& candidate);
  [[nodiscard]] bool is_refused(const Candidate& candidate) const;

  WorkingMesh& mesh_;
  std::unordered_set<std::uint64_t> refused_;
  std::optional<std::vector<std::uint32_t>> places_;  // of the next round; none: all
  std::vector<std::uint32_t> blocked_;                // places of this one
};

}  // namespace dupin::remeshing
