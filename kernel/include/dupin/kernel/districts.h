#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "dupin/kernel/check.h"
#include "dupin/kernel/mesh.h"
#include "dupin/kernel/rounding.h"
#include "dupin/kernel/solid.h"

/// A large model falls into districts: things that have nothing to do with each other, because
/// boxes about all of each do not touch. What is made of one does not depend on the others, so that
/// one can be made after the other, in little memory, with the same result.
namespace dupin {

/// For each box the number of its district: boxes that touch are in one. Districts are numbered in
/// the order of their first boxes. Empty boxes touch nothing, infinite ones all. O(n log n) and the
/// pairs that touch. Throws Error{invalid_argument} for bounds that are not numbers.
[[nodiscard]] std::vector<std::uint32_t> districts_of(std::span<const Eigen::AlignedBox3d> boxes);

/// The same, where boxes of these pairs, by their places, lowest first, and pairs ascending, have
/// nothing to do with each other but through others.
[[nodiscard]] std::vector<std::uint32_t> districts_of(
    std::span<const Eigen::AlignedBox3d> boxes,
    std::span<const std::array<std::uint32_t, 2>> apart);

/// Calls visit(i, j) for all pairs of boxes that touch, lowest first, and pairs ascending. O(n log
/// n) and the pairs. Throws as `require_numbers`.
void for_each_touching(std::span<const Eigen::AlignedBox3d> boxes,
                       const std::function<void(std::uint32_t, std::uint32_t)>& visit);

/// Whether each triangle lies in the interiors of the boxes, together, exactly. O(n) where those in
/// the same box follow one another, and few need several. Throws as `require_numbers`.
[[nodiscard]] bool lies_in(const Solid& solid, const Boxes& boxes);
/// The same of the mesh where the solid is, whatever origin was subtracted.
[[nodiscard]] bool lies_in(const Rounded& rounded, const Boxes& boxes);

/// The union of solids, each in boxes of its own which touch none of another's; in its sources, the
/// operands are numbered like them. O(n). Throws Error{invalid_argument} where one does not lie in
/// its boxes, or boxes of two touch.
[[nodiscard]] Solid joined(std::span<const Solid> solids, std::span<const Boxes> boxes);

/// The same of rounded solids, in their order, the report that of all. Throws
/// Error{invalid_argument} also where origins or coordinates differ.
[[nodiscard]] Rounded joined(std::span<const Rounded> all, std::span<const Boxes> boxes);

/// What is said of all, those of the district coming behind the others: coordinates and origin are
/// the district's.
void add(const RoundingReport& district, RoundingReport& all);
/// The same of a check, without its findings.
void add(const Report& district, Report& all);

/// A box about all boxes.
[[nodiscard]] Eigen::AlignedBox3d bounds_of(std::span<const Boxes> boxes);

/// Something straight that can be cut across an axis of coordinates.
struct Cuttable {
  int axis = 0;             ///< 0 to 2
  double from = 0, to = 0;  ///< its ends along that, ascending
  double clear = 0;  ///< so far from its ends it is cut, and from other things where there is room
};

/// Where things may be cut, because nothing else is near there, which is said by boxes along the
/// axes of coordinates. Throws Error{invalid_argument} for numbers that are not finite.
class FreePlaces {
 public:
  using Cuts = std::vector<std::vector<double>>;  ///< by item, ascending

  /// The first of the boxes are about these items, and reach over their ends; none of those that
  /// are not to be cut. O(n log n) and as `for_each_touching`.
  FreePlaces(std::span<const Eigen::AlignedBox3d> boxes,
             const std::vector<std::optional<Cuttable>>& items);

  /// For each plane at a multiple of `distance` that an item runs through, the free place nearest
  /// to it, if that is no further than half of the distance. Planes are the same for all, so that
  /// what is side by side is cut side by side.
  [[nodiscard]] Cuts cuts(double distance) const;
  /// Those that leave least of `size` together, as `largest` says; none if all do. Planes come
  /// closer until that is no more than `most`, the first ones making cells of a box about all.
  [[nodiscard]] Cuts best_cuts(double size, double most,
                               const std::function<double(const Cuts&)>& largest) const;

 private:
  struct Range {
    double from = 0, to = 0;
  };
  struct Item {
    double from = 0, to = 0, clear = 0;
    std::vector<Range> free{};  ///< ascending
  };

  [[nodiscard]] static std::vector<double> cuts_of(const Item& item, double distance);
  std::vector<Item> items_;
  Eigen::AlignedBox3d box_;  // about all of them
};

/// What hangs together and is large is made in pieces. Where two of them end in one ring, each is
/// closed by a disc, or about a bore by an annulus, of the same triangles, turned the other way;
/// joined, they lose both, and what is left is closed. That it is a solid, too, is tested exactly,
/// next to these ends only: nowhere else do boxes about the pieces touch.
///
/// Things, numbered, that come together along these pairs, one after the other, as long as no more
/// than `most` of their weight does; then what is left of little weight, with any other. For each
/// the first of its group. Throws Error{invalid_argument} for weights and pairs of none.
[[nodiscard]] std::vector<std::uint32_t> grouped(
    std::vector<double> weights, std::span<const std::array<std::uint32_t, 2>> pairs, double most);

/// Where two pieces are joined.
struct Seam {
  std::array<std::uint32_t, 2> pieces{};
  std::string name;             ///< the label of the end's triangles, and of no others
  Eigen::AlignedBox3d meeting;  ///< no triangles of both meet outside of it

  friend bool operator==(const Seam& a, const Seam& b) {
    return a.pieces == b.pieces && a.name == b.name && a.meeting.min() == b.meeting.min() &&
           a.meeting.max() == b.meeting.max();
  }
};

/// A closed curve along which a piece is open, once it has lost its end.
struct SeamBorder {
  std::uint32_t shell = 0;   ///< that it bounds, by its place in the piece's report
  std::uint32_t points = 0;  ///< that it has

  friend bool operator==(const SeamBorder&, const SeamBorder&) = default;
};

/// What one of the two pieces has there. Triangles are given by their corners, three by three.
struct SeamSide {
  bool is_end = false;                ///< there is one disc or annulus, of one outer shell
  bool has_others = false;            ///< the piece has outer shells that end at no seam
  std::vector<SeamBorder> borders{};  ///< of both sides in the same order
  std::vector<Vec3> end{};            ///< the triangles, in an order of their own
  std::vector<Vec3> near{};           ///< beside them, what reaches into Seam::meeting

  friend bool operator==(const SeamSide&, const SeamSide&) = default;
};

/// A piece without its ends. Its shells are what hangs together without them. Volumes of those that
/// are open are those of shells that other pieces complete, once all of a whole one are added.
struct OpenPiece {
  std::vector<std::uint32_t> end_faces;  ///< of the mesh, ascending
  std::vector<SeamSide> sides;           ///< by seam
  Report report;
};

/// `mesh` is a solid's, of which the report is, less `origin`; the seams are those of this piece.
/// O(n log n) and the seams.
[[nodiscard]] OpenPiece opened(const TriMesh& mesh, const Vec3& origin, Report report,
                               std::span<const Seam> seams);

/// Whether both sides have the same end, and the triangles beside it meet each other in its borders
/// only, by exact predicates. O(n log n) for n triangles beside it.
[[nodiscard]] bool fit(const SeamSide& one, const SeamSide& other);

/// Two shells of a report that are joined along one border.
struct ShellPair {
  std::array<std::size_t, 2> shells{};  ///< by their places in Report::shells
  std::size_t points = 0;               ///< of the border, which both have counted
};

/// Those of a seam, border by border.
struct SeamShells {
  std::vector<ShellPair> pairs;
  bool has_others = false;  ///< either side
};

/// The places of seams whose pieces, joined, enclose a void, in which there may be other shells of
/// theirs: how deep these lie, reports of pieces do not tell.
[[nodiscard]] std::vector<std::size_t> doubtful(std::span<const SeamShells> seams);

/// The report of all pieces that were opened, one after the other, becomes that of what they are
/// together. None of the seams are doubtful.
void join_shells(std::span<const SeamShells> seams, Report& report);

}  // namespace dupin
