#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "boxes/box_tree.h"
#include "dupin/kernel/mesh.h"
#include "rounding/faults.h"
#include "support/bulk_vector.h"

namespace dupin::rounding {

/// When an edit of a EditedMesh is accepted.
struct EditRule {
  enum class Rule {
    fewer_bad,  ///< bad items that involve the edited triangles become fewer
    none_bad,   ///< no bad item involves the edited triangles afterwards
  };
  Rule rule = Rule::fewer_bad;
  double reach = 0;  ///< largest move of a vertex, and of a surface by flips, since the beginning
};

/// A closed triangle mesh, or a part of one, under edits that keep it a 2-manifold and are accepted
/// only if exact predicates say that its embedding gets better, or stays without fault.
class EditedMesh {
 public:
  /// `classes`: empty, or one number per triangle; triangles of different classes do not lend their
  /// area to each other. `twins`: per point the first of those that may coincide with it
  /// (contacts).
  /// `complete`: empty, or, of a part of a mesh, 1 for points that have all their triangles in it,
  /// else 0. Edits change only triangles all whose corners have a 1.
  EditedMesh(std::span<const Vec3> points, std::span<const Triangle> triangles,
             std::span<const std::uint32_t> classes, std::span<const std::uint32_t> twins,
             std::span<const std::uint8_t> complete = {});

  [[nodiscard]] std::span<const Vec3> points() const { return points_; }
  [[nodiscard]] const Vec3& point(std::uint32_t vertex) const { return points_[vertex]; }
  [[nodiscard]] const Triangle& triangle(std::uint32_t face) const { return triangles_[face]; }
  [[nodiscard]] std::uint32_t face_count() const {
    return static_cast<std::uint32_t>(triangles_.size());
  }
  [[nodiscard]] bool alive(std::uint32_t face) const { return alive_[face] != 0; }
  [[nodiscard]] support::BulkVector<std::uint32_t> alive_faces() const;
  [[nodiscard]] support::BulkVector<Triangle> triangles_of(
      std::span<const std::uint32_t> faces) const;
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
  bool collapse(std::uint32_t from, std::uint32_t to, const EditRule& terms);
  bool flip(std::uint32_t face, int edge, const EditRule& terms);
  bool move(std::uint32_t vertex, const Vec3& position, const EditRule& terms);

  /// Removes whole shells without asking.
  void remove(std::span<const std::uint32_t> faces);

  /// Moves all points without asking.
  void place(support::BulkVector<Vec3> points);

  /// Looks for all bad items that involve a marked face, a mark per face. The caller knows that
  /// there are no others but those of `known` that involve none.
  void find_faults(std::span<const std::uint8_t> marked, std::span<const Fault> known = {});
  /// Those found and not yet removed, and those that edits have made; ascending.
  [[nodiscard]] std::vector<Fault> bad_items() const;
  [[nodiscard]] bool is_bad(const Fault& item) const;

  /// The number of edits tried so far whose effect had to be looked at.
  [[nodiscard]] std::uint64_t trials() const { return trials_; }

  /// The faces edited since the last call that are still there, ascending.
  [[nodiscard]] std::vector<std::uint32_t> take_edited();

 private:
  [[nodiscard]] Embedding embedding() const { return {points_, triangles_, twins_}; }
  [[nodiscard]] bool all_complete(std::span<const std::uint32_t> points) const;
  [[nodiscard]] bool degenerate(std::uint32_t face) const;
  [[nodiscard]] bool bad_pair(std::uint32_t f, std::uint32_t g) const;
  [[nodiscard]] boxes::Box box(std::uint32_t face) const;
  [[nodiscard]] boxes::FramedTriangle framed(std::uint32_t face) const;
  boxes::BoxTree& tree();
  void find_bad_items_of(std::uint32_t face, std::span<const std::uint8_t> marked);
  [[nodiscard]] std::vector<Fault> known_bad(std::span<const std::uint32_t> faces) const;
  [[nodiscard]] bool promising(std::span<const std::uint32_t> faces, const EditRule& terms) const;
  [[nodiscard]] bool settle(std::span<const std::uint32_t> before,
                            std::span<const std::uint32_t> after, const EditRule& terms);
  void look_nearby(std::span<const std::uint32_t> faces, const std::vector<std::uint32_t>& hot,
                   std::size_t limit, std::vector<Fault>& found);
  void look_everywhere(std::span<const std::uint32_t> faces, const std::vector<std::uint32_t>& hot,
                       std::size_t limit, std::vector<Fault>& found);
  void forget(const Fault& item);
  void remember(const Fault& item);
  [[nodiscard]] bool collapsible(std::uint32_t from, std::uint32_t to) const;
  void set_faces(std::uint32_t vertex, std::vector<std::uint32_t> faces);
  void add_face(std::uint32_t vertex, std::uint32_t face);
  void drop_face(std::uint32_t vertex, std::uint32_t face);

  support::BulkVector<Vec3> points_;
  support::BulkVector<Triangle> triangles_;
  std::span<const std::uint32_t> classes_, twins_;
  std::span<const std::uint8_t> complete_;
  support::BulkVector<std::uint8_t> alive_;
  support::BulkVector<std::uint8_t> fixed_;  // points with twins, and neighbours of incomplete ones
  support::BulkVector<std::uint32_t> parent_;
  support::BulkVector<double> reach_, deviation_;
  // Faces around vertices: slices of one array, or, once edited, a list of their own.
  support::BulkVector<std::uint32_t> slice_start_, slices_, own_list_;
  std::vector<std::vector<std::uint32_t>> lists_;
  boxes::BoxQuantizer frame_;
  std::optional<boxes::BoxTree> tree_;
  std::map<std::uint32_t, std::vector<std::uint32_t>> bad_;  // per face its partners in bad items
  std::vector<std::uint32_t> edited_;
  support::BulkVector<std::uint32_t>
      stamp_;  // number of the last search that had looked at the face
  std::uint32_t searches_ = 0;
  std::uint64_t trials_ = 0;
};

}  // namespace dupin::rounding
