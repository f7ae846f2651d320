#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "dupin/kernel/mesh.h"
#include "rounding/edits/fault_tracker.h"
#include "rounding/edits/vain_edits.h"
#include "support/bulk_vector.h"

namespace dupin::rounding {

/// When an edit of an EditedMesh is accepted.
struct EditRule {
  FaultRule faults = FaultRule::fewer;
  double reach = 0;  ///< largest move of a vertex, and of a surface by flips, since the beginning
};

/// The corner that is neither a nor b.
[[nodiscard]] std::uint32_t third_corner(const Triangle& triangle, std::uint32_t a,
                                         std::uint32_t b);

/// A closed triangle mesh, or a part of one, under edits that keep it a 2-manifold (collapses by
/// the link condition [DEGN99]) and are accepted only if exact predicates say that its embedding
/// gets better, or stays without fault.
class EditedMesh {
 public:
  /// `labels`: empty, or one number per triangle; triangles of different labels do not lend their
  /// area to each other. `representatives`: per point the first of those that may coincide with it
  /// (contacts).
  /// `complete`: empty, or, of a part of a mesh, 1 for points that have all their triangles in it,
  /// else 0. Edits change only triangles all whose corners have a 1.
  EditedMesh(std::span<const Vec3> points, std::span<const Triangle> triangles,
             std::span<const std::uint32_t> labels, std::span<const std::uint32_t> representatives,
             std::span<const std::uint8_t> complete = {});

  [[nodiscard]] std::span<const Vec3> points() const { return points_; }
  [[nodiscard]] const Vec3& point(std::uint32_t vertex) const { return points_[vertex]; }
  [[nodiscard]] std::span<const Triangle> triangles() const { return triangles_; }
  [[nodiscard]] const Triangle& triangle(std::uint32_t face) const { return triangles_[face]; }
  [[nodiscard]] std::uint32_t face_count() const {
    return static_cast<std::uint32_t>(triangles_.size());
  }
  [[nodiscard]] bool alive(std::uint32_t face) const { return alive_[face] != 0; }
  [[nodiscard]] support::BulkVector<std::uint32_t> alive_faces() const;
  [[nodiscard]] support::BulkVector<Triangle> triangles_of(
      std::span<const std::uint32_t> faces) const;
  /// These faces and the points they have, with the labels of their parents.
  [[nodiscard]] TriMesh mesh_of(std::span<const std::uint32_t> faces) const;
  [[nodiscard]] std::span<const std::uint32_t> faces(std::uint32_t vertex) const;
  /// The face with the directed edge from a to b, if any.
  [[nodiscard]] std::optional<std::uint32_t> face_with_edge(std::uint32_t a, std::uint32_t b) const;
  /// The original triangle whose place and properties the face has.
  [[nodiscard]] std::uint32_t parent(std::uint32_t face) const { return parent_[face]; }
  /// An upper bound of the distance that any vertex merged into `vertex` has moved.
  [[nodiscard]] double reach(std::uint32_t vertex) const { return reach_[vertex]; }
  /// An upper bound of the distance that flips have moved the surface at `face`.
  [[nodiscard]] double deviation(std::uint32_t face) const { return deviation_[face]; }

  /// Each tries one edit and returns whether it was accepted.
  bool collapse(std::uint32_t from, std::uint32_t to, const EditRule& rule);
  bool flip(std::uint32_t face, int edge, const EditRule& rule);
  bool move(std::uint32_t vertex, const Vec3& position, const EditRule& rule);

  /// Removes whole shells without asking.
  void remove(std::span<const std::uint32_t> faces);

  /// Moves all points without asking.
  void place(std::span<const Vec3> points);

  /// Takes over what has become of a part of the mesh, a mesh of its own whose faces and points are
  /// these, ascending, and what faults it is known to have. That part has not been edited here.
  void take_over(const EditedMesh& part, std::span<const std::uint32_t> faces,
                 std::span<const std::uint32_t> points);

  /// Looks for all faults that involve a marked face, a mark per face. The caller knows that there
  /// are no others but those of `known` that involve none.
  void find_faults(std::span<const std::uint8_t> marked, std::span<const Fault> known = {}) {
    tracker_.find(now(), marked, known);
  }
  /// Adds faults that others have found, of faces that have not been edited.
  void add_faults(std::span<const Fault> faults) { tracker_.add(faults); }
  /// Those found and not yet removed, and those that edits have made; ascending.
  [[nodiscard]] std::vector<Fault> faults() const { return tracker_.faults(); }
  /// The same, by the places of their faces in an ascending list that has them all.
  [[nodiscard]] std::vector<Fault> faults_among(std::span<const std::uint32_t> faces) const;
  [[nodiscard]] bool is_fault(const Fault& fault) const {
    return FaultTracker::is_fault(now(), fault);
  }

  /// The number of edits tried so far whose effect had to be looked at.
  [[nodiscard]] std::uint64_t trials() const { return tracker_.trials(); }

  /// The number of edits accepted so far, and the last one of a face, from 1 on; 0 if there is
  /// none.
  [[nodiscard]] std::uint64_t edits() const { return edits_; }
  [[nodiscard]] std::uint64_t last_edit(std::uint32_t face) const { return last_edit_[face]; }

  /// The faces edited since the last call that are still there, ascending.
  [[nodiscard]] std::vector<std::uint32_t> take_edited();

 private:
  [[nodiscard]] FaultTracker::Mesh now() const {
    return {{points_, triangles_, representatives_}, alive_};
  }
  [[nodiscard]] bool all_complete(std::span<const std::uint32_t> points) const;
  [[nodiscard]] bool is_vain(const TriedEdit& edit, std::span<const std::uint32_t> faces,
                             const EditRule& rule);
  [[nodiscard]] bool settle(const TriedEdit& edit, std::span<const std::uint32_t> before,
                            std::span<const std::uint32_t> after, const EditRule& rule);
  [[nodiscard]] bool collapsible(std::uint32_t from, std::uint32_t to) const;
  void set_faces(std::uint32_t vertex, std::vector<std::uint32_t> faces);
  void add_face(std::uint32_t vertex, std::uint32_t face);
  void drop_face(std::uint32_t vertex, std::uint32_t face);

  support::BulkVector<Vec3> points_;
  support::BulkVector<Triangle> triangles_;
  std::span<const std::uint32_t> labels_, representatives_;
  std::span<const std::uint8_t> complete_;
  support::BulkVector<std::uint8_t> alive_;
  static constexpr std::uint8_t kAtContact = 1, kAtBorder = 2;  // or a neighbour of the border
  support::BulkVector<std::uint8_t> fixed_;                     // of points
  support::BulkVector<std::uint32_t> parent_;
  support::BulkVector<double> reach_, deviation_;
  std::uint64_t edits_ = 0;
  support::BulkVector<std::uint64_t> last_edit_;  // of faces
  // Faces around vertices: slices of one array, or, once edited, a list of their own.
  support::BulkVector<std::uint32_t> slice_start_, slices_, own_list_;
  std::vector<std::vector<std::uint32_t>> lists_;
  FaultTracker tracker_;
  VainEdits vain_;
  std::vector<std::uint32_t> edited_;
};

}  // namespace dupin::rounding
