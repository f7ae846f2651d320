#pragma once

#include <array>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "verification/piece.h"

namespace dupin::verification {

/// What nothing is known of.
[[nodiscard]] inline IntervalVec everywhere() {
  return {Interval::whole(), Interval::whole(), Interval::whole()};
}

/// The conical rim at the end of a hollow chain, between the circles of both skins.
struct Rim {
  IntervalVec center;  ///< of the inner circle
  Interval radius;
  double beyond = 0;  ///< how far that may lie beyond the outer one's disc, from above
};

/// The disc in which pieces begin or end; everywhere where the numbers do not tell.
struct EndDisc {
  IntervalVec normal, center;
};

/// How the discs on both sides of a joint differ, from above: by an angle in radians, and how far
/// their centres are apart.
struct Step {
  Interval turn, gap;
};

/// Of normals that look the same way.
[[nodiscard]] Step step_between(const EndDisc& before, const EndDisc& after);

/// A part, read exactly: discs for parameters from 0 to the number of its pieces, or a ball. The
/// pieces of a chain with kneecaps meet in balls, of which it has what lies between their discs.
class Solid {
 public:
  /// Throws as AdmittedPart.
  explicit Solid(const CertifiedPart& certified);

  [[nodiscard]] const Sphere* ball() const { return ball_ ? &*ball_ : nullptr; }
  [[nodiscard]] const std::vector<Piece>& pieces() const { return pieces_; }
  [[nodiscard]] bool closed() const { return closed_; }
  [[nodiscard]] double wall() const { return wall_; }
  [[nodiscard]] bool has_kneecaps() const { return has_kneecaps_; }
  /// Of the joints with kneecaps, number i being that of the parameter i + 1.
  [[nodiscard]] const std::vector<Sphere>& knees() const { return knees_; }
  [[nodiscard]] double length() const { return ball_ ? 1 : double(pieces_.size()); }
  /// The part is the union of its discs: it is neither hollow nor elliptic, and has no kneecaps.
  [[nodiscard]] bool is_full() const { return is_full_; }
  /// The piece that has the stretch; none if no single one does.
  [[nodiscard]] const Piece* piece(const ParameterInterval& t) const;
  /// Whether it is a run of several whole pieces, of a chain without kneecaps.
  [[nodiscard]] bool is_run(const ParameterInterval& t) const;
  /// Axis-parallel boxes of the discs of each piece; found when they are first asked for. They are
  /// no work that is limited: a few looks at each piece.
  [[nodiscard]] const std::vector<IntervalVec>& boxes() const;
  /// Of a piece, the diagonal of its box, from above; infinite where the numbers do not tell.
  [[nodiscard]] double size_of_piece(std::size_t i) const;
  /// Where piece i begins; at 0 in a closed chain.
  [[nodiscard]] Step step_at(std::size_t i) const;
  /// The disc at an end, its normal outward.
  [[nodiscard]] EndDisc outward(End end) const;
  /// Of an open end of a hollow chain.
  [[nodiscard]] const std::optional<Rim>& rim(End end) const { return rims_.at(at(end)); }
  /// Of a stretch within one piece, and of the rim if it ends there; none where the numbers do not
  /// tell.
  [[nodiscard]] std::optional<Discs> discs(const ParameterInterval& t) const;

 private:
  std::vector<Piece> pieces_;
  std::optional<Sphere> ball_;
  std::vector<Sphere> knees_;
  double wall_ = 0;
  struct Looks {
    std::once_flag found;
    std::vector<IntervalVec> boxes;
    std::vector<std::array<EndDisc, 2>> ends;  ///< of each piece, in the sense of its parameter
  };
  [[nodiscard]] const Looks& looks() const;
  std::shared_ptr<Looks> looks_ = std::make_shared<Looks>();
  std::array<std::optional<Rim>, 2> rims_;  ///< by end
  bool closed_ = false, is_full_ = true, has_kneecaps_ = false;
};

/// Whether the rims at a joint reach into the other part by at most the tolerance, or are one.
[[nodiscard]] bool have_rims_apart(const std::optional<Rim>& first,
                                   const std::optional<Rim>& second, double tolerance);

/// A ball of which the middle is within a box.
struct PlacedBall {
  IntervalVec center;
  double radius = 0;
};

/// Balls that hold the discs on quarters of a piece, the number i being its place; one that is
/// everywhere where the numbers do not tell.
[[nodiscard]] std::vector<PlacedBall> balls_around_piece(const Solid& solid, double i);

/// The box about a ball of which the middle is within a box.
[[nodiscard]] IntervalVec box_around(const IntervalVec& center, double radius);

/// The hull of boxes; everywhere if there are none.
[[nodiscard]] IntervalVec hull_of(const std::vector<IntervalVec>& boxes);
[[nodiscard]] IntervalVec hull_of(const IntervalVec& a, const IntervalVec& b);

/// The balls of the joints with kneecaps that the stretch touches.
[[nodiscard]] std::vector<Sphere> knees_at(const Solid& solid, const ParameterInterval& t);

/// The stretch by the parameter of its piece.
[[nodiscard]] ParameterInterval within_piece(const ParameterInterval& t);

/// The stretch cut at whole numbers.
[[nodiscard]] std::vector<ParameterInterval> cut(const ParameterInterval& t);

}  // namespace dupin::verification
