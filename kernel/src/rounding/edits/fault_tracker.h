#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "boxes/box_tree.h"
#include "dupin/kernel/mesh.h"
#include "predicates/triangle_overlap.h"
#include "support/bulk_vector.h"

namespace dupin::rounding {

/// A fault of the embedding: two triangles that meet where they should not, or, with first ==
/// second, a degenerate triangle.
struct Fault {
  std::uint32_t first = 0, second = 0;
  friend auto operator<=>(const Fault&, const Fault&) = default;
};

/// A mesh whose triangles should meet in common corners and edges only.
struct Embedding {
  std::span<const Vec3> points;
  std::span<const Triangle> triangles;
  std::span<const std::uint32_t> representatives;  ///< per point the first it may coincide with
  std::span<const std::uint32_t> groups = {};      ///< see SelfIntersectionOptions
};

/// The triangles of faults, as often as they are in one.
[[nodiscard]] std::vector<std::uint32_t> faces_of(std::span<const Fault> faults);

/// The same faults of triangles that have other numbers, in the same order.
[[nodiscard]] std::vector<Fault> renumbered(std::vector<Fault> faults,
                                            std::span<const std::uint32_t> numbers);

[[nodiscard]] bool is_degenerate(const Embedding& mesh, std::uint32_t face);

/// One triangle of a mesh to be tested for faults with others.
class FaultTest {
 public:
  /// The mesh outlives this.
  FaultTest(const Embedding& mesh, std::uint32_t face);
  FaultTest(const FaultTest&) = delete;
  FaultTest& operator=(const FaultTest&) = delete;

  [[nodiscard]] std::uint32_t face() const { return face_; }
  [[nodiscard]] bool is_degenerate() const { return test_.is_degenerate(); }
  /// Whether another one certainly is no fault with the triangle: it meets its plane in nothing but
  /// the points they have in common, since all others lie on one side, and there is one; or there
  /// is a plane between them.
  [[nodiscard]] bool is_apart_from(std::uint32_t other) const {
    const auto& [a, b, c] = mesh_.triangles[face_];
    const Triangle& others = mesh_.triangles[other];
    int side = 0;
    bool shares = false, is_beside = true;
    for (const std::uint32_t v : others) {
      if (v == a || v == b || v == c) {
        shares = true;
      } else if (is_beside) {
        const int here = test_.certain_side(mesh_.points[v]);
        is_beside = here != 0 && here != -side;
        side = here;
      }
    }
    if (shares || is_beside) {
      return is_beside && side != 0;
    }
    const std::span<const Vec3> points = mesh_.points;
    return test_.certainly_apart_from({points[others[0]], points[others[1]], points[others[2]]});
  }
  /// Whether the triangle and another one, none of them degenerate, are a fault.
  [[nodiscard]] bool is_faulty_with(std::uint32_t other);

 private:
  const Embedding& mesh_;
  std::uint32_t face_;
  std::array<Vec3, 6> corners_;  // of the triangle, then of the other one
  predicates::TriangleOverlapTest test_;
};

/// Whether two triangles, none of them degenerate, are a fault.
[[nodiscard]] inline bool is_faulty_pair(const Embedding& mesh, std::uint32_t f, std::uint32_t g) {
  return FaultTest(mesh, f).is_faulty_with(g);
}

/// A mark per triangle: whether it has a marked point.
[[nodiscard]] support::BulkVector<std::uint8_t> marked_faces(
    std::span<const Triangle> triangles, std::span<const std::uint8_t> marked_points);

/// Whether two triangles are looked at. Asked by several threads at once.
using PairFilter = std::function<bool(std::uint32_t, std::uint32_t)>;

/// All faults that involve a marked face, of pairs that pass the filter if there is one. Points
/// with one representative must coincide.
[[nodiscard]] std::vector<Fault> find_faults(const Embedding& mesh,
                                             std::span<const std::uint8_t> marked,
                                             const PairFilter& examined = {});
/// The same; none, and sooner, if so many pairs of triangles are faults.
[[nodiscard]] std::optional<std::vector<Fault>> find_faults_below(
    std::size_t count, const Embedding& mesh, std::span<const std::uint8_t> marked);

/// What an edit must do to the faults that involve the triangles it changes.
enum class FaultRule {
  fewer,  ///< they become fewer
  none,   ///< there are none afterwards
};

/// The faults of a mesh that is edited bit by bit. The mesh is another's: each call is given it as
/// it is now, and which of its triangles are still there.
class FaultTracker {
 public:
  /// `is_part`: the mesh is a part of another one, small, and need not be closed.
  FaultTracker(std::span<const Vec3> points, std::span<const Triangle> triangles, bool is_part);

  /// The mesh as it is now.
  struct Mesh {
    Embedding embedding;
    std::span<const std::uint8_t> alive;  ///< per triangle
  };

  /// Looks for all faults that involve a marked face, a mark per face. The caller knows that there
  /// are no others but those of `known` that involve none.
  void find(const Mesh& mesh, std::span<const std::uint8_t> marked, std::span<const Fault> known);
  /// Those found and not yet removed, and those that edits have made; ascending.
  [[nodiscard]] std::vector<Fault> faults() const;
  [[nodiscard]] static bool is_fault(const Mesh& mesh, const Fault& fault);

  /// Asked before an edit of the faces is made for trial: whether it could be accepted at all.
  [[nodiscard]] bool may_try(const Mesh& mesh, std::span<const std::uint32_t> faces,
                             FaultRule rule);
  /// Decides on it once it has been made: the faces `before` have become the faces `after`, a part
  /// of them. If accepted, the books are brought up to date; else the edit is to be undone.
  [[nodiscard]] bool accept(const Mesh& mesh, std::span<const std::uint32_t> before,
                            std::span<const std::uint32_t> after, FaultRule rule);
  /// Faults after the last edit: if it was refused, not fewer than before.
  [[nodiscard]] std::span<const Fault> found() const { return found_; }
  /// How often that has been asked, or the answer was known.
  [[nodiscard]] std::uint64_t trials() const { return trials_; }
  void count_trial() { ++trials_; }
  /// The number of known faults that involve one of the faces.
  [[nodiscard]] std::size_t count_of(std::span<const std::uint32_t> faces) const {
    return known_of(faces).size();
  }

  /// Forgets the faults of faces that go.
  void remove(std::span<const std::uint32_t> faces);
  /// All points have moved.
  void points_have_moved() { tree_.reset(); }
  /// Adds faults, first < second or equal, that others have found.
  void add(std::span<const Fault> faults);

 private:
  [[nodiscard]] boxes::Box box(const Mesh& mesh, std::uint32_t face) const;
  [[nodiscard]] boxes::FramedTriangle framed(const Mesh& mesh, std::uint32_t face) const;
  boxes::BoxTree& tree(const Mesh& mesh);
  void find_of(const Mesh& mesh, std::uint32_t face, std::span<const std::uint8_t> marked);
  [[nodiscard]] std::vector<Fault> known_of(std::span<const std::uint32_t> faces) const;
  [[nodiscard]] std::vector<std::uint32_t> hot_faces(const Mesh& mesh,
                                                     std::span<const std::uint32_t> before,
                                                     std::span<const Fault> known);
  void find_expected(const Mesh& mesh, std::deque<FaultTest>& tests, std::span<const Fault> known,
                     std::size_t limit);
  void look_everywhere(const Mesh& mesh, std::deque<FaultTest>& tests,
                       const std::vector<std::uint32_t>& hot, std::size_t limit,
                       std::vector<Fault>& found);
  void forget(const Fault& fault);
  void remember(const Fault& fault);

  bool is_part_;
  boxes::BoxQuantizer frame_;
  std::optional<boxes::BoxTree> tree_;                            // once it is asked for
  std::map<std::uint32_t, std::vector<std::uint32_t>> partners_;  // per face, in faults
  // Per face the number of the last search that had looked at it.
  support::BulkVector<std::uint32_t> stamp_;
  std::uint32_t searches_ = 0;
  std::uint64_t trials_ = 0;
  std::vector<Fault> found_;  // after the last edit
  // The faces before the last edit, and others that edits of them in a row were refused for.
  std::vector<std::uint32_t> tried_, suspects_;
};

}  // namespace dupin::rounding
