#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "dupin/kernel/check.h"
#include "dupin/kernel/coordinates.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/mesh.h"
#include "dupin/kernel/solid.h"

namespace dupin {

/// The point that becomes (0, 0, 0) in the file: coordinates near it are finer.
struct Origin {
  enum class Choice {
    keep,       ///< the assembly's own
    automatic,  ///< near the middle of the solid, in round binary numbers
    given,      ///< `place`
  };
  Choice choice = Choice::keep;
  Vec3 place = Vec3::Zero();
};

/// What pieces that are rounded apart are of.
struct Whole {
  Eigen::AlignedBox3d box;  ///< about it
  double largest = 0;       ///< coordinate, seen from the origin, or more; 0: that of the box
};

struct RoundingOptions {
  /// Largest move allowed for repair, in model units; 0 chooses 1024 times the distance between
  /// neighbouring numbers at the largest coordinate in the target format. Only what does not round
  /// cleanly is repaired, with the least of this that does.
  double tolerance = 0;
  /// Rounds to multiples of this power of two where the target format can hold them; 0 for none.
  double output_grid = 0;
  Origin origin;
  /// What the solid is a piece of: the automatic origin, and what the standard tolerance is taken
  /// from, are the whole's, and nothing may be left of the piece. None: the solid is the whole.
  std::optional<Whole> whole = std::nullopt;
  /// Whether an Error{unroundable} says what would do, of all that may, which is found by trying
  /// some; else with_remedies_tried() may do so later.
  bool tries_remedies = true;
};

/// A shell that rounding moves by more than it is thick. Its thickness is twice its volume over its
/// area: that of a plate, or of the wall of an open tube.
struct ThinShell {
  Vec3 place = Vec3::Zero();  ///< a point that moves so far
  double thickness = 0, move = 0;
};

/// How the one rounding went.
struct RoundingReport {
  Coordinates coordinates = Coordinates::binary64;
  Vec3 origin = Vec3::Zero();  ///< was subtracted from all coordinates
  std::size_t moved = 0;       ///< vertices of the solid that are not written where they were
  /// An upper bound, in model units, of how far a vertex moved plus how far flipped edges moved the
  /// surface plus how far from the solid slits were filled plus how far what is gone was from what
  /// is left. Each of the first two has the tolerance for itself: at most twice the tolerance plus
  /// half the distance of neighbouring numbers per coordinate.
  double largest_move = 0;
  double repair_reach = 0;  ///< the part of the tolerance that was needed; 0 without repair
  std::size_t removed_triangles = 0;
  std::size_t removed_shells = 0;  ///< not representable, and no further from what is left
  /// A point in each slit that was filled because rounding breaks it. What faced each other there
  /// is joined. Sliver voids lie between two parallel planes; slits that are open to the outside
  /// are closed by extending one of their flat sides to the other.
  std::vector<Vec3> filled_places;
  /// Of the widest: the distance of the planes, or how far from the solid it was filled.
  double slit_width = 0;
  /// Where, each time that repair came to no end, the surface still crossed itself. It was made the
  /// boundary of what it winds around, and rounded again; pieces may have joined or gone there.
  std::vector<Vec3> snapped_places;
  /// Contacts that parted() ended, and how far a place of the surface moved for it, at most; that
  /// counts in the largest move, too.
  std::vector<Contact> parted;
  double parted_by = 0;
  /// What may not look like what was meant. `move` is a bound for the whole solid where anything
  /// was repaired.
  std::vector<ThinShell> thin_shells;
};

namespace rounding {
class Rounding;
class ContactParting;
}  // namespace rounding

class Rounded;
/// Boxes along the axes, closed.
using Boxes = std::vector<Eigen::AlignedBox3d>;
/// Throws Error{invalid_argument} for bounds that are not numbers.
void require_numbers(std::span<const Eigen::AlignedBox3d> boxes);
/// See dupin/kernel/districts.h.
[[nodiscard]] Rounded joined(std::span<const Rounded> all, std::span<const Boxes> boxes);

/// A mesh that represents a solid by exact tests on its own numbers. Only `to_mesh` makes one, and
/// `joined` of several.
class Rounded {
 public:
  [[nodiscard]] const TriMesh& mesh() const& { return mesh_; }
  [[nodiscard]] TriMesh mesh() && { return std::move(mesh_); }
  /// One per triangle, as in the solid.
  [[nodiscard]] const std::vector<Source>& sources() const { return sources_; }
  /// Where this mesh touches itself, by its own numbers with the origin added: contacts of the
  /// solid may have ended, and rounding may have made others. Points of the mesh are in the same
  /// place at contacts only.
  [[nodiscard]] const std::vector<Contact>& contacts() const { return contacts_; }
  [[nodiscard]] const RoundingReport& report() const { return report_; }

 private:
  friend class rounding::Rounding;
  friend class rounding::ContactParting;
  friend Rounded joined(std::span<const Rounded> all, std::span<const Boxes> boxes);
  Rounded() = default;

  TriMesh mesh_;
  std::vector<Source> sources_;
  std::vector<Contact> contacts_;
  RoundingReport report_;
};

/// The one rounding: exact coordinates to representable ones, such that the mesh, identical
/// vertices merged, is still closed, 2-manifold (contacts apart) and free of self-intersection by
/// exact predicates on the rounded numbers. Every coordinate goes to the nearest number, ties to
/// even; where that breaks the mesh, sliver voids are filled, as between parts that end in one
/// ring and close it by different triangles, slits between ends that nearly meet are closed, short
/// edges collapsed, edges flipped and vertices moved to neighbouring numbers until it is whole.
/// What that does not mend is cut at itself, exactly, and rounded again [snap rounding, iterated].
/// O(n log n), and nearly nothing for solids that need no rounding. Throws Error{unroundable}
/// naming the place and what would help, and Error{invalid_argument} for a tolerance or grid
/// outside its range.
[[nodiscard]] Rounded to_mesh(const Solid& solid, Coordinates coordinates = Coordinates::binary64,
                              const RoundingOptions& options = {});

/// The Error{unroundable} of rounding all these solids with options that try no remedies: which
/// larger tolerance would do, and recentring only if that would. Found by asking of a few such
/// options, each of which takes one more rounding, whether all would be well with them.
[[nodiscard]] Error with_remedies_tried(
    const Error& error, std::span<const Solid> solids, Coordinates coordinates,
    const RoundingOptions& options, const std::function<bool(const RoundingOptions&)>& would_do);

/// Moves apart what touches itself in a rounded solid: points in the same place to neighbouring
/// numbers, as repair does; what that does not mend is cut at itself and rounded again, a few
/// times. For formats whose readers make such points one. `options` are those of the rounding: no
/// place moves further than the rest of its tolerance. The report tells what was parted; the
/// solid stays as it is where that does not do. O(n) and what repair near the contacts takes.
[[nodiscard]] Rounded parted(Rounded touching, const RoundingOptions& options = {});

/// A rounded solid, and the contacts that were ended for it.
struct RoundedApart {
  Rounded rounded;
  double length = 0;  ///< nothing farther from a contact changed
  std::vector<Contact> contacts;
};

/// For formats whose readers make points in the same place one: the solid rounded, apart where it
/// touches itself by as few spacings of the coordinates as it takes, one, two, four to 64, or,
/// where only the rounded solid touches itself, by moves of its points; see separate() and
/// parted(). Where none of that does it still touches itself, and no contacts are told. Throws as
/// to_mesh; with a tolerance that would do, the solid would not touch itself.
[[nodiscard]] RoundedApart rounded_apart(const Solid& solid, Coordinates coordinates,
                                         const RoundingOptions& options = {});

/// Throws Error{unroundable} where nothing is left of what is whole, but was more: of all pieces
/// that were rounded with these options, or of one solid.
void require_something_left(const RoundingReport& report, std::size_t triangles,
                            const RoundingOptions& options);

/// What `check` says of the mesh. That its triangles do not cross is taken from `to_mesh`, which
/// has proved it; that it is closed, a manifold and turned the right way is looked at again. All
/// but O(n).
[[nodiscard]] Report check(const Rounded& rounded);

}  // namespace dupin
